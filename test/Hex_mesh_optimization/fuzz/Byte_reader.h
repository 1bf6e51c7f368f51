// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_FUZZ_BYTE_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_FUZZ_BYTE_READER_H

// Takes small decisions from the bytes of a run. Past the end all bytes are 0.

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace fuzz {

class Byte_reader
{
public:
  Byte_reader(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

  bool is_empty() const { return next_ == end_; }
  std::uint8_t byte() { return is_empty() ? 0 : *next_++; }
  int signed_byte() { return static_cast<std::int8_t>(byte()); }
  std::size_t below(std::size_t n) { return byte() % n; } // n at most 256

  double bits_of_double()
  {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i)
      bits |= std::uint64_t(byte()) << 8 * i;
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
  }

private:
  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

} // namespace fuzz

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_FUZZ_BYTE_READER_H
