// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_OPTIMIZE_HEX_MESH_FILE_MPI_H
#define CGAL_OPTIMIZE_HEX_MESH_FILE_MPI_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Optimizes a mesh in a file by the processes of an MPI program, none of which has all of it. It needs PETSc.

#include <CGAL/optimize_hex_mesh_file.h>

#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_PETSC
#include <CGAL/Hex_mesh_optimization/IO/internal/Mpi_vtu_slices.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Petsc_ranks.h>
#endif

#include <string>
#include <type_traits>

namespace CGAL {

#if defined(CGAL_HEX_MESH_OPTIMIZATION_USE_PETSC) || defined(DOXYGEN_RUNNING)
/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * optimizes the hexahedral mesh in a file as `CGAL::optimize_hex_mesh_file()` does, which writes the same bytes for the same
 * number of parts, whatever the number of ranks. Each rank reads a slice of the file, has some of the parts, and writes its
 * points to the output by MPI-IO, which all ranks must be able to open.
 *
 * It is there if the macro `CGAL_HEX_MESH_OPTIMIZATION_USE_PETSC` is defined. All ranks call it, with the same arguments but
 * for the visitor: that of a rank sees the iterations of its own parts, and ends the run of all.
 *
 * \param communicator the ranks, of which PETSc has been initialized with all
 * \param input the file to read, as for `CGAL::optimize_hex_mesh_file()`
 * \param output the file to write; it may be `input`
 * \param division how the mesh is divided; where it does not say so, there are as many parts as ranks
 * \param np as for `CGAL::optimize_hex_mesh_file()`
 *
 * \return the same on all ranks, but for times
 *
 * \throws Hex_mesh_optimization::Input_error and IO::Hex_mesh_file_error as `CGAL::optimize_hex_mesh_file()`, on some of the
 *         ranks: the others wait in vain then, and the program is to call `MPI_Abort()`
 */
template <class ConcurrencyTag = CGAL::Sequential_tag, class NamedParameters = parameters::Default_named_parameters>
Hex_mesh_optimization::Status optimize_hex_mesh_file_mpi(
  MPI_Comm communicator, const std::string& input, const std::string& output,
  const Hex_mesh_optimization::Mesh_division& division = Hex_mesh_optimization::Mesh_division(),
  const NamedParameters& np = parameters::default_values())
{
  namespace internal = Hex_mesh_optimization::internal;
  internal::Chosen_parameters chosen = internal::parameters_of_parts(np);
  chosen.is_parallel = std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value;
  internal::Petsc_ranks ranks(communicator);
  internal::IO::Mpi_vtu_slices slices(input, output, division.label_array, ranks);
  internal::Parts_parameters parts = internal::parts_parameters(division, slices.number_of_hexahedra());
  if (division.number_of_parts == 0)
    parts.number_of_parts = ranks.size();
  return internal::run_in_parts(slices, ranks, chosen, parts);
}
#endif

} // namespace CGAL

#endif // CGAL_OPTIMIZE_HEX_MESH_FILE_MPI_H
