// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_PARAMETER_LISTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_PARAMETER_LISTS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What a list of named parameters has.

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

#ifndef CGAL_HEX_MESH_OPTIMIZATION_EXTENDS_NAMED_PARAMETERS
#error                                                                                                                 \
  "CGAL's own headers come before those of Hex_mesh_optimization: link CGAL::Hex_mesh_optimization before CGAL::CGAL, or put -I <Hex_mesh_optimization>/STL_Extension before the folder of CGAL"
#include <CGAL_Hex_mesh_optimization/STL_Extension/must_come_first> // ends the compilation: nothing else would be of interest
#endif

namespace CGAL::Hex_mesh_optimization::internal {

template <class T>
struct Is_named_parameters : std::false_type
{};
template <class T, class Tag, class Base>
struct Is_named_parameters<Named_function_parameters<T, Tag, Base>> : std::true_type
{};

template <class NamedParameters, class Tag>
constexpr bool is_given = !std::is_same_v<
  typename internal_np::Lookup_named_param_def<Tag, NamedParameters, internal_np::Param_not_found>::type,
  internal_np::Param_not_found>;

template <class NamedParameters, class... Tags>
constexpr bool is_one_given = (is_given<NamedParameters, Tags> || ...);

// Whether a list has nothing but what is listed.
template <class NamedParameters, class... Tags>
struct Has_only : std::true_type
{};
template <class T, class Tag, class Base, class... Tags>
struct Has_only<Named_function_parameters<T, Tag, Base>, Tags...>
  : std::bool_constant<(std::is_same_v<Tag, internal_np::all_default_t> || ... ||
                        std::is_same_v<Tag, Tags>)&&Has_only<Base, Tags...>::value>
{};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_PARAMETER_LISTS_H
