// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_GZIP_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_GZIP_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Files that gzip has made, in memory.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>

#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB
#include <zlib.h>
#endif

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL::Hex_mesh_optimization::internal::IO {

inline bool is_gzip(std::string_view bytes) { return bytes.size() > 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b'; }

#ifndef CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB

inline std::string gunzip(const std::string& filename, std::string_view)
{
  throw CGAL::IO::Hex_mesh_file_error(
    filename, 0, "the file is compressed, and this program was built without zlib (Debian: zlib1g-dev)");
}
inline std::string gzip(const std::string& filename, std::string_view bytes) { return gunzip(filename, bytes); }

#else

// Several members follow each other, as gzip has it.
inline std::string gunzip(const std::string& filename, std::string_view bytes)
{
  const auto fail = [&] { throw CGAL::IO::Hex_mesh_file_error(filename, 0, "the compressed data are damaged"); };
  constexpr std::size_t largest = std::size_t(1) << 34;
  std::string result;
  std::string buffer(std::size_t(1) << 18, '\0');
  while (is_gzip(bytes)) {
    z_stream stream{};
    if (inflateInit2(&stream, 15 + 16) != Z_OK)
      fail();
    int code = Z_OK;
    while (code == Z_OK) {
      const std::size_t part = std::min(bytes.size(), std::size_t(1) << 30);
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
      stream.avail_in = static_cast<uInt>(part);
      stream.next_out = reinterpret_cast<Bytef*>(&buffer[0]);
      stream.avail_out = static_cast<uInt>(buffer.size());
      code = inflate(&stream, Z_NO_FLUSH);
      bytes.remove_prefix(part - stream.avail_in);
      result.append(buffer, 0, buffer.size() - stream.avail_out);
      if (result.size() > largest)
        code = Z_DATA_ERROR;
    }
    inflateEnd(&stream);
    if (code != Z_STREAM_END)
      fail();
  }
  return result;
}

inline std::string gzip(const std::string& filename, std::string_view bytes)
{
  z_stream stream{};
  std::string result;
  if (bytes.size() > 0xffffffffu ||
      deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw CGAL::IO::Hex_mesh_file_error(filename, 0, "cannot compress the data");
  result.resize(deflateBound(&stream, static_cast<uLong>(bytes.size())));
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(&result[0]);
  stream.avail_out = static_cast<uInt>(result.size());
  const int code = deflate(&stream, Z_FINISH);
  result.resize(result.size() - stream.avail_out);
  deflateEnd(&stream);
  if (code != Z_STREAM_END)
    throw CGAL::IO::Hex_mesh_file_error(filename, 0, "cannot compress the data");
  return result;
}

#endif

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_GZIP_H
