// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_BOUNDARY_PATCHES_H
#define CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_BOUNDARY_PATCHES_H

// The smooth patches of the boundary of a mesh, between edges that are sharp: sets of faces for solvers.

#include "program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

class Boundary_patches
{
public:
  using Face = std::array<std::size_t, 4>;

  Boundary_patches(const Points& points, const Hexahedra& hexahedra, double angle_in_degrees)
    : points_(points)
    , cosine_(std::cos(angle_in_degrees * 3.14159265358979323846 / 180))
  {
    collect_faces(hexahedra);
    label();
  }

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<std::size_t>& patches() const { return patch_; } // of the faces, counted from 1

private:
  using Vector = Kernel::Vector_3;

  void collect_faces(const Hexahedra& hexahedra)
  {
    static const int sides[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};
    std::vector<std::pair<Face, Face>> all; // sorted, and as it is
    for (const auto& h : hexahedra)
      for (const auto& side : sides) {
        Face face{};
        for (std::size_t i = 0; i < 4; ++i)
          face[i] = h[static_cast<std::size_t>(side[i])];
        Face sorted = face;
        std::sort(sorted.begin(), sorted.end());
        all.emplace_back(sorted, face);
      }
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool is_shared = (i > 0 && all[i - 1].first == all[i].first) ||
                             (i + 1 < all.size() && all[i + 1].first == all[i].first);
      if (!is_shared)
        faces_.push_back(all[i].second);
    }
  }

  Vector normal(std::size_t f) const
  {
    const auto p = [&](std::size_t i) { return points_[faces_[f][i]]; };
    const Vector n = CGAL::cross_product(p(2) - p(0), p(3) - p(1));
    const double length = std::sqrt(n.squared_length());
    return length > 0 ? n / length : n;
  }

  // Faces that meet at an edge of two faces that is not sharp belong together.
  void label()
  {
    std::map<std::array<std::size_t, 2>, std::vector<std::size_t>> at_edge;
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t a = faces_[f][i], b = faces_[f][(i + 1) % 4];
        at_edge[{{std::min(a, b), std::max(a, b)}}].push_back(f);
      }
    std::vector<Vector> normals;
    std::vector<std::vector<std::size_t>> neighbors(faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f)
      normals.push_back(normal(f));
    for (const auto& [edge, faces] : at_edge)
      if (faces.size() == 2 && normals[faces[0]] * normals[faces[1]] >= cosine_) {
        neighbors[faces[0]].push_back(faces[1]);
        neighbors[faces[1]].push_back(faces[0]);
      }
    patch_.assign(faces_.size(), 0);
    std::size_t number = 0;
    for (std::size_t seed = 0; seed < faces_.size(); ++seed) {
      if (patch_[seed] != 0)
        continue;
      patch_[seed] = ++number;
      std::vector<std::size_t> reached(1, seed);
      while (!reached.empty()) {
        const std::size_t f = reached.back();
        reached.pop_back();
        for (std::size_t n : neighbors[f])
          if (patch_[n] == 0) {
            patch_[n] = number;
            reached.push_back(n);
          }
      }
    }
  }

  const Points& points_;
  double cosine_;
  std::vector<Face> faces_;
  std::vector<std::size_t> patch_;
};

// As quadrilaterals with labels.
inline void add_patches(Mesh& mesh, double angle_in_degrees)
{
  const Boundary_patches patches(mesh.points, mesh.hexahedra, angle_in_degrees);
  for (std::size_t f = 0; f < patches.faces().size(); ++f) {
    CGAL::IO::Hex_mesh_cell cell;
    cell.type = 9;
    cell.vertices.assign(patches.faces()[f].begin(), patches.faces()[f].end());
    cell.label = static_cast<std::int64_t>(patches.patches()[f]);
    cell.number_of_hexahedra_before = mesh.hexahedra.size();
    mesh.mesh_data.other_cells.push_back(std::move(cell));
  }
}

#endif // CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_BOUNDARY_PATCHES_H
