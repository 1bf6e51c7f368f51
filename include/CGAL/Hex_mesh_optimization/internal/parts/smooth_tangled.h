// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_SMOOTH_TANGLED_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_SMOOTH_TANGLED_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Laplacian smoothing where a mesh is tangled, all over the ranks at once: a start for parts, which cannot untangle
// what the vertices between them do not allow.

#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Block_array.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Parts_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Distributed_mesh.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/scaled_jacobian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Vertices of hexahedra whose scaled Jacobian is below that come to the mean of their neighbors, sweep after sweep; what
// has left the fewest of these hexahedra, and of those the best worst one of all that were tangled, is kept. is_held: of
// the vertices of this rank; is_over(): whether that is to be all. Collective.
template <class Is_over>
void smooth_tangled(Distributed_mesh& mesh, const Block_array<char>& is_held, double untangled,
                    const Parts_parameters& parameters, const Is_over& is_over)
{
  using Sum = std::array<std::int64_t, 3>;
  // sums of fixed point are the same in any order
  constexpr double steps_of_unit = 4294967296., most_steps = steps_of_unit * (1 << 20);
  Block_array<char> moves = mesh.new_array<char>(mesh.points.size());
  Block_array<Triple> best = mesh.new_array<Triple>(mesh.points.size());
  Block_array<char> was_tangled = mesh.new_array<char>(mesh.number_of_own_hexahedra());
  auto lowest = std::make_pair(std::numeric_limits<std::int64_t>::max(), 1.); // how many are tangled, less the worst
  for (int sweep = 0, since = 0; sweep < parameters.most_sweeps && since < parameters.patience_of_sweeps; ++sweep) {
    const Distributed_mesh::Nearby<Triple> places = mesh.nearby(mesh.points);
    std::vector<std::int64_t> tangled(1, 0);
    double worst = 1;
    {
      Block_array<char> of_nearby = mesh.new_array<char>(mesh.number_of_nearby());
      mesh.for_own_hexahedra([&](std::size_t h) {
        Hexahedron_coordinates x;
        for (int i = 0; i < 8; ++i)
          x[i] = places[mesh.hexahedra[h][i]];
        const double quality = scaled_jacobian(x);
        was_tangled[h] = was_tangled[h] || quality < untangled;
        if (was_tangled[h])
          worst = (std::min)(worst, quality);
        if (quality >= untangled)
          return;
        ++tangled[0];
        for (std::uint32_t v : mesh.hexahedra[h])
          of_nearby[v] = true;
      });
      mesh.combine(of_nearby, moves, [](char a, char b) { return static_cast<char>(a || b); });
    }
    for (std::size_t v = 0; v < moves.size(); ++v)
      moves[v] = moves[v] && !is_held[v];
    mesh.ranks.sum(tangled);
    const auto now = std::make_pair(tangled[0], mesh.ranks.maximum_of(-worst));
    ++since;
    if (now < lowest) {
      std::copy(mesh.points.data(), mesh.points.data() + mesh.points.size(), best.data());
      lowest = now;
      since = 0;
    }
    if (is_over())
      break;
    Block_array<Sum> sums_nearby = mesh.new_array<Sum>(mesh.number_of_nearby());
    Block_array<Sum> sums = mesh.new_array<Sum>(mesh.points.size());
    const Distributed_mesh::Nearby<char> moves_nearby = mesh.nearby(moves);
    mesh.for_own_hexahedra([&](std::size_t h) {
      for (int c = 0; c < 8; ++c) {
        const std::uint32_t v = mesh.hexahedra[h][c];
        if (!moves_nearby[v])
          continue;
        for (int next : corner_neighbors[c])
          for (int i = 0; i < 3; ++i) {
            const double steps = (places[mesh.hexahedra[h][next]][i] - places[v][i]) / mesh.unit * steps_of_unit;
            sums_nearby[v][i] += std::llround((std::max)(-most_steps, (std::min)(most_steps, steps)));
          }
      }
    });
    mesh.combine(sums_nearby, sums, [](const Sum& a, const Sum& b) {
      return Sum{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    });
    for (std::size_t v = 0; v < sums.size(); ++v)
      if (moves[v])
        for (int i = 0; i < 3; ++i)
          mesh.points[v][i] += double(sums[v][i]) / (3. * mesh.valence[v]) / steps_of_unit * mesh.unit;
  }
  std::copy(best.data(), best.data() + best.size(), mesh.points.data());
  mesh.release();
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_SMOOTH_TANGLED_H
