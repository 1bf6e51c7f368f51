// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_ATTACHMENTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_ATTACHMENTS_H

// What a mesh file holds beside points and hexahedra, carried from the reader
// to the writer.

#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::IO {

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * What a Medit file holds beside points and hexahedra. The other formats have nothing to fill in: reading
 * them clears all members, and writing them ignores all members.
 */
struct Hex_mesh_attachments
{
  /// one label per point, or empty: then 0 is written
  std::vector<std::int64_t> vertex_labels;

  /// one label per hexahedron, or empty: then 0 is written
  std::vector<std::int64_t> hexahedron_labels;

  /// all other sections (`Triangles`, `Corners`, `RequiredVertices`, ...), verbatim, in the order of the file
  std::string other_sections;
};

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_ATTACHMENTS_H
