// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_INTERFACE_REFERENCES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_INTERFACE_REFERENCES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The surfaces that the caller gives for interfaces between labels, as references of the engine.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/parameter_lists.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/requirements.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_mesh_to_reference.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_soup_to_reference.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

template <class Surface>
Reference_input surface_to_reference(const Surface& surface)
{
  if constexpr (Is_soup<Surface>::value)
    return triangle_soup_to_reference(surface.first, surface.second, parameters::default_values());
  else
    return triangle_mesh_to_reference(surface, parameters::default_values());
}

template <class NamedParameters>
std::vector<Interface_reference> interface_references(const NamedParameters& np)
{
  std::vector<Interface_reference> result;
  if constexpr (is_given<NamedParameters, internal_np::hex_interface_references_t>)
    for (const auto& [labels, surface] : parameters::get_parameter(np, internal_np::hex_interface_references)) {
      const int a = static_cast<int>(std::get<0>(labels)), b = static_cast<int>(std::get<1>(labels));
      const std::array<int, 2> pair{(std::min)(a, b), (std::max)(a, b)};
      const std::string of_pair = " for the labels " + std::to_string(a) + " and " + std::to_string(b);
      for (const Interface_reference& other : result)
        if (other.labels == pair)
          throw Input_error(Input_error::Element::PARAMETER, result.size(), "there are two references" + of_pair);
      try {
        result.push_back({pair, surface_to_reference(surface)});
      }
      catch (const Input_error& error) {
        throw Input_error(error.element(), error.element_index(), error.what() + of_pair);
      }
    }
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_INTERFACE_REFERENCES_H
