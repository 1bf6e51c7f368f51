// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BLOCK_MATRIX_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BLOCK_MATRIX_H

// A symmetric sparse matrix of 3×3 blocks, one row of blocks a vertex, and the
// conjugate gradients that solve with it.

#include <CGAL/Hex_mesh_optimization/internal/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/Vector_3.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

class Block_matrix
{
public:
  // The blocks of one hexahedron: 8 on the diagonal, then those above it, row by row.
  using Hexahedron_blocks = std::array<Matrix_3, 36>;

  // Where the block of two different corners is among them, i < j.
  static constexpr int local_block(int i, int j) { return 8 + i * (15 - i) / 2 + j - i - 1; }

  // Couples all vertices of each hexahedron.
  explicit Block_matrix(const Hexahedral_complex& complex)
    : diagonal(complex.number_of_vertices())
    , offsets_(complex.number_of_vertices() + 1, 0)
    , hexahedra_(complex.hexahedra)
    , hexahedron_slots_(complex.hexahedra.size())
  {
    // The neighbors of a vertex with a higher index, from the hexahedra around it.
    std::vector<int> neighbors;
    for (std::size_t v = 0; v < complex.number_of_vertices(); ++v) {
      neighbors.clear();
      for (int h : complex.vertex_hexahedra[v])
        for (int u : complex.hexahedra[h])
          if (u > static_cast<int>(v))
            neighbors.push_back(u);
      std::sort(neighbors.begin(), neighbors.end());
      neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
      columns_.insert(columns_.end(), neighbors.begin(), neighbors.end());
      offsets_[v + 1] = columns_.size();
    }
    blocks_.resize(columns_.size());
    for (std::size_t h = 0; h < hexahedra_.size(); ++h)
      for (int i = 0; i < 8; ++i)
        for (int j = i + 1; j < 8; ++j) {
          const int a = hexahedra_[h][i], b = hexahedra_[h][j];
          hexahedron_slots_[h][local_block(i, j) - 8] = a < b ? 2 * slot(a, b) : 2 * slot(b, a) + 1;
        }
  }

  std::size_t size() const { return diagonal.size(); }

  void set_zero()
  {
    std::fill(diagonal.begin(), diagonal.end(), Matrix_3::Zero());
    std::fill(blocks_.begin(), blocks_.end(), Block::Zero());
  }

  // Adds B at (i, j) and, i ≠ j, its transpose at (j, i).
  void add(int i, int j, const Matrix_3& B)
  {
    if (i == j)
      diagonal[i] += B;
    else if (i < j)
      blocks_[slot(i, j)] += B.cast<float>();
    else
      blocks_[slot(j, i)] += B.transpose().cast<float>();
  }

  void add(std::size_t hexahedron, const Hexahedron_blocks& B)
  {
    for (int i = 0; i < 8; ++i)
      diagonal[hexahedra_[hexahedron][i]] += B[i];
    for (int k = 0; k < 28; ++k) {
      const std::size_t place = hexahedron_slots_[hexahedron][k];
      if (place % 2)
        blocks_[place / 2] += B[8 + k].transpose().cast<float>();
      else
        blocks_[place / 2] += B[8 + k].cast<float>();
    }
  }

  // Approximates A x = b from x = 0, in the rows that are not fixed, until the
  // residual has dropped by `tolerance`. Preconditioned by the diagonal blocks.
  // Returns the iterations.
  int solve(const Positions& b, const std::vector<char>& is_fixed, double tolerance, int maximum_iterations, Positions& x) const
  {
    const std::size_t n = size();
    std::vector<Matrix_3> inverse(n, Matrix_3::Zero());
    Positions r(n, Vector_3::Zero()), z(n), d(n), Ad(n);
    x.assign(n, Vector_3::Zero());
    double rz = 0;
    for (std::size_t v = 0; v < n; ++v) {
      if (!is_fixed[v]) {
        inverse[v] = diagonal[v].inverse();
        r[v] = b[v];
      }
      d[v] = z[v] = inverse[v] * r[v];
      rz += r[v].dot(z[v]);
    }
    const double stop = tolerance * tolerance * rz;
    int iteration = 0;
    for (; iteration < maximum_iterations && rz > stop; ++iteration) {
      multiply(d, Ad);
      double dAd = 0;
      for (std::size_t v = 0; v < n; ++v)
        dAd += d[v].dot(Ad[v]); // d is zero in fixed rows
      if (!(dAd > 0))
        break;
      const double step = rz / dAd;
      double next = 0;
      for (std::size_t v = 0; v < n; ++v) {
        x[v] += step * d[v];
        r[v] -= step * Ad[v];
        z[v] = inverse[v] * r[v]; // zero in fixed rows
        next += r[v].dot(z[v]);
      }
      const double ratio = next / rz;
      for (std::size_t v = 0; v < n; ++v)
        d[v] = z[v] + ratio * d[v];
      rz = next;
    }
    return iteration;
  }

  std::vector<Matrix_3> diagonal;

private:
  // The Hessian is a model; single precision halves the traffic that limits the products.
  using Block = Eigen::Matrix3f;

  std::size_t slot(int i, int j) const
  {
    return std::lower_bound(columns_.begin() + offsets_[i], columns_.begin() + offsets_[i + 1], j) - columns_.begin();
  }

  void multiply(const Positions& x, Positions& y) const
  {
    for (std::size_t v = 0; v < size(); ++v)
      y[v] = diagonal[v] * x[v];
    for (std::size_t v = 0; v < size(); ++v) {
      Vector_3 sum = Vector_3::Zero();
      for (std::size_t k = offsets_[v]; k < offsets_[v + 1]; ++k) {
        const Matrix_3 B = blocks_[k].cast<double>();
        sum += B * x[columns_[k]];
        y[columns_[k]] += B.transpose() * x[v];
      }
      y[v] += sum;
    }
  }

  std::vector<std::size_t> offsets_;
  std::vector<int> columns_;
  std::vector<Block> blocks_;
  const std::vector<Hexahedron>& hexahedra_;
  std::vector<std::array<std::size_t, 28>> hexahedron_slots_; // twice the slot of each block, plus one where it is transposed
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BLOCK_MATRIX_H
