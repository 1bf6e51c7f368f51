// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_OPTIMIZE_HEX_MESH_FILE_H
#define CGAL_OPTIMIZE_HEX_MESH_FILE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Optimizes a mesh in a file part by part, so that it need not fit into memory.

#include <CGAL/Hex_mesh_optimization/IO/internal/Vtu_slices.h>
#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/Mesh_division.h>
#include <CGAL/Hex_mesh_optimization/Status.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/named_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/requirements.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Parts_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Ranks.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/run_in_parts.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {

namespace Hex_mesh_optimization {
namespace internal {

// Of the named parameters, those that do not depend on a mesh in memory.
template <class NamedParameters>
Chosen_parameters parameters_of_parts(const NamedParameters& np)
{
  static_assert(
    !is_one_given<NamedParameters, internal_np::hex_internal_faces_t, internal_np::hex_interface_references_t,
                  internal_np::hex_periodic_vertices_t, internal_np::hex_target_edge_length_map_t,
                  internal_np::hexahedron_label_map_t, internal_np::vertex_is_constrained_t>,
    "a parameter that refers to vertices or hexahedra cannot be given for a mesh in a file");
  static const std::vector<std::size_t> no_keys;
  return chosen_parameters(np, no_keys);
}

inline Parts_parameters parts_parameters(const Mesh_division& division, Global_index number_of_hexahedra)
{
  Parts_parameters result;
  if (division.layers < 1)
    throw Input_error(Input_error::Element::PARAMETER, 0,
                      "there must be at least one layer around what parts have held");
  result.layers = division.layers;
  result.number_of_parts = division.number_of_parts_of(static_cast<std::size_t>(number_of_hexahedra));
  return result;
}

} // namespace internal
} // namespace Hex_mesh_optimization

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * optimizes the hexahedral mesh in a file as `CGAL::optimize_hex_mesh()` does a mesh with its boundary as the reference, but
 * part by part, one after the other. In memory are one part and a few hundred bytes for each face of the boundary; the rest is
 * mapped from temporary files in the folder of the output. The output is a copy of the input with other points. It appears
 * complete or not at all, and may be the input.
 *
 * Vertices that hexahedra of several parts have are held while the parts are optimized; then hexahedra around these are
 * optimized in other parts. The result depends on the number of parts, and is as good as that of a run in one piece but for
 * a little; see \ref HexMeshOptimizationParts.
 *
 * \tparam ConcurrencyTag as for `CGAL::optimize_hex_mesh()`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param input a `.vtu` file with one piece, of hexahedra only that agree which way is out, whose points are of 64 bits and
 *        whose data are appended, neither encoded nor compressed
 * \param output the file to write
 * \param division how the mesh is divided
 * \param np those of the parameters of `CGAL::optimize_hex_mesh()` that do not refer to vertices or hexahedra
 *
 * \return as `CGAL::optimize_hex_mesh()`; of ratios of edges in single precision, without the limits of the connectivity,
 *         locked hexahedra and coincident vertices. The visitor sees the iterations of each part.
 *
 * \throws Hex_mesh_optimization::Input_error as `CGAL::optimize_hex_mesh()`
 * \throws IO::Hex_mesh_file_error if the input cannot be read, or is of another kind, or the output cannot be written
 */
template <class ConcurrencyTag = CGAL::Sequential_tag, class NamedParameters = parameters::Default_named_parameters>
Hex_mesh_optimization::Status
optimize_hex_mesh_file(const std::string& input, const std::string& output,
                       const Hex_mesh_optimization::Mesh_division& division = Hex_mesh_optimization::Mesh_division(),
                       const NamedParameters& np = parameters::default_values())
{
  namespace internal = Hex_mesh_optimization::internal;
  internal::Chosen_parameters chosen = internal::parameters_of_parts(np);
  chosen.is_parallel = std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value;
  internal::IO::Vtu_slices slices(input, output, division.label_array);
  internal::Parts_parameters parts = internal::parts_parameters(division, slices.number_of_hexahedra());
  parts.folder = std::filesystem::absolute(output).parent_path().string();
  internal::Ranks alone;
  return internal::run_in_parts(slices, alone, chosen, parts);
}

} // namespace CGAL

#endif // CGAL_OPTIMIZE_HEX_MESH_FILE_H
