// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_LINEAR_CELL_COMPLEX_TRAITS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_LINEAR_CELL_COMPLEX_TRAITS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What a linear cell complex of the caller's is, for all versions of CGAL, and where
// the darts of a hexahedron are.

#include <CGAL/version.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {

struct Generalized_map_tag;

namespace Hex_mesh_optimization {
namespace internal {

template <class T, class = void>
struct Is_linear_cell_complex : std::false_type
{};
template <class T>
struct Is_linear_cell_complex<T, std::void_t<typename T::Dart_range, typename T::Vertex_attribute_range>>
  : std::true_type
{};

template <class LCC>
constexpr bool is_generalized_map_v =
  std::is_same<typename LCC::Combinatorial_data_structure, Generalized_map_tag>::value;

// CGAL 5.6 renamed handles to descriptors.
template <class LCC>
struct Linear_cell_complex_types
{
#if CGAL_VERSION_NR >= 1050600000
  using Dart = typename LCC::Dart_const_descriptor;
  using Vertex = typename LCC::Vertex_attribute_descriptor;
  template <class Vertex>
  static bool is_null(const Vertex& vertex)
  {
    return vertex == LCC::null_descriptor;
  }
#else
  using Dart = typename LCC::Dart_const_handle;
  using Vertex = typename LCC::Vertex_attribute_handle;
  template <class Vertex>
  static bool is_null(const Vertex& vertex)
  {
    return vertex == LCC::null_handle;
  }
#endif
};

// From the dart that make_hexahedron() returns, which goes from corner 0 to
// corner 4 in face 2, the dart of face `face` that starts at that face's first
// corner. The darts of a hexahedron turn opposite to hexahedron_faces.
template <class LCC, class Dart>
Dart dart_of_face(LCC& lcc, Dart dart, std::size_t face)
{
  switch (face) {
  case 0:
    return lcc.opposite2(lcc.previous(dart));
  case 1:
    return lcc.next(lcc.opposite2(lcc.next(dart)));
  case 2:
    return dart;
  default:
    for (; face > 2; --face)
      dart = lcc.opposite2(lcc.next(lcc.next(dart)));
    return dart;
  }
}

}
}
} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_LINEAR_CELL_COMPLEX_TRAITS_H
