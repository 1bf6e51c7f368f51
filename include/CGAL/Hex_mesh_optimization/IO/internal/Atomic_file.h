// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_ATOMIC_FILE_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_ATOMIC_FILE_H

// Output that appears complete or not at all: written beside the target, then
// renamed over it.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Atomic_file
{
public:
  explicit Atomic_file(const std::string& filename) : filename_(filename), target_(filename)
  {
    namespace fs = std::filesystem;
    std::error_code ignored;
    // A link stays a link: what it points to is replaced.
    for (int links = 0; links < 32 && fs::is_symlink(target_, ignored); ++links) {
      const fs::path next = fs::read_symlink(target_, ignored);
      target_ = next.is_absolute() ? next : target_.parent_path() / next;
    }
    if (fs::is_directory(target_, ignored))
      throw CGAL::IO::Hex_mesh_file_error(filename_, 0, "cannot write the file: it is a directory");
    // A device or a pipe cannot be replaced: it is written to.
    const bool replaced = !fs::exists(target_, ignored) || fs::is_regular_file(target_, ignored);
    // Renaming would also replace a file that is write-protected.
    if (fs::exists(target_, ignored) && replaced && !std::ofstream(target_, std::ios::app))
      throw CGAL::IO::Hex_mesh_file_error(filename_, 0, "cannot open the file for writing");
    if (replaced) {
      static std::atomic<unsigned int> count(0);
      temporary_ = target_;
      temporary_ += "." + std::to_string(std::chrono::steady_clock::now().time_since_epoch().count()) + "_" +
                    std::to_string(count++) + ".tmp";
    }
    out_.open(replaced ? temporary_ : target_, std::ios::binary | std::ios::trunc);
    if (!out_) {
      temporary_.clear();
      throw CGAL::IO::Hex_mesh_file_error(filename_, 0, "cannot open the file for writing");
    }
  }

  Atomic_file(const Atomic_file&) = delete;
  Atomic_file& operator=(const Atomic_file&) = delete;

  ~Atomic_file()
  {
    if (!temporary_.empty()) {
      out_.close();
      std::error_code ignored;
      std::filesystem::remove(temporary_, ignored);
    }
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
      throw CGAL::IO::Hex_mesh_file_error(filename_, 0, "cannot write the file");
    if (temporary_.empty())
      return;
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(target_, error);
    if (!error && std::filesystem::exists(status))
      std::filesystem::permissions(temporary_, status.permissions(), error);
    std::filesystem::rename(temporary_, target_, error);
    if (error)
      throw CGAL::IO::Hex_mesh_file_error(filename_, 0, "cannot write the file: " + error.message());
    temporary_.clear();
  }

private:
  void write()
  {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
    if (!out_.flush())
      throw CGAL::IO::Hex_mesh_file_error(filename_, 0, "cannot write the file");
  }

  std::string filename_;
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  std::ofstream out_;
  std::string text_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_ATOMIC_FILE_H
