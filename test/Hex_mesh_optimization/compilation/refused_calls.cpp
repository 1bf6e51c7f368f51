// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls with types that do not fit. The compiler names what is missing, once for each, and nothing else.

#include <CGAL/Hex_mesh_optimization/pad_hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/voxel_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_hex_mesh.h>
#include <CGAL/optimize_hex_mesh.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace params = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using Hexahedra = std::vector<std::array<std::size_t, 8>>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

struct Wrong_visitor
{
  void on_iteration(int) {}
};

struct Surface_of_cells // as a linear cell complex of dimension 2 is
{
  using Dart_range = int;
  using Vertex_attribute_range = int;
  using Dart_const_handle = int*;
  using Dart_const_descriptor = int*;
  using Vertex_attribute_handle = int*;
  using Vertex_attribute_descriptor = int*;
  static constexpr unsigned int dimension = 2, ambient_dimension = 3;
};

void call(Points& points, Hexahedra& hexahedra, const Surface& surface)
{
  std::vector<Kernel::Point_2> flat;
  CGAL::optimize_hex_mesh(flat, hexahedra); // error: points whose x(), y() and z() CGAL::to_double() converts
  std::vector<std::vector<std::string>> words;
  CGAL::optimize_hex_mesh(points, words); // error: the hexahedra must be a range with size() of ranges of eight integers
  const Points constant;
  CGAL::optimize_hex_mesh(constant, hexahedra); // error: the points must not be const
  Surface_of_cells cells;
  CGAL::optimize_hex_mesh(cells); // error: dimension 3 and ambient dimension 3

  const std::vector<bool> flags;
  CGAL::optimize_hex_mesh(points, hexahedra, params::vertex_is_constrained_map(flags)); // error: vertex_is_constrained_map() needs
  CGAL::optimize_hex_mesh(points, hexahedra, params::hexahedron_label_map(flags)); // error: hexahedron_label_map() needs
  CGAL::optimize_hex_mesh(points, hexahedra, params::target_edge_length_map(1.)); // error: target_edge_length_map() needs
  CGAL::optimize_hex_mesh(points, hexahedra, params::internal_faces(flags)); // error: internal_faces() needs
  CGAL::optimize_hex_mesh(points, hexahedra, params::facet_is_constrained_map(flags)); // error: facet_is_constrained_map() needs
  CGAL::optimize_hex_mesh(points, hexahedra, params::interface_references(flags)); // error: interface_references() needs
  CGAL::optimize_hex_mesh(points, hexahedra, params::periodic_vertices(flags)); // error: periodic_vertices() needs
  CGAL::optimize_hex_mesh(points, hexahedra, params::visitor(Wrong_visitor())); // error: bool on_iteration(const CGAL::

  // Parameters of the reference, without one and in the list of the mesh; those of the mesh in the list of the reference
  CGAL::optimize_hex_mesh(points, hexahedra, params::edge_is_constrained_map(flags)); // error: edge_is_constrained_map() describe
  CGAL::optimize_hex_mesh(points, hexahedra, surface, params::vertex_point_map(surface.points())); // error: vertex_point_map() and
  CGAL::optimize_hex_mesh(points, hexahedra, surface, params::default_values(), params::verbose(true)); // error: all others belong in
  CGAL::optimize_hex_mesh(points, hexahedra, points, std::vector<std::array<int, 3>>(), params::default_values(),
                          params::features_angle_bound(30)); // error: for a triangle soup only

  // References
  CGAL::optimize_hex_mesh(points, hexahedra, points); // error: the surface must be a model of FaceListGraph
  CGAL::optimize_hex_mesh(points, hexahedra, points, flat); // error: triangles of a triangle soup must be a range of ranges
  CGAL::optimize_hex_mesh(points, hexahedra, surface, params::default_values(),
                          params::edge_is_constrained_map(flags)); // error: whose key is an edge descriptor of the triangle mesh

  // Meshes that are made
  CGAL::make_hex_mesh(surface, points, hexahedra, params::vertex_is_constrained_map(flags)); // error: need a mesh that exists
  std::vector<std::string> text;
  CGAL::voxel_mesh(surface, 1., text, hexahedra); // error: of points that can be constructed from three double
}
