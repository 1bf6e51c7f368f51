// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_MESH_FAMILIES_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_MESH_FAMILIES_H

// One small mesh of every generated family, in index form, and the surfaces of
// such meshes as reference.

#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <vector>

struct Indexed_mesh
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;

  std::vector<Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;

  CGAL::Hex_mesh_optimization::internal::Hexahedral_complex complex() const
  {
    return CGAL::Hex_mesh_optimization::internal::hexahedral_complex(points.size(), hexahedra);
  }

  double mean_edge_length() const
  {
    const auto edges = complex().edges;
    double sum = 0;
    for (const auto& e : edges)
      sum += CGAL::Hex_mesh_optimization::internal::edge_length(points, e);
    return sum / double(edges.size());
  }
};

struct Mesh_family
{
  const char* name;
  void (*make)(Indexed_mesh&);

  Indexed_mesh operator()() const
  {
    Indexed_mesh mesh;
    make(mesh);
    return mesh;
  }
};

inline std::ostream& operator<<(std::ostream& os, const Mesh_family& family) { return os << family.name; }

inline const std::vector<Mesh_family>& mesh_families()
{
  namespace HMO = CGAL::Hex_mesh_optimization;
  static const std::vector<Mesh_family> families = {
    {"block",
     [](Indexed_mesh& m) {
       HMO::make_block(m.points, m.hexahedra, {{4, 3, 5}}, {{4, 3, 5}});
     }},
    {"graded_block",
     [](Indexed_mesh& m) {
       HMO::make_block(m.points, m.hexahedra, {{4, 4, 4}}, {{1, 1, 1}}, {{1, 2, 3}});
     }},
    {"bar", [](Indexed_mesh& m) { HMO::make_bent_bar(m.points, m.hexahedra, 8, 3); }},
    {"twisted_bar", [](Indexed_mesh& m) { HMO::make_bent_bar(m.points, m.hexahedra, 8, 3, 4, 1, 1, 1); }},
    {"cylinder", [](Indexed_mesh& m) { HMO::make_cylinder(m.points, m.hexahedra, 3, 4); }},
    {"ball", [](Indexed_mesh& m) { HMO::make_ball(m.points, m.hexahedra, 3); }},
    {"plate_with_hole", [](Indexed_mesh& m) { HMO::make_plate_with_hole(m.points, m.hexahedra, 3, 3, 4, 1, 1.5); }},
    {"l_shape", [](Indexed_mesh& m) { HMO::make_l_shape(m.points, m.hexahedra, 3); }},
    {"t_shape", [](Indexed_mesh& m) { HMO::make_t_shape(m.points, m.hexahedra, 3); }},
    {"ring", [](Indexed_mesh& m) { HMO::make_ring(m.points, m.hexahedra, 14, 3); }}};
  return families;
}

// The name of a test over families
struct Family_name
{
  template <class Info>
  std::string operator()(const Info& info) const
  {
    return info.param.name;
  }
};

inline Indexed_mesh sheared(Indexed_mesh mesh, double slope)
{
  for (Indexed_mesh::Point& p : mesh.points)
    p = Indexed_mesh::Point(p.x() + slope * p.z(), p.y(), p.z());
  return mesh;
}

inline CGAL::Hex_mesh_optimization::internal::Positions positions(const Indexed_mesh& mesh)
{
  CGAL::Hex_mesh_optimization::internal::Positions points;
  for (const auto& p : mesh.points)
    points.emplace_back(p.x(), p.y(), p.z());
  return points;
}

// Builds the boundary of a mesh, each quad split from its second corner, through
// add_vertex(point) and add_triangle(v, v, v), which take what add_vertex returns.
template <class Add_vertex, class Add_triangle>
void for_boundary(const Indexed_mesh& mesh, const Add_vertex& add_vertex, const Add_triangle& add_triangle)
{
  using Vertex = decltype(add_vertex(mesh.points[0]));
  std::map<int, Vertex> number;
  const auto faces = mesh.complex().boundary_faces;
  for (const auto& face : faces)
    for (int v : face.vertices)
      if (number.find(v) == number.end())
        number.emplace(v, add_vertex(mesh.points[v]));
  for (const auto& face : faces) {
    const std::array<int, 4>& q = face.vertices;
    add_triangle(number.at(q[1]), number.at(q[2]), number.at(q[3]));
    add_triangle(number.at(q[1]), number.at(q[3]), number.at(q[0]));
  }
}

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_MESH_FAMILIES_H
