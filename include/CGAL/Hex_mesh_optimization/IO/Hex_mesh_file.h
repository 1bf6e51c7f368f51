// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_FILE_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_FILE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What a file of a solver has, and where its coordinates stand: all that is
// needed to write it again with points that have moved.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {
class Coordinate_places;
} // namespace CGAL::Hex_mesh_optimization::internal::IO

namespace CGAL::IO {

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * A named set of a mesh file: a node set, a side set, a physical group, a patch.
 */
struct Hex_mesh_set
{
  /// What its members are.
  enum class Kind {
    VERTICES, ///< points
    FACES,    ///< sides of cells, or cells that are faces
    CELLS     ///< all other cells
  };

  Kind kind = Kind::VERTICES;                    ///< of its members
  std::string name;                              ///< in the file, or made of its number there
  std::size_t size = 0;                          ///< the number of its members
  std::vector<std::size_t> vertices;             ///< its points, or those of its members, in increasing order
  std::vector<std::array<std::size_t, 4>> faces; ///< its quadrilaterals
};

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * What a file of a solver holds, as `read_hex_mesh_file()` finds it, and where its coordinates stand, for
 * `copy_hex_mesh_file()`.
 */
struct Hex_mesh_file
{
  /// A point whose place is given by those of the corners of a hexahedron: a node of an edge, a face, the middle.
  struct Follower
  {
    std::size_t point;                  ///< the one that goes along
    std::array<std::size_t, 8> corners; ///< of a hexahedron that has it
    std::array<double, 8> weights;      ///< of the displacements of the corners
  };

  /// Two points that move together.
  struct Periodic_pair
  {
    std::size_t first;                 ///< the index of a point
    std::size_t second;                ///< the index of another point
    std::array<double, 3> translation; ///< from the first to the second
  };

  std::string format;                                ///< in words
  std::vector<std::array<double, 3>> points;         ///< all points of the file, in its order
  std::vector<std::array<std::size_t, 8>> hexahedra; ///< corners, in the order of VTK or all mirrored
  std::vector<std::int64_t> labels;                  ///< one for each hexahedron
  std::map<std::int64_t, std::string> label_names;   ///< of those that have one

  std::vector<Hex_mesh_cell> other_cells;    ///< as far as VTK has a type for them
  std::vector<std::size_t> held_points;      ///< corners of hexahedra that must not move, in increasing order
  std::vector<Follower> followers;           ///< each point once
  std::vector<Periodic_pair> periodic_pairs; ///< in the order of the file
  std::vector<Hex_mesh_set> sets;            ///< all that have a name or a number

  /// whether points of the boundary have to stay on it exactly: planes of symmetry, the sides of a plane case
  bool has_exact_surfaces = false;

  std::size_t number_of_other_solids = 0;         ///< tetrahedra, wedges, pyramids, ...: their points are held
  std::size_t number_of_high_order_hexahedra = 0; ///< with more than eight nodes
  std::vector<std::string> notes;                 ///< what a user should know

  /// where the coordinates stand, for `copy_hex_mesh_file()`
  std::shared_ptr<const Hex_mesh_optimization::internal::IO::Coordinate_places> places;

  /// the set with this name, exactly or, if there is none, in upper or lower case; `nullptr` if there is none.
  const Hex_mesh_set* find_set(const std::string& name) const
  {
    namespace io = Hex_mesh_optimization::internal::IO;
    for (const Hex_mesh_set& set : sets)
      if (set.name == name)
        return &set;
    for (const Hex_mesh_set& set : sets)
      if (io::lowered(set.name) == io::lowered(name))
        return &set;
    return nullptr;
  }
};

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_FILE_H
