// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_ARRAY_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_ARRAY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// One array of a .vtu file as it is written.

#include <CGAL/Hex_mesh_optimization/IO/internal/Atomic_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/base64.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/binary_number.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_as_text.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// As text, or as base64.
template <class Number>
class Vtu_array
{
public:
  Vtu_array(Atomic_file& file, const char* type, const char* attributes, std::size_t size, bool binary)
    : file_(file)
    , binary_(binary)
  {
    file_.text() += std::string("<DataArray type=\"") + type + "\" " + attributes + " format=\"" +
                    (binary ? "binary" : "ascii") + "\">\n";
    if (binary)
      append_binary(bytes_, static_cast<std::uint64_t>(size * sizeof(Number)), true);
  }

  void append(Number number, char separator)
  {
    if (binary_) {
      append_binary(bytes_, number, true);
      // A multiple of three bytes: the parts join without padding.
      if (bytes_.size() >= 3 * 4096)
        flush(bytes_.size() / 3 * 3);
    }
    else {
      append_number(file_.text(), number);
      file_.text() += separator;
    }
    file_.write_if_large();
  }

  void close()
  {
    flush(bytes_.size());
    file_.text() += binary_ ? "\n</DataArray>\n" : "</DataArray>\n";
  }

private:
  void flush(std::size_t size)
  {
    append_base64(file_.text(), std::string_view(bytes_).substr(0, size));
    bytes_.erase(0, size);
  }

  Atomic_file& file_;
  bool binary_;
  std::string bytes_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_ARRAY_H
