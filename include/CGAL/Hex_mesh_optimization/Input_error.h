// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INPUT_ERROR_H
#define CGAL_HEX_MESH_OPTIMIZATION_INPUT_ERROR_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The exception that refuses an unusable mesh or reference surface, naming the
// first element at fault.

#include <CGAL/exceptions.h>

#include <cstddef>
#include <string>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * Thrown before anything is moved when a mesh, a reference surface or a
 * parameter cannot be used.
 */
class Input_error : public CGAL::Precondition_exception
{
public:
  /// The kind of the element at fault; `element_index()` counts in the order of the input.
  enum class Element { MESH, VERTEX, HEXAHEDRON, REFERENCE_VERTEX, REFERENCE_FACE, PARAMETER };

  /// index: of the element, 0 for those that are one of a kind.
  Input_error(Element element, std::size_t index, const std::string& message)
    : CGAL::Precondition_exception("CGAL", "valid input", "", 0, message)
    , element_(element)
    , index_(index)
    , message_(message)
  {}

  /// The message alone, which names the element: a sentence for the user of a program, not for its author.
  const char* what() const noexcept override { return message_.c_str(); }

  /// What is at fault.
  Element element() const { return element_; }

  /// Which one of its kind.
  std::size_t element_index() const { return index_; }

private:
  Element element_;
  std::size_t index_;
  std::string message_;
};

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_INPUT_ERROR_H
