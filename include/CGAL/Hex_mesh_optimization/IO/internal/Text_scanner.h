// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_TEXT_SCANNER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_TEXT_SCANNER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Splits a text in memory into words and numbers and knows the line it is at.
// Independent of the locale.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_as_text.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Text_scanner
{
public:
  // A `comment` character makes the rest of its line white space.
  Text_scanner(const std::string& filename, std::string_view text, char comment = '\0', std::size_t line = 1)
    : filename_(filename)
    , text_(text)
    , comment_(comment)
    , line_(line)
  {}

  std::size_t position() const { return position_; }
  std::size_t line() const { return names_lines_ ? line_ : 0; }
  // From here on the text is binary: there are no lines to name.
  void stop_naming_lines() { names_lines_ = false; }
  const std::string& filename() const { return filename_; }
  std::string_view text() const { return text_; }

  [[noreturn]] void fail(const std::string& reason) const { fail(line(), reason); }
  [[noreturn]] void fail(std::size_t line, const std::string& reason) const
  {
    throw CGAL::IO::Hex_mesh_file_error(filename_, line, reason);
  }

  void skip_white_space()
  {
    while (position_ < text_.size()) {
      const char c = text_[position_];
      if (c == '\n')
        ++line_;
      else if (c == comment_ && comment_ != '\0') {
        position_ = (std::min)(text_.find('\n', position_), text_.size());
        continue;
      }
      else if (!is_white(c))
        return;
      ++position_;
    }
  }

  // True at the end of the text.
  bool at_end()
  {
    skip_white_space();
    return position_ == text_.size();
  }

  // The next word, empty at the end of the text.
  std::string_view word()
  {
    skip_white_space();
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_white(text_[position_]) && text_[position_] != '\n' &&
           (text_[position_] != comment_ || comment_ == '\0'))
      ++position_;
    return text_.substr(begin, position_ - begin);
  }

  // The rest of the line, without its end.
  std::string_view rest_of_line()
  {
    const std::size_t begin = position_;
    const std::size_t end = (std::min)(text_.find('\n', begin), text_.size());
    position_ = (std::min)(end + 1, text_.size());
    line_ += end < text_.size();
    std::string_view rest = text_.substr(begin, end - begin);
    if (!rest.empty() && rest.back() == '\r')
      rest.remove_suffix(1);
    return rest;
  }

  // Goes on `size` bytes further; the caller has checked that they are there.
  void skip(std::size_t size) { position_ += size; }

  double coordinate(const char* what)
  {
    const std::string_view w = word();
    double value;
    if (w.empty())
      fail(std::string(what) + " is expected, but the data end here");
    if (!parse_number(w, value))
      fail(std::string(what) + " is expected, not \"" + printable(w) + "\"");
    if (!std::isfinite(value))
      fail(std::string(what) + " is not a finite number: \"" + printable(w) + "\"");
    return value;
  }

  std::int64_t integer(const char* what)
  {
    const std::string_view w = word();
    std::int64_t value;
    if (w.empty())
      fail(std::string(what) + " is expected, but the data end here");
    if (!parse_number(w, value))
      fail(std::string(what) + " is expected, not \"" + printable(w) + "\"");
    return value;
  }

  // A number that is not negative.
  std::uint64_t natural(const char* what)
  {
    const std::int64_t value = integer(what);
    if (value < 0)
      fail(std::string(what) + " is negative: " + std::to_string(value));
    return static_cast<std::uint64_t>(value);
  }

  // The number of elements that follow. At least `bytes_each` bytes must be
  // left for each: a huge number in a small file allocates nothing.
  std::size_t count(const char* what, std::size_t bytes_each)
  {
    const std::uint64_t value = natural(what);
    // The last element needs no separator after it.
    if (value > (text_.size() - position_ + 1) / bytes_each)
      fail(std::string(what) + " is " + std::to_string(value) + ", more than the rest of the file can hold");
    return static_cast<std::size_t>(value);
  }

  // At most a few characters of a word, without control characters.
  static std::string printable(std::string_view word)
  {
    std::string result;
    for (const char c : word.substr(0, 40))
      result += c >= ' ' && c <= '~' ? c : '?';
    return word.size() > 40 ? result + "..." : result;
  }

private:
  static bool is_white(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v' || c == '\n'; }

  std::string filename_;
  std::string_view text_;
  char comment_;
  std::size_t position_ = 0;
  std::size_t line_;
  bool names_lines_ = true;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_TEXT_SCANNER_H
