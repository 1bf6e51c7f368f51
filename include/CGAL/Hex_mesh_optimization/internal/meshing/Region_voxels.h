// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_REGION_VOXELS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_REGION_VOXELS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The cells of a grid in several regions, none of which touches itself, nor what is outside, in an edge or a vertex
// only.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Annealing_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Node_patterns.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Voxel_grid.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/inside_voxels.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// The triangles around the region of a label, oriented outwards.
inline std::vector<Triangle_indices> triangles_around(const Reference_input& regions, int label)
{
  std::vector<Triangle_indices> result;
  for (std::size_t t = 0; t < regions.triangles.size(); ++t) {
    Triangle_indices triangle = regions.triangles[t];
    if (regions.labels[t][1] == label)
      std::swap(triangle[1], triangle[2]);
    if (regions.labels[t][0] == label || regions.labels[t][1] == label)
      result.push_back(triangle);
  }
  return result;
}

class Region_voxels
{
public:
  static constexpr int outside = Reference_input::no_label;

  // surface: that of the regions, all sheets in one. Deterministic.
  Region_voxels(const Reference_input& regions, const std::vector<int>& labels, const Triangle_surface& surface,
                Voxel_grid its_grid, const Annealing_parameters& parameters)
    : grid(std::move(its_grid))
    , label(grid.is_inside.size(), outside)
    , surface_(&surface)
  {
    for (int l : labels) {
      fill_inside(regions.points, triangles_around(regions, l), grid);
      for (std::size_t cell = 0; cell < label.size(); ++cell)
        if (grid.is_inside[cell])
          label[cell] = l;
    }
    drop_crumbs();
    mend();
    drop_crumbs();
    anneal(parameters);
    for (std::size_t cell = 0; cell < label.size(); ++cell)
      grid.is_inside[cell] = label[cell] != outside;
  }

  Voxel_grid grid;        // inside: of any region
  std::vector<int> label; // of each cell

private:
  unsigned pattern(std::size_t node, int of) const
  {
    unsigned result = 0;
    for (int c = 0; c < 8; ++c)
      result |= unsigned(label[cell_around(grid, node, c)] == of) << c;
    return result;
  }

  bool is_manifold(std::size_t node) const
  {
    std::array<int, 8> around;
    for (int c = 0; c < 8; ++c)
      around[c] = label[cell_around(grid, node, c)];
    for (int c = 0; c < 8; ++c)
      if (std::find(around.begin(), around.begin() + c, around[c]) == around.begin() + c) {
        unsigned of_label = 0;
        for (int d = 0; d < 8; ++d)
          of_label |= unsigned(around[d] == around[c]) << d;
        if (!patterns_.is_manifold(of_label))
          return false;
      }
    return true;
  }

  int bad_nodes_around(std::size_t cell) const
  {
    int result = 0;
    for (int c = 0; c < 8; ++c)
      result += !is_manifold(node_of(grid, cell, c));
    return result;
  }

  std::vector<std::size_t> bad_nodes() const
  {
    std::vector<std::size_t> result;
    for (int k = 0; k <= grid.cells(2); ++k)
      for (int j = 0; j <= grid.cells(1); ++j)
        for (int i = 0; i <= grid.cells(0); ++i)
          if (!is_manifold(grid.index(i, j, k)))
            result.push_back(grid.index(i, j, k));
    return result;
  }

  // What one change of a cell mends, the best of them, as long as there are any; where none does, one that leaves as
  // many bad nodes may lead on.
  void mend()
  {
    constexpr int most_rounds = 200;
    std::set<std::pair<std::size_t, int>> tried; // changes that left as many
    std::vector<std::size_t> bad = bad_nodes();
    for (int round = 0; round < most_rounds && !bad.empty(); ++round) {
      for (std::size_t node : bad)
        if (!is_manifold(node))
          mend(node, tried);
      bad = bad_nodes();
    }
  }

  void mend(std::size_t node, std::set<std::pair<std::size_t, int>>& tried)
  {
    std::set<int> labels;
    for (int c = 0; c < 8; ++c)
      labels.insert(label[cell_around(grid, node, c)]);
    std::pair<int, double> best(1, 0); // change of the number of bad nodes, cost
    std::size_t chosen = 0;
    int its_label = outside;
    for (int c = 0; c < 8; ++c) {
      const std::size_t cell = cell_around(grid, node, c);
      if (!grid.is_in_box(cell))
        continue;
      const int before = label[cell], bad = bad_nodes_around(cell);
      for (int l : labels) {
        if (l == before)
          continue;
        label[cell] = l;
        const int change = bad_nodes_around(cell) - bad;
        label[cell] = before;
        if (change > 0 || (change == 0 && tried.count({cell, l})))
          continue;
        const std::pair<int, double> candidate(change, distance(cell));
        if (candidate < best) {
          best = candidate;
          chosen = cell;
          its_label = l;
        }
      }
    }
    if (best.first > 0)
      return;
    if (best.first == 0)
      tried.insert({chosen, its_label});
    label[chosen] = its_label;
  }

  double distance(std::size_t cell) const
  {
    const Vector_3 p = grid.center(cell);
    return (surface_->closest_point(p).point - p).norm();
  }

  // Pieces of a region that are few cells, and do not hang together with the most of it, become what is around them.
  void drop_crumbs()
  {
    constexpr std::size_t few = 4;
    Disjoint_sets pieces(label.size());
    for (std::size_t cell = 0; cell < label.size(); ++cell)
      for (int axis = 0; axis < 3; ++axis)
        if (grid.is_in_box(cell) && label[cell] == label[cell + grid.stride(axis)])
          pieces.unite(cell, cell + grid.stride(axis));
    std::map<std::size_t, std::size_t> size;
    for (std::size_t cell = 0; cell < label.size(); ++cell)
      if (label[cell] != outside)
        ++size[pieces.find(cell)];
    std::map<int, std::size_t> largest; // piece of each label
    for (const auto& [root, number] : size) {
      const auto inserted = largest.emplace(label[root], root);
      if (number > size[inserted.first->second])
        inserted.first->second = root;
    }
    std::map<std::size_t, std::map<int, int>> around; // of a crumb: how often each label is beside it
    for (std::size_t cell = 0; cell < label.size(); ++cell) {
      if (label[cell] == outside)
        continue;
      const std::size_t root = pieces.find(cell);
      if (size[root] > few || largest[label[cell]] == root)
        continue;
      for (int axis = 0; axis < 3; ++axis)
        for (std::size_t other : {cell - grid.stride(axis), cell + grid.stride(axis)})
          if (label[other] != label[cell])
            ++around[root][label[other]];
    }
    std::map<std::size_t, int> becomes;
    for (const auto& [root, beside] : around)
      becomes[root] = std::max_element(beside.begin(), beside.end(), [](const auto& a, const auto& b) {
                        return a.second < b.second;
                      })->first;
    for (std::size_t cell = 0; cell < label.size() && !becomes.empty(); ++cell) {
      const auto found = becomes.find(pieces.find(cell));
      if (label[cell] != outside && found != becomes.end())
        label[cell] = found->second;
    }
  }

  struct Candidate
  {
    std::size_t cell;
    int label;   // that it would have
    double cost; // of the change: negative once it has changed
  };

  // As Voxel_annealing, with the labels of neighbors in the place of inside and outside.
  void anneal(const Annealing_parameters& parameters)
  {
    std::vector<Candidate> candidates = find_candidates(parameters);
    const double cooling = std::pow(parameters.last_temperature / parameters.first_temperature, 1. / parameters.sweeps);
    double temperature = parameters.first_temperature;
    for (int sweep = 0; sweep < parameters.sweeps; ++sweep, temperature *= cooling)
      for (Candidate& c : candidates)
        try_to_change(c, temperature);
    for (bool any = true; any;) {
      any = false;
      for (Candidate& c : candidates)
        any = try_to_change(c, 0) || any;
    }
  }

  std::vector<Candidate> find_candidates(const Annealing_parameters& parameters) const
  {
    std::vector<Candidate> result;
    const double spacing = grid.mean_spacing();
    for (int k = 0; k < grid.cells(2); ++k)
      for (int j = 0; j < grid.cells(1); ++j)
        for (int i = 0; i < grid.cells(0); ++i) {
          const std::size_t cell = grid.index(i, j, k);
          std::set<int> others;
          for (int axis = 0; axis < 3; ++axis)
            for (std::size_t other : {cell - grid.stride(axis), cell + grid.stride(axis)})
              others.insert(label[other]);
          others.erase(label[cell]);
          if (others.size() != 1) // near where three meet, cells stay
            continue;
          const double d = distance(cell) / spacing;
          if (d <= parameters.most_distance)
            result.push_back({cell, *others.begin(), parameters.weight_of_distance * d * d});
        }
    return result;
  }

  bool try_to_change(Candidate& c, double temperature)
  {
    if (!is_simple(c.cell, label[c.cell]) || !is_simple(c.cell, c.label))
      return false;
    const int before = irregularity_around(c.cell, label[c.cell], c.label);
    std::swap(label[c.cell], c.label);
    const double cost = c.cost + irregularity_around(c.cell, label[c.cell], c.label) - before;
    const bool is_taken = temperature > 0 ? cost <= 0 || std::exp(-cost / temperature) > random() : cost < -rounding;
    if (!is_taken || bad_nodes_around(c.cell) > 0) {
      std::swap(label[c.cell], c.label);
      return false;
    }
    c.cost = -c.cost;
    return true;
  }

  // The change of the cell does not change the topology of a region that it leaves or enters: see Voxel_annealing.
  bool is_simple(std::size_t cell, int region) const
  {
    int pairs = 0, none = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const bool below = is_different(cell, cell - grid.stride(axis), region),
                 above = is_different(cell, cell + grid.stride(axis), region);
      pairs += below && above;
      none += !below && !above;
      if (below && above && !is_on_something_wider(cell, axis, region))
        return false;
    }
    return none < 3 && !(pairs == 1 && none == 2) && pairs < 3 && !(pairs == 2 && none == 1);
  }

  bool is_on_something_wider(std::size_t cell, int axis, int region) const
  {
    for (int other = 0; other < 3; ++other)
      if (other != axis)
        for (const std::size_t base : {cell - grid.stride(other), cell + grid.stride(other)}) {
          const std::size_t opposite = 2 * cell - base;
          if (!is_different(cell, base, region) && is_different(cell, opposite, region) &&
              !is_different(base, base - grid.stride(axis), region) &&
              !is_different(base, base + grid.stride(axis), region))
            return true;
        }
    return false;
  }

  bool is_different(std::size_t a, std::size_t b, int region) const
  {
    return (label[a] == region) != (label[b] == region);
  }

  int irregularity_around(std::size_t cell, int a, int b) const
  {
    int sum = 0;
    for (int c = 0; c < 8; ++c) {
      const std::size_t node = node_of(grid, cell, c);
      sum += patterns_.irregularity(pattern(node, a)) + patterns_.irregularity(pattern(node, b));
    }
    return sum / 2;
  }

  double random() { return double(engine_()) / double(std::mt19937::max()); }

  static constexpr double rounding = 1e-9; // of costs

  const Triangle_surface* surface_;
  Node_patterns patterns_;
  std::mt19937 engine_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_REGION_VOXELS_H
