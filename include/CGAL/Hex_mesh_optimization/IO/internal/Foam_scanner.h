// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_FOAM_SCANNER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_FOAM_SCANNER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads the words and lists of a file of OpenFOAM, as text or binary.

#include <CGAL/Hex_mesh_optimization/IO/internal/Number_places.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/split_fields.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Foam_scanner
{
public:
  // Reads the header.
  explicit Foam_scanner(const Source_file& file) : file_(file), text_(file.content)
  {
    skip_blank();
    if (word() != "FoamFile")
      fail("a header FoamFile is expected");
    expect('{');
    while (!accepts('}')) {
      const std::string key = word();
      std::string value;
      skip_blank();
      while (position_ < text_.size() && text_[position_] != ';')
        value += text_[position_++];
      expect(';');
      header_[key] = unquoted(trimmed(value));
    }
    is_binary_ = header_["format"] == "binary";
    const std::string& arch = header_["arch"];
    is_big_ = arch.compare(0, 3, "MSB") == 0;
    label_size_ = arch.find("label=64") != std::string::npos ? 8 : 4;
    scalar_size_ = arch.find("scalar=32") != std::string::npos ? 4 : 8;
  }

  bool is_binary() const { return is_binary_; }
  bool is_big() const { return is_big_; }
  std::size_t scalar_size() const { return scalar_size_; }
  std::size_t position() const { return position_; }
  std::string_view text() const { return text_; }
  std::string header(const std::string& key) const
  {
    const auto found = header_.find(key);
    return found == header_.end() ? std::string() : found->second;
  }

  // Blanks and comments
  void skip_blank()
  {
    while (position_ < text_.size()) {
      const char c = text_[position_];
      if (c == ' ' || c == '\t' || c == '\n' || c == '\r')
        ++position_;
      else if (c == '/' && position_ + 1 < text_.size() && text_[position_ + 1] == '/')
        position_ = std::min(text_.find('\n', position_), text_.size());
      else if (c == '/' && position_ + 1 < text_.size() && text_[position_ + 1] == '*') {
        const std::size_t end = text_.find("*/", position_ + 2);
        position_ = end == std::string_view::npos ? text_.size() : end + 2;
      }
      else
        return;
    }
  }

  bool at_end()
  {
    skip_blank();
    return position_ == text_.size();
  }

  bool accepts(char c)
  {
    skip_blank();
    if (position_ >= text_.size()) {
      if (c == '}' || c == ')')
        fail(std::string("'") + c + "' is expected, but the file ends here");
      return false;
    }
    if (text_[position_] != c)
      return false;
    ++position_;
    return true;
  }

  void expect(char c)
  {
    if (!accepts(c))
      fail(std::string("'") + c + "' is expected");
  }

  // Up to a blank, a bracket or a semicolon; a quoted one as a whole.
  std::string word()
  {
    skip_blank();
    const std::size_t begin = position_;
    if (position_ < text_.size() && text_[position_] == '"') {
      const std::size_t end = text_.find('"', position_ + 1);
      if (end == std::string_view::npos)
        fail("a quotation does not end");
      position_ = end + 1;
      return std::string(text_.substr(begin + 1, end - begin - 1));
    }
    while (position_ < text_.size() && std::strchr(" \t\r\n(){};", text_[position_]) == nullptr)
      ++position_;
    if (begin == position_)
      fail("a word is expected");
    return std::string(text_.substr(begin, position_ - begin));
  }

  std::string_view number_word()
  {
    skip_blank();
    const std::size_t begin = position_;
    while (position_ < text_.size() && std::strchr(" \t\r\n(){};/", text_[position_]) == nullptr)
      ++position_;
    return text_.substr(begin, position_ - begin);
  }

  std::int64_t label()
  {
    const std::string_view w = number_word();
    std::int64_t value = 0;
    if (!parse_number(w, value))
      fail("an integer is expected, not \"" + Text_scanner::printable(w) + '"');
    return value;
  }

  // The number of elements that follow, of at least so many bytes each.
  std::size_t count(std::size_t bytes_each)
  {
    const std::int64_t n = label();
    if (n < 0 || static_cast<std::uint64_t>(n) > (text_.size() - position_ + 1) / bytes_each)
      fail("more elements are announced than the file can hold: " + std::to_string(n));
    return static_cast<std::size_t>(n);
  }

  std::vector<std::int64_t> labels()
  {
    const std::int64_t n = label();
    if (accepts('{')) { // all the same
      const std::int64_t value = label();
      expect('}');
      if (n < 0 || n > most_uniform)
        fail("a list has too many elements: " + std::to_string(n));
      return std::vector<std::int64_t>(static_cast<std::size_t>(n), value);
    }
    const std::size_t bytes_each = is_binary_ ? label_size_ : 2;
    if (n < 0 || static_cast<std::uint64_t>(n) > (text_.size() - position_ + 1) / bytes_each)
      fail("more elements are announced than the file can hold: " + std::to_string(n));
    std::vector<std::int64_t> result(static_cast<std::size_t>(n));
    if (n == 0) {
      if (position_ < text_.size() && text_[position_] == '(')
        ++position_, expect(')');
      return result;
    }
    expect('(');
    for (std::int64_t& value : result)
      value = is_binary_ ? binary_label() : label();
    expect(')');
    return result;
  }

  std::vector<std::vector<std::int64_t>> faces()
  {
    std::vector<std::vector<std::int64_t>> result;
    if (header("class") == "faceCompactList") {
      const std::vector<std::int64_t> offsets = labels(), corners = labels();
      for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
        if (offsets[f] < 0 || offsets[f + 1] < offsets[f] || static_cast<std::size_t>(offsets[f + 1]) > corners.size())
          fail("face " + std::to_string(f) + " has no corners in the list");
        result.emplace_back(corners.begin() + offsets[f], corners.begin() + offsets[f + 1]);
      }
      return result;
    }
    const std::size_t n = count(3);
    result.reserve(n);
    if (n == 0)
      return result;
    expect('(');
    for (std::size_t f = 0; f < n; ++f)
      result.push_back(labels());
    expect(')');
    return result;
  }

  // The bytes of what is binary and of no interest.
  void skip(std::size_t bytes)
  {
    if (text_.size() - position_ < bytes)
      fail("the file ends too early");
    position_ += bytes;
  }

  [[noreturn]] void fail(const std::string& reason) const { file_.fail(position_, reason); }

private:
  static constexpr std::int64_t most_uniform = 100000000;

  std::int64_t binary_label()
  {
    const std::size_t begin = position_;
    skip(label_size_);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < label_size_; ++i)
      value = value << 8 | static_cast<unsigned char>(text_[is_big_ ? begin + i : begin + label_size_ - 1 - i]);
    return label_size_ == 4 ? static_cast<std::int32_t>(static_cast<std::uint32_t>(value))
                            : static_cast<std::int64_t>(value);
  }

  const Source_file& file_;
  std::string_view text_;
  std::size_t position_ = 0;
  std::map<std::string, std::string> header_;
  bool is_binary_ = false, is_big_ = false;
  std::size_t label_size_ = 4, scalar_size_ = 8;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_FOAM_SCANNER_H
