// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_SURFACE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads a surface, to be used as the reference of a hexahedral mesh, as a triangle mesh.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Legacy_vtk_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Medit_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Off_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Ply_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Vtu_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/extension_of.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/triangulated.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

inline Mesh_file_content read_content(const std::string& filename, const std::string& extension)
{
  if (extension == "off")
    return Off_reader(filename).read();
  if (extension == "ply")
    return Ply_reader(filename).read();
  if (extension == "mesh")
    return Medit_reader(filename, Wanted_cells::POLYGONS).read();
  if (extension == "vtk")
    return Legacy_vtk_reader(filename, Wanted_cells::POLYGONS).read();
  if (extension == "vtu")
    return Vtu_reader(filename, Wanted_cells::POLYGONS).read();
  throw CGAL::IO::Hex_mesh_file_error(
    filename, 0, "the format is unknown: the name must end in .off, .obj, .stl, .ply, .mesh, .vtk or .vtu");
}

// The polygons of a mesh file that are no faces between two of its hexahedra: its surface. If there are none, the faces of
// one hexahedron.
inline std::vector<std::vector<std::size_t>> outer_polygons(const Mesh_file_content& content)
{
  std::map<std::vector<std::size_t>, std::pair<int, std::vector<std::size_t>>> faces; // hexahedra, vertices in order
  const auto sorted = [](std::vector<std::size_t> polygon) {
    std::sort(polygon.begin(), polygon.end());
    return polygon;
  };
  constexpr int sides[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (const std::array<std::size_t, 8>& h : content.hexahedra)
    for (const int(&side)[4] : sides) {
      std::vector<std::size_t> face{h[side[0]], h[side[1]], h[side[2]], h[side[3]]};
      auto& [count, vertices] = faces[sorted(face)];
      ++count;
      vertices = std::move(face);
    }
  std::vector<std::vector<std::size_t>> result;
  for (const std::vector<std::size_t>& polygon : content.polygons) {
    const auto face = faces.find(sorted(polygon));
    if (face == faces.end() || face->second.first == 1)
      result.push_back(polygon);
  }
  if (result.empty())
    for (const auto& [key, face] : faces)
      if (face.first == 1)
        result.push_back(face.second);
  return result;
}

template <class Point>
void read_polygons(const std::string& filename, std::vector<Point>& points,
                   std::vector<std::vector<std::size_t>>& polygons)
{
  const std::string extension = extension_of(filename);
  if (extension != "obj" && extension != "stl") {
    Mesh_file_content content = read_content(filename, extension);
    copy_points(content.points, points);
    polygons = outer_polygons(content);
    return;
  }
  if (!std::ifstream(filename))
    throw CGAL::IO::Hex_mesh_file_error(filename, 0, "cannot open the file for reading");
  bool success = false;
  try {
    success = CGAL::IO::read_polygon_soup(filename, points, polygons);
  }
  catch (const std::exception&) // as a number of vertices that no memory can hold
  {
  }
  if (!success)
    throw CGAL::IO::Hex_mesh_file_error(filename, 0, "it cannot be read as a surface in ." + extension + " format");
}

// Polygons with three different vertices at least; throws Hex_mesh_file_error unless all of a file is usable.
template <class Point>
void read_usable_polygons(const std::string& filename, std::vector<Point>& points,
                          std::vector<std::vector<std::size_t>>& polygons)
{
  using CGAL::IO::Hex_mesh_file_error;
  read_polygons(filename, points, polygons);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const double x : coordinates(points[i]))
      if (!std::isfinite(x))
        throw Hex_mesh_file_error(filename, 0, "point " + std::to_string(i) + " has a coordinate that is not finite");
  for (std::size_t i = 0; i < polygons.size(); ++i)
    for (const std::size_t v : polygons[i])
      if (v >= points.size())
        throw Hex_mesh_file_error(filename, 0,
                                  "polygon " + std::to_string(i) + " refers to point " + std::to_string(v) +
                                    ", there are " + std::to_string(points.size()) + " points");
  if (extension_of(filename) == "stl")
    Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup(points, polygons);
  for (std::vector<std::size_t>& polygon : polygons) {
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    while (polygon.size() > 1 && polygon.front() == polygon.back())
      polygon.pop_back();
  }
  polygons.erase(std::remove_if(polygons.begin(), polygons.end(),
                                [](std::vector<std::size_t> polygon) {
                                  std::sort(polygon.begin(), polygon.end());
                                  return polygon.size() < 3 ||
                                         std::adjacent_find(polygon.begin(), polygon.end()) != polygon.end();
                                }),
                 polygons.end());
  if (polygons.empty())
    throw Hex_mesh_file_error(filename, 0, "the surface has no polygons");
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

namespace CGAL::IO {

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * reads a surface from a file in the format told by the extension of its name, in upper or lower case: `.off`, `.obj`,
 * `.stl`, `.ply`, or the triangles and quadrilaterals of a `.mesh`, `.vtk` (unstructured grid or polygonal data) or
 * `.vtu` file.
 *
 * Of a file with hexahedra, faces between two of them are no part of its surface; if there are no others, it is the faces of
 * one hexahedron each.
 *
 * Polygons are triangulated and oriented consistently; where more than two meet in an edge, or several sheets in a
 * vertex, the surface is taken apart. Equal points are merged for `.stl` only, the format that has no other
 * way to connect triangles. Polygons with less than three different vertices and points of no polygon are dropped.
 *
 * \tparam TriangleMesh a model of `MutableFaceGraph` with an internal point property
 *
 * \param filename the name of the file
 * \param tmesh the triangle mesh, cleared first
 *
 * \throws Hex_mesh_file_error if the file cannot be read, has a coordinate that is not finite, an index out of range,
 *         or no polygons. `tmesh` is unchanged then.
 */
template <class TriangleMesh>
void read_surface(const std::string& filename, TriangleMesh& tmesh)
{
  namespace PMP = Polygon_mesh_processing;
  namespace io = Hex_mesh_optimization::internal::IO;
  using Point =
    typename boost::property_traits<typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::type>::value_type;

  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  io::read_usable_polygons(filename, points, polygons);
  PMP::remove_isolated_points_in_polygon_soup(points, polygons);
  polygons = io::triangulated(points, std::move(polygons));
  PMP::orient_polygon_soup(points, polygons);
  if (!PMP::is_polygon_soup_a_polygon_mesh(polygons))
    throw Hex_mesh_file_error(filename, 0, "the polygons do not form a surface");
  TriangleMesh result;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, result);
  tmesh = std::move(result);
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * reads a surface as the triangles that the file has, whatever they are together: nothing is oriented, taken apart or, but
 * equal points of `.stl`, merged. Polygons are triangulated.
 *
 * \tparam Point a model of `HexMeshOptimizationPoint_3`
 *
 * \throws Hex_mesh_file_error as `read_surface()`
 */
template <class Point>
void read_triangle_soup(const std::string& filename, std::vector<Point>& points,
                        std::vector<std::array<std::size_t, 3>>& triangles)
{
  namespace io = Hex_mesh_optimization::internal::IO;
  std::vector<Point> new_points;
  std::vector<std::vector<std::size_t>> polygons;
  io::read_usable_polygons(filename, new_points, polygons);
  polygons = io::triangulated(new_points, std::move(polygons));
  std::vector<std::array<std::size_t, 3>> new_triangles;
  for (const std::vector<std::size_t>& p : polygons)
    new_triangles.push_back({p[0], p[1], p[2]});
  points = std::move(new_points);
  triangles = std::move(new_triangles);
}

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_SURFACE_H
