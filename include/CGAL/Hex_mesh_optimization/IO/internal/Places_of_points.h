// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_PLACES_OF_POINTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_PLACES_OF_POINTS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Where the coordinates stand in files of Medit and VTK whose points are text or binary doubles, so that these files are copied
// with nothing else changed as well.

#include <CGAL/Hex_mesh_optimization/IO/internal/Number_places.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/extension_of.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/lowered.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/split_fields.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Places_of_points
{
public:
  // `points`: as a reader of the format has found them. The places are `nullptr` where the points are in another form,
  // such as compressed ones.
  Places_of_points(const std::string& filename, const std::vector<std::array<double, 3>>& points)
    : places_(std::make_shared<Number_places>())
    , points_(points)
  {
    places_->files.emplace_back(filename, std::filesystem::path(filename).filename().string());
    const std::string extension = extension_of(filename);
    bool is_found = false;
    if (!places_->files[0].is_compressed)
      try {
        is_found = extension == "mesh"  ? find_in_medit()
                   : extension == "vtk" ? find_in_vtk()
                   : extension == "vtu" ? find_in_vtu()
                                        : false;
      }
      catch (const CGAL::IO::Hex_mesh_file_error&) { // that reader knows more than this one
      }
    if (!is_found || places_->places.size() != points.size())
      places_ = nullptr;
  }

  std::shared_ptr<const Number_places> places() const { return places_; }

private:
  using Form = Number_place::Form;

  const std::string& text() const { return places_->files[0].content; }

  // The same numbers as the reader found.
  bool add_words(Text_scanner& scanner, bool has_label)
  {
    for (const std::array<double, 3>& p : points_) {
      places_->places.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const std::string_view word = scanner.word();
        double value = 0;
        if (!parse_number(word, value) || value != p[i])
          return false;
        Number_place& place = places_->places.back()[i];
        place.begin = static_cast<std::size_t>(word.data() - text().data());
        place.length = static_cast<std::uint32_t>(word.size());
        place.form = Form::FREE;
      }
      if (has_label)
        scanner.word();
    }
    return true;
  }

  bool add_binary(std::size_t begin, Form form)
  {
    if (begin > text().size() || (text().size() - begin) / 24 < points_.size())
      return false;
    for (const std::array<double, 3>& p : points_) {
      places_->places.emplace_back();
      for (std::size_t i = 0; i < 3; ++i, begin += 8) {
        if (binary_value(&text()[begin], form) != p[i])
          return false;
        Number_place& place = places_->places.back()[i];
        place.begin = begin;
        place.length = 8;
        place.form = form;
      }
    }
    return true;
  }

  bool find_in_medit()
  {
    Text_scanner scanner(places_->files[0].filename, text(), '#');
    for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
      if (word == "Vertices")
        return scanner.count("the number of vertices", 8) == points_.size() && add_words(scanner, true);
    return false;
  }

  // Grids that are no unstructured ones become such.
  bool find_in_vtk()
  {
    Text_scanner scanner(places_->files[0].filename, text());
    scanner.rest_of_line();
    scanner.rest_of_line();
    const std::string format = lowered(std::string(scanner.word()));
    if (lowered(std::string(scanner.word())) != "dataset" ||
        lowered(std::string(scanner.word())) != "unstructured_grid" ||
        lowered(std::string(scanner.word())) != "points" || scanner.natural("the number of points") != points_.size())
      return false;
    const std::string type = lowered(std::string(scanner.word()));
    if (format == "ascii")
      return add_words(scanner, false);
    scanner.rest_of_line();
    return format == "binary" && type == "double" && add_binary(scanner.position(), Form::BIG_DOUBLE);
  }

  // One piece, whose points are text.
  bool find_in_vtu()
  {
    const std::size_t begin = text().find("<Points>");
    if (begin == std::string::npos || text().find("<Points>", begin + 1) != std::string::npos)
      return false;
    const std::size_t array = text().find("<DataArray", begin), end = text().find('>', array);
    if (array == std::string::npos || end == std::string::npos)
      return false;
    const std::string tag = text().substr(array, end - array);
    if (tag.find("format=\"ascii\"") == std::string::npos)
      return false;
    Text_scanner scanner(places_->files[0].filename, text());
    scanner.skip(end + 1);
    return add_words(scanner, false);
  }

  std::shared_ptr<Number_places> places_;
  const std::vector<std::array<double, 3>>& points_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_PLACES_OF_POINTS_H
