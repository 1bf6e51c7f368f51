// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_REPLACED_FILE_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_REPLACED_FILE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A file that is replaced as a whole or not at all: what is new is written
// beside it, under a temporary name that it takes at the end.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Replaced_file
{
public:
  explicit Replaced_file(const std::string& filename) : filename_(filename), target_(filename)
  {
    namespace fs = std::filesystem;
    std::error_code ignored;
    // A link stays a link: what it points to is replaced.
    for (int links = 0; links < 32 && fs::is_symlink(target_, ignored); ++links) {
      const fs::path next = fs::read_symlink(target_, ignored);
      target_ = next.is_absolute() ? next : target_.parent_path() / next;
    }
    if (fs::is_directory(target_, ignored))
      fail("cannot write the file: it is a directory");
    // A device or a pipe cannot be replaced: it is written to.
    if (fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored))
      return;
    // Renaming would also replace a file that is write-protected.
    if (fs::exists(target_, ignored) && !std::ofstream(target_, std::ios::app))
      fail("cannot open the file for writing");
    static std::atomic<unsigned int> count(0);
    temporary_ = target_;
    temporary_ += "." + std::to_string(std::chrono::steady_clock::now().time_since_epoch().count()) + "_" +
                  std::to_string(count++) + ".tmp";
  }

  Replaced_file(const Replaced_file&) = delete;
  Replaced_file& operator=(const Replaced_file&) = delete;

  ~Replaced_file()
  {
    std::error_code ignored;
    if (!temporary_.empty())
      std::filesystem::remove(temporary_, ignored);
  }

  // Where to write: the temporary name, or that of what cannot be replaced.
  const std::filesystem::path& written() const { return temporary_.empty() ? target_ : temporary_; }

  // To be called when all is written and closed.
  void commit()
  {
    if (temporary_.empty())
      return;
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(target_, error);
    if (!error && std::filesystem::exists(status))
      std::filesystem::permissions(temporary_, status.permissions(), error);
    std::filesystem::rename(temporary_, target_, error);
    if (error)
      fail("cannot write the file: " + error.message());
    temporary_.clear();
  }

  [[noreturn]] void fail(const std::string& reason) const { throw CGAL::IO::Hex_mesh_file_error(filename_, 0, reason); }

private:
  std::string filename_;
  std::filesystem::path target_;
  std::filesystem::path temporary_; // empty where the target is written to
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_REPLACED_FILE_H
