// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_NUMBER_PLACES_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_NUMBER_PLACES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Coordinates that stand in files as text or as binary numbers, each with its place: the files are copied with other numbers
// in these places, and not a byte more is changed.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Atomic_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Coordinate_frame.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Coordinate_places.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/gzip.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_in_width.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/read_whole_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// A file in memory.
struct Source_file
{
  Source_file() = default;

  // `relative_name`: to the folder of the first file
  Source_file(const std::string& path, const std::string& relative_name) : filename(path), name(relative_name)
  {
    content = read_whole_file(filename);
    is_compressed = is_gzip(content);
    if (is_compressed)
      content = gunzip(filename, content);
  }

  std::size_t line_of(std::size_t position) const
  {
    return 1 + static_cast<std::size_t>(
                 std::count(content.begin(),
                            content.begin() + static_cast<std::ptrdiff_t>(std::min(position, content.size())), '\n'));
  }

  [[noreturn]] void fail(std::size_t position, const std::string& reason) const
  {
    throw CGAL::IO::Hex_mesh_file_error(filename, line_of(position), reason);
  }

  std::string filename, name;
  std::string content;
  bool is_compressed = false;
};

// The place of one number.
struct Number_place
{
  enum class Form : std::uint8_t {
    ABSENT,         // left out, which means 0: nothing can be written
    FREE,           // text between separators
    LIMITED,        // the same, of at most `width` characters
    NASTRAN_FREE,   // the same in the style of Nastran
    NASTRAN_COLUMN, // text in the columns of a field, up to `width` of them
    LITTLE_DOUBLE,
    BIG_DOUBLE,
    LITTLE_FLOAT,
    BIG_FLOAT
  };

  std::size_t begin = 0;
  std::uint32_t length = 0;
  std::uint16_t file = 0;
  Form form = Form::ABSENT;
  std::uint8_t width = 0;
};

inline std::size_t binary_size(Number_place::Form form)
{
  using Form = Number_place::Form;
  return form == Form::LITTLE_DOUBLE || form == Form::BIG_DOUBLE ? 8 : 4;
}

// Of a form that is binary.
inline double binary_value(const char* bytes, Number_place::Form form)
{
  using Form = Number_place::Form;
  const std::size_t size = binary_size(form);
  char ordered[8];
  const std::uint16_t one = 1;
  const bool is_little = *reinterpret_cast<const unsigned char*>(&one) == 1;
  const bool same = is_little == (form == Form::LITTLE_DOUBLE || form == Form::LITTLE_FLOAT);
  for (std::size_t i = 0; i < size; ++i)
    ordered[i] = bytes[same ? i : size - 1 - i];
  if (size == 8) {
    double value;
    std::memcpy(&value, ordered, 8);
    return value;
  }
  float value;
  std::memcpy(&value, ordered, 4);
  return value;
}

inline std::string binary_text(double value, Number_place::Form form)
{
  using Form = Number_place::Form;
  const std::size_t size = binary_size(form);
  char bytes[8];
  if (size == 8)
    std::memcpy(bytes, &value, 8);
  else {
    const float narrow = static_cast<float>(value);
    std::memcpy(bytes, &narrow, 4);
  }
  const std::uint16_t one = 1;
  const bool is_little = *reinterpret_cast<const unsigned char*>(&one) == 1;
  if (is_little != (form == Form::LITTLE_DOUBLE || form == Form::LITTLE_FLOAT))
    std::reverse(bytes, bytes + size);
  return std::string(bytes, size);
}

class Number_places : public Coordinate_places
{
public:
  std::vector<Source_file> files; // the first is the one that the user has named
  std::vector<std::array<Number_place, 3>> places;
  std::vector<Coordinate_frame> frames;
  std::vector<std::int32_t> frame_of; // for each point, or -1; empty if none has one
  std::string folder;                 // if not empty: all of it is copied, and `name` is relative to it

  Triple rounded(std::size_t point, const Triple& before, const Triple& after) const override
  {
    if (before == after)
      return after;
    const Triple old = in_frame(point, before);
    Triple local = in_frame(point, after);
    for (int i = 0; i < 3; ++i)
      if (local[i] != old[i])
        local[i] = rounded(places[point][i], local[i]);
    return frame(point) == nullptr ? local : frame(point)->to_basic(local);
  }

  double resolution(std::size_t point, const Triple& coordinates) const override
  {
    double result = 0;
    for (int i = 0; i < 3; ++i) {
      const Number_place& place = places[point][i];
      const double x = std::abs(coordinates[i]);
      const double size = std::pow(10., std::floor(std::log10(x > 0 ? x : 1.)));
      result = std::max(result, is_text(place.form) && place.width > 0
                                  ? size * std::pow(10., -std::max(2., place.width - (x < 1e-3 ? 5. : 2.)))
                                  : x * (binary_size(place.form) == 4 && !is_text(place.form) ? 1.2e-7 : 0.));
    }
    return result;
  }

  void check_output(const std::string& output, const std::vector<char>& may_move) const override
  {
    std::vector<char> is_touched(files.size(), false);
    for (std::size_t v = 0; v < places.size(); ++v)
      if (may_move[v])
        for (const Number_place& place : places[v])
          is_touched[place.file] = true;
    check_outside(is_touched);
    if (is_same(output))
      return;
    for (std::size_t f = folder.empty() ? 1 : 0; f < files.size(); ++f)
      if (is_touched[f] && are_same(files[f].filename, target(f, output)))
        throw CGAL::IO::Hex_mesh_file_error(
          output, 0,
          "coordinates stand in the included file " + files[f].name +
            ", which would be overwritten: write to another folder, or to the name of the input");
  }

  void write(const std::string& output, const std::vector<Triple>& before,
             const std::vector<Triple>& after) const override
  {
    std::vector<std::vector<Edit>> edits(files.size());
    for (std::size_t v = 0; v < places.size(); ++v)
      if (before[v] != after[v]) {
        const Triple local = in_frame(v, after[v]);
        const Triple old = in_frame(v, before[v]);
        for (int i = 0; i < 3; ++i) {
          const Number_place& place = places[v][i];
          if (place.form != Number_place::Form::ABSENT && local[i] != old[i])
            edits[place.file].push_back({place.begin, place.length, text_at(place, local[i])});
        }
      }
    if (!folder.empty())
      copy_folder(output);
    for (std::size_t f = 0; f < files.size(); ++f) {
      std::sort(edits[f].begin(), edits[f].end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
      if (!edits[f].empty())
        write_edited(files[f], target(f, output), edits[f]);
      else if (folder.empty())
        copy_unchanged(f, output);
    }
  }

private:
  struct Edit
  {
    std::size_t begin, length;
    std::string text;
  };

  static bool is_text(Number_place::Form form) { return form < Number_place::Form::LITTLE_DOUBLE; }

  const Coordinate_frame* frame(std::size_t point) const
  {
    return frame_of.empty() || frame_of[point] < 0 ? nullptr : &frames[static_cast<std::size_t>(frame_of[point])];
  }

  Triple in_frame(std::size_t point, const Triple& p) const
  {
    return frame(point) == nullptr ? p : frame(point)->from_basic(p);
  }

  static double rounded(const Number_place& place, double value)
  {
    using Form = Number_place::Form;
    switch (place.form) {
    case Form::ABSENT:
      return 0;
    case Form::LITTLE_FLOAT:
    case Form::BIG_FLOAT:
      return static_cast<float>(value);
    case Form::LITTLE_DOUBLE:
    case Form::BIG_DOUBLE:
    case Form::FREE:
      return value;
    default: {
      double back = value;
      parse_solver_number(number(place, value), back);
      return back;
    }
    }
  }

  static std::string number(const Number_place& place, double value)
  {
    using Form = Number_place::Form;
    const bool is_nastran = place.form == Form::NASTRAN_FREE || place.form == Form::NASTRAN_COLUMN;
    return number_in_width(value, place.form == Form::FREE ? 40 : place.width,
                           is_nastran ? Number_style::NASTRAN : Number_style::GENERAL);
  }

  std::string text_at(const Number_place& place, double value) const
  {
    if (!is_text(place.form))
      return binary_text(value, place.form);
    std::string text = number(place, value);
    if (place.form == Number_place::Form::NASTRAN_COLUMN && text.size() < place.length) {
      const char first = files[place.file].content[place.begin];
      const std::string blanks(place.length - text.size(), ' ');
      text = first == ' ' ? blanks + text : text + blanks;
    }
    return text;
  }

  bool is_same(const std::string& output) const
  {
    return are_same(folder.empty() ? files[0].filename : folder, output);
  }

  static bool are_same(const std::filesystem::path& a, const std::filesystem::path& b)
  {
    std::error_code ignored;
    return std::filesystem::equivalent(a, b, ignored);
  }

  std::filesystem::path target(std::size_t f, const std::string& output) const
  {
    namespace fs = std::filesystem;
    if (is_same(output))
      return files[f].filename;
    if (!folder.empty())
      return fs::path(output) / files[f].name;
    return f == 0 ? fs::path(output) : fs::path(output).parent_path() / files[f].name;
  }

  // A copy of a file that is included by an absolute name, or from above, would not be read by the copy of the first one.
  void check_outside(const std::vector<char>& is_touched) const
  {
    for (std::size_t f = 1; f < files.size(); ++f)
      if (is_touched[f] && folder.empty() && std::filesystem::path(files[f].name).is_absolute())
        throw CGAL::IO::Hex_mesh_file_error(files[f].filename, 0,
                                            "coordinates stand in this file, which is included by an absolute name: a "
                                            "copy of it elsewhere would not be read");
  }

  static void write_edited(const Source_file& file, const std::filesystem::path& target, const std::vector<Edit>& edits)
  {
    std::string content;
    content.reserve(file.content.size() + 16 * edits.size());
    std::size_t done = 0;
    for (const Edit& edit : edits) {
      content.append(file.content, done, edit.begin - done);
      content += edit.text;
      done = edit.begin + edit.length;
    }
    content.append(file.content, done, std::string::npos);
    std::error_code error;
    if (target.has_parent_path())
      std::filesystem::create_directories(target.parent_path(), error);
    Atomic_file out(target.string());
    out.text() = file.is_compressed ? gzip(file.filename, content) : std::move(content);
    out.commit();
  }

  // Included files come along where the copy would not find them.
  void copy_unchanged(std::size_t f, const std::string& output) const
  {
    std::error_code error;
    const std::filesystem::path to = target(f, output);
    if (are_same(files[f].filename, to) || (f > 0 && std::filesystem::path(files[f].name).is_absolute()) ||
        (f > 0 && std::filesystem::exists(to, error)))
      return;
    if (to.has_parent_path())
      std::filesystem::create_directories(to.parent_path(), error);
    Temporary_copy copy(files[f].filename, to.string());
    copy.commit();
  }

  void copy_folder(const std::string& output) const
  {
    namespace fs = std::filesystem;
    if (is_same(output))
      return;
    std::error_code error;
    const fs::path from = fs::weakly_canonical(folder, error), to = fs::weakly_canonical(output, error);
    if (std::mismatch(from.begin(), from.end(), to.begin(), to.end()).first == from.end())
      throw CGAL::IO::Hex_mesh_file_error(output, 0, "a case cannot be written into itself");
    fs::create_directories(to, error);
    if (!error)
      fs::copy(from, to,
               fs::copy_options::recursive | fs::copy_options::overwrite_existing | fs::copy_options::copy_symlinks,
               error);
    if (error)
      throw CGAL::IO::Hex_mesh_file_error(output, 0, "cannot copy the folder: " + error.message());
  }
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_NUMBER_PLACES_H
