// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_ATOMIC_FILE_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_ATOMIC_FILE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Output that appears complete or not at all: written beside the target, then
// renamed over it.

#include <CGAL/Hex_mesh_optimization/IO/internal/Replaced_file.h>

#include <cstddef>
#include <fstream>
#include <string>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Atomic_file
{
public:
  explicit Atomic_file(const std::string& filename)
    : file_(filename)
    , out_(file_.written(), std::ios::binary | std::ios::trunc)
  {
    if (!out_)
      file_.fail("cannot open the file for writing");
  }

  // The text not yet in the file; call write_if_large() now and then.
  std::string& text() { return text_; }

  void write_if_large()
  {
    if (text_.size() >= (std::size_t(1) << 20))
      write();
  }

  void commit()
  {
    write();
    out_.close();
    if (!out_)
      file_.fail("cannot write the file");
    file_.commit();
  }

private:
  void write()
  {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
    if (!out_.flush())
      file_.fail("cannot write the file");
  }

  Replaced_file file_; // removed after out_ is closed, if it is not committed
  std::ofstream out_;
  std::string text_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_ATOMIC_FILE_H
