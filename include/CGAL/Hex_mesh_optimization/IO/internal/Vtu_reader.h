// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_READER_H

// Reads hexahedra or polygons in the XML format of VTK (.vtu).

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/add_vtk_cell.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/base64.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/binary_number.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_as_text.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/read_whole_file.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB
#include <zlib.h>
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Vtu_reader
{
public:
  Vtu_reader(const std::string& filename, Wanted_cells wanted) : filename_(filename), wanted_(wanted) {}

  Mesh_file_content read()
  {
    std::string text = read_whole_file(filename_);
    cut_off_appended_data(text);
    Tree tree;
    try {
      std::istringstream in(std::move(text));
      boost::property_tree::read_xml(in, tree);
    }
    catch (const boost::property_tree::xml_parser_error& error) {
      throw CGAL::IO::Hex_mesh_file_error(filename_, error.line(), error.message());
    }
    const auto file = tree.get_child_optional("VTKFile");
    if (!file)
      fail("this is no VTK file: there is no VTKFile element");
    read_header(*file);
    const auto grid = file->get_child_optional("UnstructuredGrid");
    if (!grid)
      fail("there is no UnstructuredGrid element");
    bool has_piece = false;
    for (const auto& child : *grid)
      if (child.first == "Piece") {
        read_piece(child.second);
        has_piece = true;
      }
    if (!has_piece)
      fail("there is no Piece element");
    return std::move(content_);
  }

private:
  using Tree = boost::property_tree::ptree;

  [[noreturn]] void fail(const std::string& reason) const { throw CGAL::IO::Hex_mesh_file_error(filename_, 0, reason); }

  static std::string attribute(const Tree& element, const std::string& name, const std::string& otherwise = "")
  {
    return element.get<std::string>("<xmlattr>." + name, otherwise);
  }

  // Raw appended data are no XML: the parser must not see them.
  void cut_off_appended_data(std::string& text)
  {
    const std::size_t element = text.find("<AppendedData");
    if (element == std::string::npos)
      return;
    const std::size_t close = text.find('>', element);
    const std::size_t end = text.rfind("</AppendedData");
    const std::size_t begin = text.find('_', close);
    if (close == std::string::npos || end == std::string::npos || begin == std::string::npos || begin >= end)
      fail("the AppendedData element is incomplete");
    appended_ = text.substr(begin + 1, end - begin - 1);
    text.erase(begin, end - begin);
  }

  void read_header(const Tree& file)
  {
    const std::string type = attribute(file, "type");
    if (type != "UnstructuredGrid")
      fail("the file holds a " + Text_scanner::printable(type) + ", not an UnstructuredGrid");
    const std::string byte_order = attribute(file, "byte_order", "LittleEndian");
    if (byte_order != "LittleEndian" && byte_order != "BigEndian")
      fail("unknown byte order \"" + Text_scanner::printable(byte_order) + "\"");
    reverse_ = (byte_order == "LittleEndian") != is_little_endian_machine();
    const std::string header_type = attribute(file, "header_type", "UInt32");
    header_type_ = number_type(header_type);
    if (header_type != "UInt32" && header_type != "UInt64")
      fail("unknown header type \"" + Text_scanner::printable(header_type) + "\"");
    const std::string compressor = attribute(file, "compressor");
    is_compressed_ = !compressor.empty();
    if (is_compressed_) {
      if (compressor != "vtkZLibDataCompressor")
        fail("data compressed by " + Text_scanner::printable(compressor) + " cannot be read");
#ifndef CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB
      fail("compressed data cannot be read: this program was built without zlib");
#endif
    }
    if (const auto appended = file.get_child_optional("AppendedData")) {
      const std::string encoding = attribute(*appended, "encoding", "base64");
      if (encoding != "raw" && encoding != "base64")
        fail("unknown encoding \"" + Text_scanner::printable(encoding) + "\"");
      appended_is_base64_ = encoding == "base64";
    }
  }

  static Number_type number_type(const std::string& name)
  {
    if (name == "Float32")
      return {Number_kind::FLOATING, 4};
    if (name == "Float64")
      return {Number_kind::FLOATING, 8};
    if (name == "Int8")
      return {Number_kind::SIGNED, 1};
    if (name == "UInt8")
      return {Number_kind::UNSIGNED, 1};
    if (name == "Int16")
      return {Number_kind::SIGNED, 2};
    if (name == "UInt16")
      return {Number_kind::UNSIGNED, 2};
    if (name == "Int32")
      return {Number_kind::SIGNED, 4};
    if (name == "UInt32")
      return {Number_kind::UNSIGNED, 4};
    if (name == "Int64")
      return {Number_kind::SIGNED, 8};
    if (name == "UInt64")
      return {Number_kind::UNSIGNED, 8};
    return {};
  }

  std::uint64_t count(const Tree& piece, const std::string& name) const
  {
    std::uint64_t value = 0;
    if (!parse_number(attribute(piece, name), value))
      fail(name + " of a Piece is not a number");
    return value;
  }

  const Tree& array(const Tree& piece, const std::string& group, const std::string& name) const
  {
    const auto parent = piece.get_child_optional(group);
    if (parent)
      for (const auto& child : *parent)
        if (child.first == "DataArray" && (group == "Points" || attribute(child.second, "Name") == name))
          return child.second;
    fail("there is no DataArray of " + name);
  }

  // The bytes of a binary array, which must be `size`.
  std::string read_block(Byte_source source, std::uint64_t size, const std::string& name) const
  {
    const auto too_short = [&] { fail("the data of " + name + " are incomplete"); };
    const auto header = [&](std::size_t length) {
      std::vector<std::uint64_t> values;
      std::string bytes;
      if (length > source.left() / header_type_.size || !source.read(length * header_type_.size, bytes))
        too_short();
      for (std::size_t i = 0; i < length; ++i)
        values.push_back(decode_number<std::uint64_t>(bytes.data() + i * header_type_.size, header_type_, reverse_));
      return values;
    };
    const auto check_size = [&](std::uint64_t found) {
      if (found != size)
        fail("the data of " + name + " have " + std::to_string(found) + " bytes, not " + std::to_string(size));
    };

    std::string bytes;
    if (!is_compressed_) {
      check_size(header(1)[0]);
      if (size > source.left() || !source.read(static_cast<std::size_t>(size), bytes))
        too_short();
      return bytes;
    }
#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB
    // Number of blocks, size of a block, size of the last one if it is smaller.
    const std::vector<std::uint64_t> sizes = header(3);
    if (sizes[0] > source.left())
      too_short();
    const std::vector<std::uint64_t> compressed_sizes = header(static_cast<std::size_t>(sizes[0]));
    for (std::size_t b = 0; b < compressed_sizes.size(); ++b) {
      const bool is_partial = b + 1 == compressed_sizes.size() && sizes[2] != 0;
      const std::uint64_t block_size = is_partial ? sizes[2] : sizes[1];
      std::string compressed;
      if (compressed_sizes[b] > source.left() ||
          !source.read(static_cast<std::size_t>(compressed_sizes[b]), compressed))
        too_short();
      // zlib shrinks by a factor of 1032 at most.
      if (block_size > size - bytes.size() || block_size / 1040 > compressed.size())
        fail("the compressed data of " + name + " are damaged");
      const std::size_t begin = bytes.size();
      bytes.resize(begin + static_cast<std::size_t>(block_size));
      uLongf length = static_cast<uLongf>(block_size);
      if (uncompress(reinterpret_cast<Bytef*>(&bytes[0] + begin), &length,
                     reinterpret_cast<const Bytef*>(compressed.data()),
                     static_cast<uLong>(compressed.size())) != Z_OK ||
          length != block_size)
        fail("the compressed data of " + name + " are damaged");
    }
    check_size(bytes.size());
#endif
    return bytes;
  }

  template <class Value>
  std::vector<Value> read_array(const Tree& array, std::uint64_t count, const std::string& name) const
  {
    const Number_type type = number_type(attribute(array, "type"));
    if (type.size == 0 || (type.kind == Number_kind::FLOATING && std::is_integral<Value>::value))
      fail("the type of " + name + " is \"" + Text_scanner::printable(attribute(array, "type")) + "\"");
    const std::string format = attribute(array, "format", "ascii");
    std::vector<Value> values;

    if (format == "ascii") {
      Text_scanner scanner(filename_, array.data());
      scanner.stop_naming_lines();
      if (count > (array.data().size() + 1) / 2)
        fail("the data of " + name + " are incomplete");
      values.reserve(static_cast<std::size_t>(count));
      for (std::uint64_t i = 0; i < count; ++i) {
        if constexpr (std::is_floating_point<Value>::value)
          values.push_back(scanner.coordinate("a coordinate"));
        else
          values.push_back(scanner.integer(("a number of " + name).c_str()));
      }
      if (!scanner.at_end())
        fail("the data of " + name + " are longer than they should be");
      return values;
    }

    std::uint64_t offset = 0;
    if (format == "appended") {
      if (!parse_number(attribute(array, "offset"), offset) || offset > appended_.size())
        fail("the offset of " + name + " lies outside the file");
    }
    else if (format != "binary")
      fail("the format of " + name + " is \"" + Text_scanner::printable(format) + "\"");
    const Byte_source source = format == "appended"
                                 ? Byte_source(std::string_view(appended_).substr(static_cast<std::size_t>(offset)),
                                               appended_is_base64_)
                                 : Byte_source(array.data(), true);
    // An empty array may have no block at all.
    if (count == 0)
      return values;
    if (count > (std::uint64_t(1) << 60))
      fail("the data of " + name + " are incomplete");
    const std::string bytes = read_block(source, count * type.size, name);
    values.reserve(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
      values.push_back(decode_number<Value>(bytes.data() + i * type.size, type, reverse_));
      if constexpr (std::is_floating_point<Value>::value)
        if (!std::isfinite(values.back()))
          fail("coordinate " + std::to_string(i % 3) + " of point " + std::to_string(i / 3) +
               " is not a finite number");
    }
    return values;
  }

  void read_piece(const Tree& piece)
  {
    const std::uint64_t number_of_points = count(piece, "NumberOfPoints");
    const std::uint64_t number_of_cells = count(piece, "NumberOfCells");
    const std::size_t first_point = content_.points.size();
    if (number_of_points > (std::uint64_t(1) << 56))
      fail("the data of points are incomplete");
    if (number_of_points > 0) {
      const Tree& array_of_points = array(piece, "Points", "points");
      if (attribute(array_of_points, "NumberOfComponents", "3") != "3")
        fail("the points do not have 3 coordinates");
      const std::vector<double> values = read_array<double>(array_of_points, 3 * number_of_points, "points");
      content_.points.resize(first_point + static_cast<std::size_t>(number_of_points));
      for (std::size_t i = 0; i < values.size(); ++i)
        content_.points[first_point + i / 3][i % 3] = values[i];
    }
    if (number_of_cells == 0)
      return;

    const std::vector<std::int64_t> offsets = read_array<std::int64_t>(array(piece, "Cells", "offsets"),
                                                                       number_of_cells, "offsets");
    const std::vector<std::int64_t> types = read_array<std::int64_t>(array(piece, "Cells", "types"), number_of_cells,
                                                                     "types");
    bool ascending = offsets.front() >= 0;
    for (std::size_t c = 1; c < offsets.size(); ++c)
      ascending = ascending && offsets[c - 1] <= offsets[c];
    if (!ascending)
      fail("the offsets do not ascend");
    const std::vector<std::int64_t> connectivity = read_array<std::int64_t>(array(piece, "Cells", "connectivity"),
                                                                            static_cast<std::uint64_t>(offsets.back()),
                                                                            "connectivity");
    std::vector<std::size_t> vertices;
    std::size_t i = 0;
    for (std::size_t c = 0; c < offsets.size(); ++c) {
      vertices.clear();
      for (; i < static_cast<std::size_t>(offsets[c]); ++i) {
        if (connectivity[i] < 0 || static_cast<std::uint64_t>(connectivity[i]) >= number_of_points)
          fail("cell " + std::to_string(c) + ": point " + std::to_string(connectivity[i]) +
               " does not exist, there are " + std::to_string(number_of_points) + " points");
        vertices.push_back(first_point + static_cast<std::size_t>(connectivity[i]));
      }
      const std::string wrong = add_vtk_cell(content_, wanted_, types[c], vertices.data(), vertices.size());
      if (!wrong.empty())
        fail("cell " + std::to_string(c) + ": " + wrong);
    }
  }

  std::string filename_;
  Wanted_cells wanted_;
  std::string appended_;
  bool appended_is_base64_ = true;
  bool is_compressed_ = false;
  bool reverse_ = false;
  Number_type header_type_;
  Mesh_file_content content_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_READER_H
