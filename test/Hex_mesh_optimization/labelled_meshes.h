// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_LABELLED_MESHES_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_LABELLED_MESHES_H

// Meshes of several regions, with internal faces, and of voxels that touch at edges and vertices; damages that leave
// all surfaces as they are.

#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include "mesh_families.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <random>
#include <utility>
#include <vector>

namespace test {

namespace HMO = CGAL::Hex_mesh_optimization;

struct Labelled_mesh : Indexed_mesh
{
  std::vector<int> labels; // of the hexahedra
  std::vector<std::array<int, 4>> internal_faces;

  HMO::internal::Hexahedral_complex regions() const
  {
    std::vector<HMO::internal::Hexahedron> cells;
    for (const auto& h : hexahedra) {
      cells.emplace_back();
      std::copy(h.begin(), h.end(), cells.back().begin());
    }
    return HMO::internal::Hexahedral_complex(points.size(), cells, {labels, internal_faces});
  }

  Point center(std::size_t h) const
  {
    double x = 0, y = 0, z = 0;
    for (std::size_t v : hexahedra[h]) {
      x += points[v].x() / 8;
      y += points[v].y() / 8;
      z += points[v].z() / 8;
    }
    return Point(x, y, z);
  }

  template <class Label>
  void label(const Label& label_at)
  {
    labels.clear();
    for (std::size_t h = 0; h < hexahedra.size(); ++h)
      labels.push_back(label_at(center(h)));
  }

  template <class Map>
  void bend(const Map& map)
  {
    for (Point& p : points)
      p = map(p);
  }
};

// Unit cubes at lattice positions, each divided into n³ hexahedra.
template <class Is_there>
void make_voxels(Labelled_mesh& mesh, int nx, int ny, int nz, int n, const Is_there& is_there)
{
  std::vector<HMO::internal::Lattice_hexahedron> lattice;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        if (is_there(i, j, k))
          HMO::internal::append_lattice_box(n * i, n * j, n * k, n, n, n, lattice);
  HMO::internal::build_lattice_mesh(
    lattice,
    [&](const HMO::internal::Lattice_node& node) {
      return std::array<double, 3>{{double(node[1]) / n, double(node[2]) / n, double(node[3]) / n}};
    },
    mesh.points, mesh.hexahedra);
}

// A ball of radius .5 with the label 1 in a cube [-1, 1]³ with the label 2: a ball whose outermost shells are drawn out
// to the cube.
inline Labelled_mesh ball_in_a_block(std::size_t n = 4)
{
  Labelled_mesh mesh;
  HMO::make_ball(mesh.points, mesh.hexahedra, n);
  const std::size_t ball = mesh.hexahedra.size(), shells = n / 2;
  // shell s of the block: over the quads of the sphere
  const auto faces = mesh.complex().boundary_faces;
  std::vector<std::vector<std::size_t>> number(shells + 1, std::vector<std::size_t>(mesh.points.size()));
  const std::size_t count = mesh.points.size();
  for (std::size_t v = 0; v < count; ++v)
    number[0][v] = v;
  std::vector<char> is_on_sphere(count, false);
  for (const auto& f : faces)
    for (int v : f.vertices)
      is_on_sphere[v] = true;
  for (std::size_t s = 1; s <= shells; ++s)
    for (std::size_t v = 0; v < count; ++v)
      if (is_on_sphere[v]) {
        const Indexed_mesh::Point p = mesh.points[v];
        const double a[3] = {std::abs(p.x()), std::abs(p.y()), std::abs(p.z())};
        const double scale = 1 / (std::max)(a[0], (std::max)(a[1], a[2])), t = double(s) / double(shells);
        number[s][v] = mesh.points.size();
        const double factor = (1 - t) + 2 * t * scale; // all of this is divided by two below
        mesh.points.emplace_back(factor * p.x(), factor * p.y(), factor * p.z());
      }
  for (std::size_t s = 0; s < shells; ++s)
    for (const auto& f : faces) {
      std::array<std::size_t, 8> h;
      for (int k = 0; k < 4; ++k) {
        h[k] = number[s][f.vertices[k]];
        h[k + 4] = number[s + 1][f.vertices[k]];
      }
      mesh.hexahedra.push_back(h);
    }
  mesh.bend([](const Indexed_mesh::Point& p) { return Indexed_mesh::Point(p.x() / 2, p.y() / 2, p.z() / 2); });
  mesh.labels.assign(ball, 1);
  mesh.labels.resize(mesh.hexahedra.size(), 2);
  return mesh;
}

// Three layers with the labels 3, 1, 3, two cells thick each, between waves.
inline Labelled_mesh layered_plate()
{
  Labelled_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{7, 6, 6}}, {{7, 6, 6}});
  mesh.label([](const Indexed_mesh::Point& p) { return p.z() > 2 && p.z() < 4 ? 1 : 3; });
  mesh.bend([](const Indexed_mesh::Point& p) {
    return Indexed_mesh::Point(p.x(), p.y(), p.z() + .4 * std::sin(.9 * p.x()) * std::cos(.5 * p.y()));
  });
  return mesh;
}

// One across the other.
inline Labelled_mesh two_touching_bars()
{
  Labelled_mesh mesh;
  make_voxels(mesh, 3, 3, 2, 3, [](int i, int j, int k) { return k == 0 ? j == 1 : i == 1; });
  mesh.label([](const Indexed_mesh::Point& p) { return p.z() < 1 ? 10 : 20; });
  return mesh;
}

// A half and two quarters, around an axis that winds.
inline Labelled_mesh three_regions_around_a_curve()
{
  Labelled_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{6, 6, 6}}, {{6, 6, 6}});
  mesh.label([](const Indexed_mesh::Point& p) { return p.x() < 3 ? 0 : p.y() < 3 ? 1 : 2; });
  mesh.bend([](const Indexed_mesh::Point& p) {
    return Indexed_mesh::Point(p.x() + .5 * std::sin(.8 * p.z()), p.y() + .5 * std::cos(.8 * p.z()), p.z());
  });
  return mesh;
}

struct Labelled_family
{
  const char* name;
  Labelled_mesh (*make)();
};

inline std::ostream& operator<<(std::ostream& os, const Labelled_family& family) { return os << family.name; }

inline const std::vector<Labelled_family>& labelled_families()
{
  static const std::vector<Labelled_family> families = {{"ball_in_a_block", [] { return ball_in_a_block(); }},
                                                        {"layered_plate", layered_plate},
                                                        {"two_touching_bars", two_touching_bars},
                                                        {"three_regions_around_a_curve", three_regions_around_a_curve}};
  return families;
}

// A block with a wall within, from one side to its middle.
inline Labelled_mesh block_with_a_baffle()
{
  Labelled_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{6, 6, 4}}, {{6, 6, 4}});
  const auto complex = mesh.complex();
  for (const auto& sides : complex.interior_faces) {
    const auto& h = complex.hexahedra[sides[0].first];
    const auto& f = HMO::internal::hexahedron_faces[sides[0].second];
    const std::array<int, 4> q{h[f[0]], h[f[1]], h[f[2]], h[f[3]]};
    bool is_in_wall = true;
    for (int v : q)
      is_in_wall = is_in_wall && mesh.points[v].x() == 3 && mesh.points[v].y() <= 3;
    if (is_in_wall)
      mesh.internal_faces.push_back(q);
  }
  mesh.bend(
    [](const Indexed_mesh::Point& p) { return Indexed_mesh::Point(p.x() + .4 * std::sin(p.y()), p.y(), p.z()); });
  return mesh;
}

// Random voxels, of which many touch at edges and vertices.
inline Labelled_mesh random_voxels(unsigned seed, double density = .45)
{
  Labelled_mesh mesh;
  std::mt19937 random(seed);
  std::vector<char> is_there(27);
  do
    for (char& c : is_there)
      c = random() < density * 4294967296.;
  while (std::count(is_there.begin(), is_there.end(), char(true)) < 4);
  make_voxels(mesh, 3, 3, 3, 3, [&](int i, int j, int k) { return is_there[i + 3 * (j + 3 * k)]; });
  return mesh;
}

// Moves every vertex that is on no surface, by up to so many mean edge lengths along each axis.
inline void scramble_within_regions(Labelled_mesh& mesh, unsigned seed, double edges)
{
  std::mt19937 random(seed);
  const double size = edges * mesh.mean_edge_length();
  const auto step = [&] { return size * (random() / 2147483648. - 1); };
  const auto is_on_boundary = mesh.regions().is_on_boundary;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (!is_on_boundary[v]) {
      const double x = step(), y = step(), z = step();
      const Indexed_mesh::Point p = mesh.points[v];
      mesh.points[v] = Indexed_mesh::Point(p.x() + x, p.y() + y, p.z() + z);
    }
}

// Of the trilinear maps of the hexahedra with each label, where none is folded, by six pyramids over bilinear faces.
inline double volume_of_label(const Labelled_mesh& mesh, int label)
{
  double sum = 0;
  const auto complex = mesh.regions();
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
    if (complex.label(int(h)) == label)
      for (const auto& f : HMO::internal::hexahedron_faces) {
        Indexed_mesh::Kernel::Vector_3 q[4];
        for (int k = 0; k < 4; ++k)
          q[k] = mesh.points[mesh.hexahedra[h][f[k]]] - mesh.center(h);
        // the mean of both splits into triangles is the bilinear face
        const auto det = [&](int a, int b, int c) { return CGAL::determinant(q[a], q[b], q[c]) / 12; };
        sum += det(0, 1, 2) + det(0, 2, 3) + det(0, 1, 3) + det(1, 2, 3);
      }
  return sum;
}

} // namespace test

using namespace test;

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_LABELLED_MESHES_H
