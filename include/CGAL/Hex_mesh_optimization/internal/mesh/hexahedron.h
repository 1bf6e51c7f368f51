// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_HEXAHEDRON_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_HEXAHEDRON_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The reference hexahedron: its corners, edges and faces in the numbering that
// VTK and Medit share (0-3 bottom, 4-7 above them).

#include <array>

namespace CGAL::Hex_mesh_optimization::internal {

using Hexahedron = std::array<int, 8>; // the vertices at its corners

// clang-format off
// The three edge neighbors of a corner, ordered so that the determinant of the
// three edge vectors is positive in a positively oriented hexahedron.
constexpr int corner_neighbors[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                        {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};

// Seen from outside, the corners of a face run counter-clockwise.
constexpr int hexahedron_faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                        {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

// Four edges of each of the three parametric directions, equally directed.
constexpr int hexahedron_edges[12][2] = {{0, 1}, {3, 2}, {4, 5}, {7, 6},
                                         {0, 3}, {1, 2}, {4, 7}, {5, 6},
                                         {0, 4}, {1, 5}, {2, 6}, {3, 7}};

// The edge from a corner to each of its three neighbors: twice its place in
// hexahedron_edges, plus one where the table runs the other way.
constexpr int corner_edges[8][3] = {{0, 8, 16}, {10, 1, 18}, {3, 11, 20}, {9, 2, 22},
                                    {12, 4, 17}, {5, 14, 19}, {15, 7, 21}, {6, 13, 23}};
// clang-format on

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_HEXAHEDRON_H
