// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_BASE64_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_BASE64_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Bytes as text, four characters for three of them, and back.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// Gives out the bytes of an encoded or raw block one after the other.
class Byte_source
{
public:
  Byte_source(std::string_view data, bool is_base64) : data_(data), is_base64_(is_base64) {}

  // At least as many bytes as can still come.
  std::size_t left() const { return is_base64_ ? data_.size() / 4 * 3 + 6 : data_.size(); }

  // Appends `size` bytes; false if there are not as many.
  bool read(std::size_t size, std::string& bytes)
  {
    if (size > left())
      return false;
    if (!is_base64_) {
      bytes.append(data_.substr(0, size));
      data_.remove_prefix(size);
      return true;
    }
    bytes.reserve(bytes.size() + size);
    for (; size > 0; --size) {
      if (decoded_ == available_ && !decode())
        return false;
      bytes += quantum_[decoded_++];
    }
    return true;
  }

private:
  // Four characters make one to three bytes. Padding ends a part, not the
  // data: a header may be encoded on its own before them.
  bool decode()
  {
    std::uint32_t bits = 0;
    std::size_t characters = 0, padding = 0;
    while (characters < 4) {
      if (data_.empty())
        return false;
      const char c = data_.front();
      data_.remove_prefix(1);
      if (c == ' ' || c == '\n' || c == '\r' || c == '\t')
        continue;
      const int value = c >= 'A' && c <= 'Z'   ? c - 'A'
                        : c >= 'a' && c <= 'z' ? c - 'a' + 26
                        : c >= '0' && c <= '9' ? c - '0' + 52
                        : c == '+'             ? 62
                        : c == '/'             ? 63
                                               : -1;
      if (c == '=' && characters >= 2)
        ++padding;
      else if (value < 0 || padding > 0)
        return false;
      bits = bits << 6 | static_cast<std::uint32_t>(value < 0 ? 0 : value);
      ++characters;
    }
    quantum_ = {static_cast<char>(bits >> 16), static_cast<char>(bits >> 8), static_cast<char>(bits)};
    decoded_ = 0;
    available_ = 3 - padding;
    return true;
  }

  std::string_view data_;
  bool is_base64_;
  std::array<char, 3> quantum_{};
  std::size_t decoded_ = 0;
  std::size_t available_ = 0;
};

inline void append_base64(std::string& text, std::string_view bytes)
{
  static const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t b = 0; b < 3; ++b)
      bits = bits << 8 | (i + b < bytes.size() ? static_cast<unsigned char>(bytes[i + b]) : 0u);
    for (std::size_t b = 0; b < 4; ++b)
      text += i + b > bytes.size() ? '=' : digits[bits >> (18 - 6 * b) & 63];
  }
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_BASE64_H
