// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_ROLES_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_ROLES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The attributes by which PointData and CellData of a .vtu file name the array
// for each purpose.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>

namespace CGAL::Hex_mesh_optimization::internal::IO {

struct Vtu_role
{
  const char* attribute;
  CGAL::IO::Hex_mesh_data_array::Role role;
};

const Vtu_role vtu_roles[] = {{"Scalars", CGAL::IO::Hex_mesh_data_array::Role::SCALARS},
                              {"Vectors", CGAL::IO::Hex_mesh_data_array::Role::VECTORS},
                              {"Normals", CGAL::IO::Hex_mesh_data_array::Role::NORMALS},
                              {"Tensors", CGAL::IO::Hex_mesh_data_array::Role::TENSORS},
                              {"TCoords", CGAL::IO::Hex_mesh_data_array::Role::TEXTURE_COORDINATES},
                              {"GlobalIds", CGAL::IO::Hex_mesh_data_array::Role::GLOBAL_IDS},
                              {"PedigreeIds", CGAL::IO::Hex_mesh_data_array::Role::PEDIGREE_IDS}};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_ROLES_H
