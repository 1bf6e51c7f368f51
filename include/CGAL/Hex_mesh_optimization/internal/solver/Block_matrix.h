// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_BLOCK_MATRIX_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_BLOCK_MATRIX_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A symmetric sparse matrix of 3×3 blocks, one row of blocks a point, and the
// conjugate gradients that solve with it.

#include <CGAL/Hex_mesh_optimization/internal/base/Conflict_free_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Ties.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Freedom.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Block_matrix
{
public:
  // Where the block of two coupled rows is stored: as it is, or transposed.
  struct Slot
  {
    std::uint32_t number : 31, is_transposed : 1;
  };

  // couplings: for each row the others that it has a block with, in any order and as often as you like; a row has one
  // with every row that has one with it. ties: of rows whose unknowns are the same.
  explicit Block_matrix(const Grouped_array& couplings, const Ties& ties = Ties())
    : diagonal(couplings.size())
    , offsets_(couplings.size() + 1, 0)
    , ties_(ties)
  {
    std::vector<int> row;
    ranges_ = std::make_unique<Conflict_free_ranges>(size(), size(), rows_of_range,
                                                     [&](std::size_t v) -> const std::vector<int>& {
                                                       row.assign(couplings[v].begin(), couplings[v].end());
                                                       row.push_back(static_cast<int>(v));
                                                       return row;
                                                     });
    for (std::size_t v = 0; v < size(); ++v) {
      row.clear();
      for (int u : couplings[v])
        if (is_before(static_cast<int>(v), u))
          row.push_back(u);
      std::sort(row.begin(), row.end());
      columns_.insert(columns_.end(), row.begin(), std::unique(row.begin(), row.end()));
      offsets_[v + 1] = columns_.size();
    }
    entries_.resize(entries_of_block * columns_.size() + 1); // as the last row is read with one entry more
    if (!ties.is_empty())
      reduced_ = std::make_unique<Block_matrix>(couplings_of_leaders());
  }

  const Ties& ties() const { return ties_; }
  std::size_t size() const { return diagonal.size(); }

  void set_zero()
  {
    for_ranges(size(), [&](std::size_t begin, std::size_t end) {
      std::fill(diagonal.begin() + begin, diagonal.begin() + end, Matrix_3::Zero());
      std::fill(entries_.begin() + entries_of_block * offsets_[begin],
                entries_.begin() + entries_of_block * offsets_[end], 0.f);
    });
  }

  // Of two different rows that are coupled. O(log row).
  Slot slot(int i, int j) const
  {
    const bool is_transposed = is_before(j, i);
    if (is_transposed)
      std::swap(i, j);
    const auto column = std::lower_bound(columns_.begin() + offsets_[i], columns_.begin() + offsets_[i + 1], j);
    return {static_cast<std::uint32_t>(column - columns_.begin()) & 0x7fffffffu, is_transposed};
  }

  // Adds the block of entries entry(r, c), and its transpose at the other side of the diagonal.
  template <class Entry>
  void add(const Slot& slot, const Entry& entry)
  {
    float* block = entries_.data() + entries_of_block * slot.number;
    const int right = slot.is_transposed ? 3 : 1, down = slot.is_transposed ? 1 : 3;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c)
        block[down * r + right * c] += static_cast<float>(entry(r, c));
  }

  // Adds B at (i, j) and, i ≠ j, its transpose at (j, i). Different rows must be coupled.
  void add(int i, int j, const Matrix_3& B)
  {
    if (i == j)
      diagonal[i] += B;
    else
      add(slot(i, j), [&](int r, int c) { return B(r, c); });
  }

  // Approximates A x = b from x = 0, for x within the freedoms and up to what is orthogonal to them, until the residual
  // has dropped by `tolerance`, in the norm of the preconditioner. That is symmetric Gauss-Seidel, A ≈ (D + L) D⁻¹ (D +
  // Lᵀ), in the form of Eisenstat (1981): with d' = (D + Lᵀ) d, (D + L)⁻¹ A d = d + (D + L)⁻¹ Lᵀ d costs no more than A
  // d. Rows of one color come before those of the next, so that the sweeps run in parallel and do not depend on the
  // number of threads. Returns the iterations. The Hessian is a model: single precision is enough, and halves the
  // traffic. Rows that are tied have the freedom of their leader.
  int solve(const Positions& b, const Freedoms& freedoms, double tolerance, int maximum_iterations, Positions& x) const
  {
    if (reduced_)
      return solve_reduced(b, freedoms, tolerance, maximum_iterations, x);
    const std::size_t n = size();
    double largest = 0; // so that nothing overflows
    for (std::size_t v = 0; v < n; ++v)
      if (freedoms[v].dimension() > 0)
        largest = (std::max)(largest, b[v].cwiseAbs().maxCoeff());
    x.assign(n, Vector_3::Zero());
    if (!(largest > 0) || !std::isfinite(largest))
      return 0;
    std::vector<Diagonal_block> D(n), inverse(n); // D⁻¹, within the freedoms
    std::vector<char> moves(n, false);
    // in terms of the sweeps: the residual r' = (D + L)⁻¹ r, the direction d'
    const Vector zero = Vector::Zero();
    std::vector<Vector> y(n, zero), r(n, zero), d(n, zero), swept_d(n, zero), Ad(n, zero), w(n, zero);
    for_each(n, [&](std::size_t v) {
      D[v] = Diagonal_block(diagonal[v]);
      if (freedoms[v].dimension() > 0) {
        moves[v] = true;
        inverse[v] = Diagonal_block(freedoms[v].inverse(diagonal[v]));
        w[v].head<3>() = (b[v] / largest).cast<float>();
      }
    });
    solve_lower(moves, inverse, w, r);
    double rz = sum_of_ranges(n, [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t v = begin; v < end; ++v) {
        swept_d[v] = D[v] * r[v];
        sum += (r[v] * swept_d[v]).sum();
      }
      return sum;
    });
    const double stop = tolerance * tolerance * rz;
    int iteration = 0;
    for (; iteration < maximum_iterations && rz > stop; ++iteration) {
      solve_upper(moves, inverse, swept_d, d, w);
      solve_lower(moves, inverse, w, Ad);
      const double dAd = sum_of_ranges(n, [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t v = begin; v < end; ++v) {
          Ad[v] += d[v];
          sum += (swept_d[v] * Ad[v]).sum();
        }
        return sum;
      });
      if (!(dAd > 0))
        break;
      const float step = static_cast<float>(rz / dAd);
      const double next = sum_of_ranges(n, [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t v = begin; v < end; ++v) {
          y[v] += step * d[v];
          r[v] -= step * Ad[v];
          w[v] = D[v] * r[v];
          sum += (r[v] * w[v]).sum();
        }
        return sum;
      });
      const float ratio = static_cast<float>(next / rz);
      for_each(n, [&](std::size_t v) { swept_d[v] = w[v] + ratio * swept_d[v]; });
      rz = next;
    }
    for_each(n, [&](std::size_t v) { x[v] = largest * y[v].head<3>().matrix().cast<double>(); });
    return iteration;
  }

  std::vector<Matrix_3> diagonal;

private:
  static constexpr std::size_t rows_of_range = 512;

  static constexpr std::size_t entries_of_block = 9;

  // Four numbers, as registers have them; the last one is 0.
  using Vector = Eigen::Array4f;
  using Row = Eigen::Map<const Vector>;

  struct Diagonal_block
  {
    Vector columns[3];

    Diagonal_block() : columns{Vector::Zero(), Vector::Zero(), Vector::Zero()} {}
    explicit Diagonal_block(const Matrix_3& B) : Diagonal_block()
    {
      for (int c = 0; c < 3; ++c)
        columns[c].head<3>() = B.col(c).cast<float>();
    }

    Vector operator*(const Vector& x) const { return columns[0] * x[0] + columns[1] * x[1] + columns[2] * x[2]; }
  };

  Grouped_array couplings_of_leaders() const
  {
    std::vector<std::array<int, 2>> pairs;
    for (std::size_t v = 0; v < size(); ++v)
      for (std::size_t k = offsets_[v]; k < offsets_[v + 1]; ++k) {
        const int i = ties_.leader(static_cast<int>(v)), j = ties_.leader(columns_[k]);
        if (i != j)
          pairs.insert(pairs.end(), {{i, j}, {j, i}});
      }
    return Grouped_array(
      size(), pairs.size(), [&](std::size_t k) { return pairs[k][0]; }, [&](std::size_t k) { return pairs[k][1]; });
  }

  // With x = P y, where y are the unknowns of the leaders, solves Pᵀ A P y = Pᵀ b.
  int solve_reduced(const Positions& b, Freedoms freedoms, double tolerance, int maximum_iterations, Positions& x) const
  {
    reduced_->set_zero();
    Positions sums(size(), Vector_3::Zero());
    for (std::size_t v = 0; v < size(); ++v) {
      const int i = ties_.leader(static_cast<int>(v));
      reduced_->diagonal[i] += diagonal[v];
      sums[i] += b[v];
      if (i != static_cast<int>(v))
        freedoms[v] = Freedom::nowhere();
      for (std::size_t k = offsets_[v]; k < offsets_[v + 1]; ++k) {
        const int j = ties_.leader(columns_[k]);
        const float* block = entries_.data() + entries_of_block * k;
        Matrix_3 B;
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 3; ++c)
            B(r, c) = block[3 * r + c];
        reduced_->add(i, j, i == j ? Matrix_3(B + B.transpose()) : B);
      }
    }
    const int iterations = reduced_->solve(sums, freedoms, tolerance, maximum_iterations, x);
    ties_.follow(x);
    return iterations;
  }

  // The order of the sweeps.
  bool is_before(int i, int j) const
  {
    const std::size_t a = ranges_->color(i), b = ranges_->color(j);
    return a < b || (a == b && i < j);
  }

  // Solves (D + L) y = b; overwrites b. y is 0, and stays so, at rows that do not move.
  void solve_lower(const std::vector<char>& moves, const std::vector<Diagonal_block>& inverse, std::vector<Vector>& b,
                   std::vector<Vector>& y) const
  {
    ranges_->for_ranges([&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        if (!moves[v])
          continue;
        const Vector x = inverse[v] * b[v];
        y[v] = x;
        const float *block = entries_.data() + entries_of_block * offsets_[v], x0 = x[0], x1 = x[1], x2 = x[2];
        for (std::size_t k = offsets_[v]; k < offsets_[v + 1]; ++k, block += entries_of_block)
          b[columns_[k]] -= Row(block) * x0 + Row(block + 3) * x1 +
                            Row(block + 6) * x2; // and nonsense in the last number
      }
    });
  }

  // Solves (D + Lᵀ) y = b, and gives Lᵀ y. At rows that do not move, y is 0 and stays so, and Lᵀ y is not needed.
  void solve_upper(const std::vector<char>& moves, const std::vector<Diagonal_block>& inverse,
                   const std::vector<Vector>& b, std::vector<Vector>& y, std::vector<Vector>& Ly) const
  {
    ranges_->for_ranges_backwards([&](std::size_t begin, std::size_t end) {
      for (std::size_t v = end; v-- > begin;) {
        if (!moves[v])
          continue;
        Vector s0 = Vector::Zero(), s1 = s0, s2 = s0;
        const float* block = entries_.data() + entries_of_block * offsets_[v];
        for (std::size_t k = offsets_[v]; k < offsets_[v + 1]; ++k, block += entries_of_block) {
          const Vector x = y[columns_[k]]; // its last number is 0, whatever follows a row
          s0 += Row(block) * x;
          s1 += Row(block + 3) * x;
          s2 += Row(block + 6) * x;
        }
        Ly[v] = Vector(s0.sum(), s1.sum(), s2.sum(), 0);
        y[v] = inverse[v] * (b[v] - Ly[v]);
      }
    });
  }

  std::vector<std::size_t> offsets_;                   // of the blocks of each row
  std::vector<int> columns_;                           // rows that come later than their own
  std::vector<float> entries_;                         // of the blocks, row by row
  std::unique_ptr<const Conflict_free_ranges> ranges_; // of rows
  const Ties ties_;
  std::unique_ptr<Block_matrix> reduced_; // for the leaders; null without ties
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_BLOCK_MATRIX_H
