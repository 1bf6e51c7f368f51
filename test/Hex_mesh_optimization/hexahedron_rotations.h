// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_HEXAHEDRON_ROTATIONS_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_HEXAHEDRON_ROTATIONS_H

// The 48 numberings of one hexahedron: 24 rotations, 24 reflections.

#include <algorithm>
#include <array>
#include <vector>

// Parametric coordinates of the corners
constexpr int unit_corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                    {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

// The numberings that result from symmetries of the cube with this determinant, 1 or -1.
inline std::vector<std::array<int, 8>> numberings(int determinant)
{
  std::vector<std::array<int, 8>> result;
  std::array<int, 3> axes = {{0, 1, 2}};
  do {
    const int inversions = (axes[0] > axes[1]) + (axes[0] > axes[2]) + (axes[1] > axes[2]);
    for (int flips = 0; flips < 8; ++flips) {
      const int flip[3] = {flips & 1, flips >> 1 & 1, flips >> 2};
      const int sign = (inversions + flip[0] + flip[1] + flip[2]) % 2 == 0 ? 1 : -1;
      if (sign != determinant)
        continue;
      std::array<int, 8> numbering;
      for (int corner = 0; corner < 8; ++corner)
        for (int image = 0; image < 8; ++image) {
          bool same = true;
          for (int d = 0; d < 3; ++d)
            same = same && unit_corners[image][d] == (unit_corners[corner][axes[d]] ^ flip[d]);
          if (same)
            numbering[corner] = image;
        }
      result.push_back(numbering);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return result;
}

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_HEXAHEDRON_ROTATIONS_H
