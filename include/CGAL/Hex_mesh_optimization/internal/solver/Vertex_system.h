// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_VERTEX_SYSTEM_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_VERTEX_SYSTEM_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The quadratic energies of the global step as one sparse system over vertices:
// scalar couplings, equal in x, y and z, plus a 3×3 block at boundary vertices.

#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Ties.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/conjugate_gradients.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Vertex_system
{
public:
  // couplings: every pair of vertices (smaller first) that any term will couple.
  Vertex_system(std::size_t number_of_vertices, std::vector<std::array<int, 2>> couplings)
    : offsets_(number_of_vertices + 1, 0)
    , diagonal(number_of_vertices, 0.0)
    , blocks(number_of_vertices, Matrix_3::Zero())
    , right(number_of_vertices, Vector_3::Zero())
    , is_fixed(number_of_vertices, false)
  {
    const Grouped_array of_first(
      number_of_vertices, couplings.size(), [&](std::size_t i) { return couplings[i][0]; },
      [&](std::size_t i) { return couplings[i][1]; });
    couplings.clear();
    std::vector<int> row;
    for (std::size_t v = 0; v < number_of_vertices; ++v) {
      row.assign(of_first[v].begin(), of_first[v].end());
      std::sort(row.begin(), row.end());
      row.erase(std::unique(row.begin(), row.end()), row.end());
      for (int u : row)
        couplings.push_back({static_cast<int>(v), u});
    }
    for (const std::array<int, 2>& c : couplings) {
      ++offsets_[c[0] + 1];
      ++offsets_[c[1] + 1];
    }
    for (std::size_t v = 0; v < number_of_vertices; ++v)
      offsets_[v + 1] += offsets_[v];
    columns_.resize(offsets_.back());
    couplings_.assign(offsets_.back(), 0.0);
    std::vector<std::size_t> next(offsets_.begin(), offsets_.end() - 1);
    for (const std::array<int, 2>& c : couplings) // rows get their columns in increasing order
      columns_[next[c[1]]++] = c[0];
    for (const std::array<int, 2>& c : couplings)
      columns_[next[c[0]]++] = c[1];
  }

  std::size_t size() const { return diagonal.size(); }

  // Where the coupling of two vertices is stored in row i. O(log row).
  std::size_t slot(int i, int j) const
  {
    return std::lower_bound(columns_.begin() + offsets_[i], columns_.begin() + offsets_[i + 1], j) - columns_.begin();
  }

  const std::vector<double>& couplings() const { return couplings_; }
  std::vector<double>& couplings() { return couplings_; }

  // Solves for the minimizer by conjugate gradients with the 3×3 diagonal blocks
  // as preconditioner, from x as start. Stops when the residual has dropped by
  // `tolerance` relative to the right-hand side. Returns the iterations. Of tied rows all are fixed or none.
  int solve(Positions& x, double tolerance, int maximum_iterations) const
  {
    const std::size_t n = size();
    std::vector<Matrix_3> inverse(n);
    for_each(n, [&](std::size_t v) {
      inverse[v] = is_fixed[v] || diagonal[v] <= 0
                     ? Matrix_3(Matrix_3::Zero())
                     : Matrix_3((blocks[v] + diagonal[v] * Matrix_3::Identity()).inverse());
    });
    ties.average(inverse);
    double scale = 0;
    for (std::size_t v = 0; v < n; ++v)
      // positions are of the order of the number of edges across; what must be
      // resolved is a fraction of one edge, whose length is the unit
      scale += is_fixed[v] ? 0 : diagonal[v];
    const Conjugate_gradients_parameters parameters{tolerance * tolerance * scale, maximum_iterations};
    if (ties.is_empty())
      return conjugate_gradients(Preconditioned{*this, inverse}, right, parameters, x);
    // What is not the same for tied rows is projected away: their steps are the same.
    Positions mean = right;
    ties.average(mean);
    return conjugate_gradients(Preconditioned{*this, inverse}, mean, parameters, x);
  }

  // xᵀAx − 2bᵀx
  double energy(const Positions& x) const
  {
    Positions Ax(size());
    multiply(x, Ax);
    return sum_of_ranges(size(), [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t v = begin; v < end; ++v)
        sum += x[v].dot(Ax[v] - 2 * right[v]);
      return sum;
    });
  }

private:
  struct Preconditioned
  {
    const Vertex_system& system;
    const std::vector<Matrix_3>& inverse; // of the diagonal blocks; 0 in fixed rows

    void multiply(const Positions& x, Positions& y) const
    {
      system.multiply(x, y);
      system.ties.average(y);
    }
    Vector_3 precondition(std::size_t v, const Vector_3& r) const { return inverse[v] * r; }
    bool is_fixed(std::size_t v) const { return system.is_fixed[v]; }
  };

  void multiply(const Positions& x, Positions& y) const
  {
    for_each(size(), [&](std::size_t v) {
      Vector_3 sum = diagonal[v] * x[v] + blocks[v] * x[v];
      for (std::size_t k = offsets_[v]; k < offsets_[v + 1]; ++k)
        sum += couplings_[k] * x[columns_[k]];
      y[v] = sum;
    });
  }

  std::vector<std::size_t> offsets_;
  std::vector<int> columns_;
  std::vector<double> couplings_;

public:
  std::vector<double> diagonal;
  std::vector<Matrix_3> blocks;
  Positions right;
  std::vector<char> is_fixed; // rows whose position is given
  Ties ties;                  // of rows
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_VERTEX_SYSTEM_H
