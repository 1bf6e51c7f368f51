// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_COORDINATE_PLACES_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_COORDINATE_PLACES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Where the coordinates of the points stand in a file, so that other numbers can be written there: the interface for all
// formats.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Coordinate_places
{
public:
  using Triple = std::array<double, 3>;

  virtual ~Coordinate_places() = default;

  // What is read back when the point is written at `after`; coordinates that have not changed keep their bytes.
  virtual Triple rounded(std::size_t point, const Triple& before, const Triple& after) const = 0;

  // About how far apart numbers near `coordinates` are, that can be written for the point.
  virtual double resolution(std::size_t point, const Triple& coordinates) const = 0;

  // Throws if the copy would overwrite a file of the input that is not `output`, given the points that may move.
  virtual void check_output(const std::string& output, const std::vector<char>& may_move) const = 0;

  // Copies the file, with the numbers of points that differ from `before` replaced. Complete or not at all.
  virtual void write(const std::string& output, const std::vector<Triple>& before,
                     const std::vector<Triple>& after) const = 0;
};

// A name beside the target, which is renamed to it at the end, or removed.
class Temporary_copy
{
public:
  Temporary_copy(const std::string& input, const std::string& output) : output_(output), target_(output)
  {
    namespace fs = std::filesystem;
    std::error_code ignored;
    for (int links = 0; links < 32 && fs::is_symlink(target_, ignored); ++links) {
      const fs::path next = fs::read_symlink(target_, ignored);
      target_ = next.is_absolute() ? next : target_.parent_path() / next;
    }
    if (fs::is_directory(target_, ignored))
      fail("it is a directory");
    if (fs::exists(target_, ignored) && !std::ofstream(target_, std::ios::app))
      fail("it cannot be opened");
    static std::atomic<unsigned int> count(0);
    temporary_ = target_;
    temporary_ += "." + std::to_string(std::chrono::steady_clock::now().time_since_epoch().count()) + "_" +
                  std::to_string(count++) + ".tmp";
    std::error_code error;
    fs::copy_file(input, temporary_, error);
    if (error)
      fail(error.message());
    fs::permissions(temporary_, fs::perms::owner_write, fs::perm_options::add, ignored);
  }
  Temporary_copy(const Temporary_copy&) = delete;
  Temporary_copy& operator=(const Temporary_copy&) = delete;
  ~Temporary_copy()
  {
    std::error_code ignored;
    if (!temporary_.empty())
      std::filesystem::remove(temporary_, ignored);
  }

  std::string name() const { return temporary_.string(); }

  void commit()
  {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(target_, error);
    if (!error && std::filesystem::exists(status))
      std::filesystem::permissions(temporary_, status.permissions(), error);
    std::filesystem::rename(temporary_, target_, error);
    if (error)
      fail(error.message());
    temporary_.clear();
  }

private:
  [[noreturn]] void fail(const std::string& reason) const
  {
    throw CGAL::IO::Hex_mesh_file_error(output_, 0, "cannot write the file: " + reason);
  }

  std::string output_;
  std::filesystem::path target_, temporary_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_COORDINATE_PLACES_H
