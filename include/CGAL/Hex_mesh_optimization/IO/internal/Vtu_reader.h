// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_READER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads hexahedra or polygons in the XML format of VTK (.vtu).

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/add_vtk_cell.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/base64.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/binary_number.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/complete_mesh_data.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/data_values.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_as_text.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/read_whole_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/vtu_roles.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB
#include <zlib.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
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
    if (wanted_ == Wanted_cells::HEXAHEDRA) {
      if (const auto fields = grid->get_child_optional("FieldData"))
        read_arrays(*fields, "mesh", nullptr, content_.mesh_data.field_data);
      complete_mesh_data(content_);
    }
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

  // The bytes of a binary array, which must be `size`, if that is given.
  std::string read_block(Byte_source source, std::optional<std::uint64_t> size, const std::string& name) const
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
      if (size && found != *size)
        fail("the data of " + name + " have " + std::to_string(found) + " bytes, not " + std::to_string(*size));
    };

    std::string bytes;
    if (!is_compressed_) {
      const std::uint64_t found = header(1)[0];
      check_size(found);
      if (found > source.left() || !source.read(static_cast<std::size_t>(found), bytes))
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
      if ((size && block_size > *size - bytes.size()) || block_size / 1040 > compressed.size())
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

  Byte_source byte_source(const Tree& array, const std::string& format, const std::string& name) const
  {
    std::uint64_t offset = 0;
    if (format == "appended") {
      if (!parse_number(attribute(array, "offset"), offset) || offset > appended_.size())
        fail("the offset of " + name + " lies outside the file");
      return {std::string_view(appended_).substr(static_cast<std::size_t>(offset)), appended_is_base64_};
    }
    if (format != "binary")
      fail("the format of " + name + " is \"" + Text_scanner::printable(format) + "\"");
    return {array.data(), true};
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

    const Byte_source source = byte_source(array, format, name);
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
    const std::size_t first_cell = content_.hexahedra.size() + content_.mesh_data.other_cells.size();
    if (number_of_points > (std::uint64_t(1) << 56))
      fail("the data of points are incomplete");
    if (number_of_points > 0) {
      const Tree& array_of_points = array(piece, "Points", "points");
      if (attribute(array_of_points, "NumberOfComponents", "3") != "3")
        fail("the points do not have 3 coordinates");
      content_.mesh_data.is_binary = attribute(array_of_points, "format", "ascii") != "ascii";
      const std::vector<double> values = read_array<double>(array_of_points, 3 * number_of_points, "points");
      content_.points.resize(first_point + static_cast<std::size_t>(number_of_points));
      for (std::size_t i = 0; i < values.size(); ++i)
        content_.points[first_point + i / 3][i % 3] = values[i];
    }
    if (number_of_cells > 0)
      read_cells(piece, number_of_points, number_of_cells, first_point);
    if (wanted_ == Wanted_cells::HEXAHEDRA) {
      if (const auto group = piece.get_child_optional("PointData"))
        read_piece_data(*group, "points", number_of_points, first_point, content_.mesh_data.point_data);
      if (const auto group = piece.get_child_optional("CellData"))
        read_piece_data(*group, "cells", number_of_cells, first_cell, content_.mesh_data.cell_data);
    }
  }

  void read_cells(const Tree& piece, std::uint64_t number_of_points, std::uint64_t number_of_cells,
                  std::size_t first_point)
  {
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

  using Array = CGAL::IO::Hex_mesh_data_array;

  // The arrays of a group of elements, each with a tuple for each of `count` elements, or as many as it says itself.
  // The mesh is read even if they are damaged.
  void read_arrays(const Tree& group, const std::string& of, const std::uint64_t* count, std::vector<Array>& arrays)
  {
    for (const auto& child : group)
      if (child.first == "DataArray" || child.first == "Array") {
        const std::string name = attribute(child.second, "Name");
        try {
          arrays.push_back(read_data_array(child.second, name, count));
          arrays.back().role = role(group, name);
        }
        catch (const CGAL::IO::Hex_mesh_file_error& error) {
          content_.mesh_data.skipped.push_back("an array of the " + of + ": " + error.what());
        }
        for (const auto& key : child.second)
          if (key.first == "InformationKey") {
            const std::string key_name = attribute(key.second, "name");
            // the range of the values follows from them
            if (key_name.find("RANGE") == std::string::npos)
              content_.mesh_data.skipped.push_back("the information key \"" + key_name + "\" of the array \"" + name +
                                                   "\" of the " + of);
          }
      }
  }

  // As above; the arrays of further pieces continue those of the first.
  void read_piece_data(const Tree& group, const std::string& of, std::uint64_t count, std::size_t before,
                       std::vector<Array>& arrays)
  {
    if (before == 0)
      return read_arrays(group, of, &count, arrays);
    std::vector<Array> more;
    read_arrays(group, of, &count, more);
    for (const Array& array : more) {
      const auto same = std::find_if(arrays.begin(), arrays.end(), [&](const Array& a) {
        return a.name == array.name && a.values.index() == array.values.index() &&
               a.number_of_components == array.number_of_components && a.number_of_tuples() == before;
      });
      if (same != arrays.end())
        std::visit(
          [&](auto& values) {
            const auto& tail = std::get<std::decay_t<decltype(values)>>(array.values);
            values.insert(values.end(), tail.begin(), tail.end());
          },
          same->values);
      else if (array.size() > 0)
        content_.mesh_data.skipped.push_back("the array \"" + array.name + "\" of the " + of +
                                             ": not all pieces have it with the same type");
    }
  }

  // What the attributes of a group say that the array is for.
  static Array::Role role(const Tree& group, const std::string& name)
  {
    for (const auto& [attribute_name, role] : vtu_roles)
      if (attribute(group, attribute_name) == name && !name.empty())
        return role;
    return Array::Role::NONE;
  }

  Array read_data_array(const Tree& element, const std::string& name, const std::uint64_t* count) const
  {
    Array array;
    array.name = name;
    std::uint64_t components = 1, tuples = 0;
    bool has_tuples = count != nullptr;
    if (has_tuples)
      tuples = *count;
    const std::string printable = '"' + Text_scanner::printable(name) + '"';
    if (const auto attributes = element.get_child_optional("<xmlattr>")) {
      for (const auto& [key, value] : *attributes)
        if (key == "NumberOfComponents") {
          if (!parse_number(value.data(), components))
            fail("the number of components of " + printable + " is no number");
        }
        else if (key == "NumberOfTuples") {
          if (count == nullptr) {
            has_tuples = true;
            if (!parse_number(value.data(), tuples))
              fail("the number of tuples of " + printable + " is no number");
          }
        }
        else if (key != "type" && key != "Name" && key != "format" && key != "offset" && key != "RangeMin" &&
                 key != "RangeMax")
          array.attributes.emplace_back(key, value.data());
    }

    const std::string type = attribute(element, "type");
    const std::string format = attribute(element, "format", "ascii");
    const Number_type number_type = Vtu_reader::number_type(type);
    if (type == "String")
      array.values = std::vector<std::string>();
    else if (type == "Bit")
      array.values = std::vector<bool>();
    else if (number_type.size != 0)
      array.values = empty_values(number_type);
    else
      fail("the type of " + printable + " is \"" + Text_scanner::printable(type) + '"');
    const std::uint64_t most = std::uint64_t(1) << 56;
    if (tuples > most || (tuples != 0 && components > most / tuples))
      fail("the data of " + printable + " are incomplete");
    array.number_of_components = static_cast<std::size_t>(components);
    const std::size_t size = static_cast<std::size_t>(tuples * components);
    std::visit(
      [&](auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (is_string<Value>)
          values = read_strings(element, format, printable);
        else
          values = read_values<Value>(element, format, printable,
                                      has_tuples ? std::optional<std::size_t>(size) : std::nullopt);
      },
      array.values);
    if (has_tuples && array.size() != size)
      fail("the data of " + printable + " have " + std::to_string(array.size()) + " values, not " +
           std::to_string(size));
    return array;
  }

  template <class Value>
  std::vector<Value> read_values(const Tree& element, const std::string& format, const std::string& name,
                                 std::optional<std::size_t> count) const
  {
    std::vector<Value> values;
    if (format == "ascii") {
      Text_scanner scanner(filename_, element.data());
      scanner.stop_naming_lines();
      if (count && *count > (element.data().size() + 1) / 2)
        fail("the data of " + name + " are incomplete");
      if (count)
        read_text_values(scanner, *count, values);
      while (!count && !scanner.at_end())
        read_text_values(scanner, 1, values);
      if (!scanner.at_end())
        fail("the data of " + name + " are longer than they should be");
      return values;
    }
    const Byte_source source = byte_source(element, format, name);
    if (count && *count == 0)
      return values;
    const std::optional<std::uint64_t> size = count ? std::optional<std::uint64_t>(byte_count<Value>(*count))
                                                    : std::nullopt;
    const std::string bytes = read_block(source, size, name);
    const std::size_t number = count ? *count : is_bit<Value> ? 8 * bytes.size() : bytes.size() / sizeof(Value);
    read_binary_values(bytes.data(), number, reverse_, values);
    return values;
  }

  // Each ends with a zero; as text, they are the numbers of their bytes.
  std::vector<std::string> read_strings(const Tree& element, const std::string& format, const std::string& name) const
  {
    std::vector<std::uint8_t> codes;
    if (format != "ascii" || element.data().find_first_not_of(" \t\r\n") != std::string::npos)
      codes = read_values<std::uint8_t>(element, format, name, std::nullopt);
    std::vector<std::string> strings;
    for (auto begin = codes.begin(); begin != codes.end();) {
      const auto end = std::find(begin, codes.end(), 0);
      if (end == codes.end())
        fail("a string of " + name + " has no end");
      strings.emplace_back(begin, end);
      begin = end + 1;
    }
    return strings;
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
