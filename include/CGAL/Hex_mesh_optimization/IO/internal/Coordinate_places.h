// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_COORDINATE_PLACES_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_COORDINATE_PLACES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Where the coordinates of the points stand in a file, so that other numbers can be written there: the interface for all
// formats.

#include <CGAL/Hex_mesh_optimization/IO/internal/Replaced_file.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
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

// A copy of the input that takes the place of the output at the end, or is removed.
class Temporary_copy
{
public:
  Temporary_copy(const std::string& input, const std::string& output) : file_(output)
  {
    std::error_code error, ignored;
    std::filesystem::copy_file(input, file_.written(), error);
    if (error)
      file_.fail("cannot write the file: " + error.message());
    std::filesystem::permissions(file_.written(), std::filesystem::perms::owner_write,
                                 std::filesystem::perm_options::add, ignored);
  }

  std::string name() const { return file_.written().string(); }
  void commit() { file_.commit(); }

private:
  Replaced_file file_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_COORDINATE_PLACES_H
