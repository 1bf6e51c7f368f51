// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_DATA_ARRAY_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_DATA_ARRAY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// One array of a VTK file: numbers or strings on points, on cells, or on the
// mesh as a whole.

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::IO {

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * An array of a `.vtk` or `.vtu` file, with the type that its values have there.
 */
struct Hex_mesh_data_array
{
  /// What the file says that an array is for. Arrays without a role are in a `FIELD` of a `.vtk` file.
  enum class Role {
    NONE,
    SCALARS,
    VECTORS,
    NORMALS,
    TENSORS,
    TEXTURE_COORDINATES,
    GLOBAL_IDS,
    PEDIGREE_IDS,
    EDGE_FLAGS,
    COLOR_SCALARS,
    LOOKUP_TABLE ///< of four components, and as many tuples as it has colors
  };

  /// `std::vector<bool>` stands for the type `bit`.
  using Values = std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                              std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                              std::vector<std::int64_t>, std::vector<std::uint64_t>, std::vector<float>,
                              std::vector<double>, std::vector<bool>, std::vector<std::string>>;

  std::string name;                     ///< as in the file
  Role role = Role::NONE;               ///< what it is for
  std::size_t number_of_components = 1; ///< of a tuple
  Values values;                        ///< tuple after tuple

  /// the name of the type in a `.vtk` file, where several stand for it (`long`, `vtkIdType`), or empty
  std::string type_name;

  std::string lookup_table; ///< the name of the table of a `.vtk` file that scalars are shown with, or empty

  /// what else a `.vtk` file says of the array, as the text of its `METADATA` block, or empty
  std::string metadata;

  /// what else a `.vtu` file says of the array: attributes of the XML element, such as the names of components
  std::vector<std::pair<std::string, std::string>> attributes;

  /// the number of values
  std::size_t size() const
  {
    return std::visit([](const auto& v) { return v.size(); }, values);
  }

  /// the number of whole tuples
  std::size_t number_of_tuples() const { return number_of_components == 0 ? 0 : size() / number_of_components; }
};

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_DATA_ARRAY_H
