// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_INTEGER_LABELS_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_INTEGER_LABELS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Which arrays of a VTK file hold the labels of cells, and the labels in them.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/lowered.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// The label of a Medit file has no name there; in VTK files this is the usual one (of meshio).
const char* const medit_label_name = "medit:ref";

// As plain_name() makes them, the most telling first. They come from ParaView and Exodus (MaterialIds, ObjectId),
// meshio (medit:ref, gmsh:physical, cell_tags), VTK's readers (CellEntityIds), MFEM (attribute), and from habit.
const char* const usual_label_names[] = {
  "material",        "materials",   "materialid",    "materialids",   "materialnumber", "mat",
  "matid",           "matids",      "medit:ref",     "gmsh:physical", "label",          "labels",
  "labelid",         "region",      "regions",       "regionid",      "regionids",      "subdomain",
  "subdomains",      "subdomainid", "domain",        "domains",       "domainid",       "domainids",
  "block",           "blocks",      "blockid",       "blockids",      "elementblock",   "elementblockids",
  "objectid",        "part",        "parts",         "partid",        "partids",        "zone",
  "zones",           "zoneid",      "cellentityids", "celltags",      "attribute",      "attributes",
  "gmsh:geometrical"};

// In lower case, without the characters that separate words.
inline std::string plain_name(const std::string& name)
{
  std::string result;
  for (const char c : lowered(name))
    if (c != '_' && c != ' ' && c != '-')
      result += c;
  return result;
}

// False if one of the values is no integral number of 64 bits.
inline bool integer_labels(const CGAL::IO::Hex_mesh_data_array& array, std::vector<std::int64_t>& labels)
{
  return std::visit(
    [&](const auto& values) {
      using Value = typename std::decay_t<decltype(values)>::value_type;
      if constexpr (std::is_same<Value, std::string>::value)
        return false;
      else {
        labels.clear();
        labels.reserve(values.size());
        for (const Value value : values) {
          if constexpr (std::is_floating_point<Value>::value) {
            // beyond this, not every integer is a floating point number
            if (!(std::abs(value) <= Value(std::int64_t(1) << 53)) || value != std::floor(value))
              return false;
          }
          else if constexpr (std::is_same<Value, std::uint64_t>::value) {
            if (value > std::uint64_t((std::numeric_limits<std::int64_t>::max)()))
              return false;
          }
          labels.push_back(static_cast<std::int64_t>(value));
        }
        return true;
      }
    },
    array.values);
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_INTEGER_LABELS_H
