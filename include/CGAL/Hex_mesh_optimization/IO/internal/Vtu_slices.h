// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_SLICES_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_SLICES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A .vtu file with raw appended data, of which any slice can be read, and its copy with other points.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Replaced_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/binary_number.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/integer_labels.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Mesh_slices.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// The file must have one piece of hexahedra and points of 64 bits, as VTK writes a mesh in the mode "appended", neither
// encoded nor compressed.
class Vtu_slices : public Mesh_slices
{
public:
  // label_array: of the cells; empty: one with a usual name, if there is one.
  Vtu_slices(const std::string& input, const std::string& output, const std::string& label_array = "")
    : input_(input)
    , output_(output)
    , in_(input, std::ios::binary)
  {
    if (!in_)
      fail("cannot open the file for reading");
    read_layout(label_array);
  }

  Global_index number_of_vertices() const override { return number_of_vertices_; }
  Global_index number_of_hexahedra() const override { return number_of_hexahedra_; }
  bool has_labels() const override { return labels_.type.size > 0; }

  void read_hexahedra(Global_index first, Global_index last, std::array<Global_index, 8>* hexahedra) override
  {
    check_cells(first, last);
    read_numbers(connectivity_, 8 * first, 8 * last, hexahedra->data());
  }

  void read_points(Global_index first, Global_index last, std::array<double, 3>* points) override
  {
    read_numbers(points_, 3 * first, 3 * last, points->data());
  }

  void read_labels(Global_index first, Global_index last, int* labels) override
  {
    std::vector<double> some;
    for (Global_index begin = first; begin < last; begin += at_once) {
      const Global_index end = (std::min)(last, begin + at_once);
      some.resize(static_cast<std::size_t>(end - begin));
      read_numbers(labels_, begin, end, some.data());
      for (double l : some) {
        if (l != std::floor(l) || !(std::abs(l) < (std::numeric_limits<int>::max)()))
          fail("a label is no integer of 32 bits");
        *labels++ = static_cast<int>(l);
      }
    }
  }

  // Of all at once, as this process is alone.
  void write_points(Global_index first, Global_index last, const std::array<double, 3>* points) override
  {
    Replaced_file file(output_);
    copy_to(file.written());
    {
      std::fstream out(file.written(), std::ios::binary | std::ios::in | std::ios::out);
      write_points(first, last, points, [&](std::uint64_t offset, const char* bytes, std::size_t size) {
        out.seekp(static_cast<std::streamoff>(offset));
        out.write(bytes, static_cast<std::streamsize>(size));
      });
      if (!out.flush())
        file.fail("cannot write the file");
    }
    file.commit();
  }

protected:
  static constexpr Global_index at_once = 1 << 16;

  [[noreturn]] void fail(const std::string& reason) const { throw CGAL::IO::Hex_mesh_file_error(input_, 0, reason); }

  const std::string& output() const { return output_; }

  // What derived classes do in another way.
  virtual void read(std::uint64_t offset, char* bytes, std::size_t size)
  {
    in_.seekg(static_cast<std::streamoff>(offset));
    in_.read(bytes, static_cast<std::streamsize>(size));
    if (!in_)
      fail("the appended data are incomplete");
  }

  void copy_to(const std::filesystem::path& file) const
  {
    std::error_code error;
    std::filesystem::copy_file(input_, file, std::filesystem::copy_options::overwrite_existing, error);
    if (error)
      throw CGAL::IO::Hex_mesh_file_error(output_, 0, "cannot write the file: " + error.message());
  }

  // write(offset, bytes, size): to the file
  template <class Write>
  void write_points(Global_index first, Global_index last, const std::array<double, 3>* points,
                    const Write& write) const
  {
    std::vector<char> bytes;
    for (Global_index begin = first; begin < last; begin += at_once) {
      const Global_index end = (std::min)(last, begin + at_once);
      bytes.resize(static_cast<std::size_t>(end - begin) * 24);
      std::memcpy(bytes.data(), points + (begin - first), bytes.size());
      if (reverse_)
        for (std::size_t i = 0; i < bytes.size(); i += 8)
          std::reverse(bytes.begin() + i, bytes.begin() + i + 8);
      write(points_.offset + static_cast<std::uint64_t>(begin) * 24, bytes.data(), bytes.size());
    }
  }

private:
  using Tree = boost::property_tree::ptree;

  struct Array
  {
    std::uint64_t offset = 0; // of its first number in the file
    Number_type type;
  };

  static constexpr const char* what_is_needed = ": in parts, only .vtu files with one piece of hexahedra and raw "
                                                "appended data can be read, uncompressed, with points"
                                                " of 64 bits";

  static std::string attribute(const Tree& element, const std::string& name, const std::string& otherwise = "")
  {
    return element.get<std::string>("<xmlattr>." + name, otherwise);
  }

  // The text up to the appended data.
  std::string head()
  {
    const std::size_t most = 1 << 26;
    std::string text, more(1 << 16, '\0');
    while (text.size() < most) {
      in_.read(more.data(), static_cast<std::streamsize>(more.size()));
      text.append(more, 0, static_cast<std::size_t>(in_.gcount()));
      const std::size_t element = text.find("<AppendedData");
      const std::size_t close = element == std::string::npos ? element : text.find('>', element);
      const std::size_t begin = close == std::string::npos ? close : text.find('_', close);
      if (begin != std::string::npos) {
        appended_ = begin + 1;
        in_.clear();
        return text.substr(0, close + 1) + "</AppendedData></VTKFile>";
      }
      if (!in_)
        break;
    }
    fail(std::string("there are no appended data") + what_is_needed);
  }

  void read_layout(const std::string& label_array)
  {
    Tree tree;
    try {
      std::istringstream in(head());
      boost::property_tree::read_xml(in, tree);
    }
    catch (const boost::property_tree::xml_parser_error& error) {
      throw CGAL::IO::Hex_mesh_file_error(input_, error.line(), error.message());
    }
    const auto file = tree.get_child_optional("VTKFile");
    const auto grid = tree.get_child_optional("VTKFile.UnstructuredGrid");
    if (!file || !grid)
      fail("this is no UnstructuredGrid of VTK");
    reverse_ = (attribute(*file, "byte_order", "LittleEndian") == "LittleEndian") != is_little_endian_machine();
    size_of_header_ = attribute(*file, "header_type", "UInt32") == "UInt64" ? 8 : 4;
    if (!attribute(*file, "compressor").empty())
      fail(std::string("the data are compressed") + what_is_needed);
    if (file->get<std::string>("AppendedData.<xmlattr>.encoding", "base64") != "raw")
      fail(std::string("the appended data are encoded") + what_is_needed);
    const Tree* piece = nullptr;
    for (const auto& child : *grid)
      if (child.first == "Piece") {
        if (piece != nullptr)
          fail(std::string("there are several pieces") + what_is_needed);
        piece = &child.second;
      }
    if (piece == nullptr)
      fail("there is no Piece element");
    number_of_vertices_ = piece->get<Global_index>("<xmlattr>.NumberOfPoints", 0);
    number_of_hexahedra_ = piece->get<Global_index>("<xmlattr>.NumberOfCells", 0);
    if (number_of_vertices_ <= 0 || number_of_hexahedra_ <= 0)
      fail("there are no hexahedra in the file");
    points_ = array(*piece, "Points", "", 3 * number_of_vertices_);
    if (points_.type.kind != Number_kind::FLOATING || points_.type.size != 8)
      fail(std::string("the points are not of 64 bits") + what_is_needed);
    types_ = array(*piece, "Cells", "types", number_of_hexahedra_);
    connectivity_ = array(*piece, "Cells", "connectivity", 8 * number_of_hexahedra_);
    find_labels(*piece, label_array);
  }

  void find_labels(const Tree& piece, const std::string& wanted)
  {
    const auto data = piece.get_child_optional("CellData");
    const auto use = [&](const std::string& name, bool is_plain) {
      for (const auto& child : data ? *data : Tree())
        if (child.first == "DataArray" && attribute(child.second, "NumberOfComponents", "1") == "1") {
          const std::string its_name = attribute(child.second, "Name");
          if ((is_plain ? plain_name(its_name) : its_name) == name) {
            labels_ = array(piece, "CellData", its_name, number_of_hexahedra_);
            return true;
          }
        }
      return false;
    };
    if (!wanted.empty()) {
      if (!use(wanted, false))
        fail("there is no array \"" + wanted + "\" with one integral number for each cell");
      return;
    }
    for (const char* usual : usual_label_names)
      if (use(usual, true))
        return;
  }

  Array array(const Tree& piece, const std::string& group, const std::string& name, Global_index size)
  {
    const std::string shown = name.empty() ? "points" : name;
    const auto parent = piece.get_child_optional(group);
    for (const auto& child : parent ? *parent : Tree())
      if (child.first == "DataArray" && (name.empty() || attribute(child.second, "Name") == name)) {
        if (attribute(child.second, "format") != "appended")
          fail("the data of " + shown + " are not appended" + what_is_needed);
        Array result{appended_ + child.second.get<std::uint64_t>("<xmlattr>.offset", 0), type(child.second)};
        if (result.type.size == 0)
          fail("the type of " + shown + " is not known");
        char header[8];
        read_at(result.offset, header, size_of_header_);
        const auto bytes = decode_number<std::uint64_t>(header, {Number_kind::UNSIGNED, size_of_header_}, reverse_);
        if (bytes != static_cast<std::uint64_t>(size) * result.type.size)
          fail("the data of " + shown + " have " + std::to_string(bytes) + " bytes, not those of " +
               std::to_string(size) + " numbers" + what_is_needed);
        result.offset += size_of_header_;
        return result;
      }
    fail("there is no DataArray of " + shown);
  }

  static Number_type type(const Tree& element)
  {
    const std::string name = attribute(element, "type");
    const std::size_t digits = name.find_first_of("0123456789");
    if (digits == std::string::npos)
      return {};
    const std::string kind = name.substr(0, digits), bits = name.substr(digits);
    const std::size_t size = bits == "8" ? 1 : bits == "16" ? 2 : bits == "32" ? 4 : bits == "64" ? 8 : 0;
    if (kind == "Float" && size >= 4)
      return {Number_kind::FLOATING, size};
    if (kind == "Int" || kind == "UInt")
      return {kind == "Int" ? Number_kind::SIGNED : Number_kind::UNSIGNED, size};
    return {};
  }

  // All cells have to be hexahedra.
  void check_cells(Global_index first, Global_index last)
  {
    constexpr int hexahedron_of_vtk = 12;
    std::vector<int> types(static_cast<std::size_t>(last - first));
    read_numbers(types_, first, last, types.data());
    for (std::size_t i = 0; i < types.size(); ++i)
      if (types[i] != hexahedron_of_vtk)
        fail("cell " + std::to_string(first + static_cast<Global_index>(i)) + " is no hexahedron" + what_is_needed);
  }

  template <class Value>
  void read_numbers(const Array& array, Global_index first, Global_index last, Value* values)
  {
    const std::size_t size = array.type.size;
    std::vector<char> bytes;
    for (Global_index begin = first; begin < last; begin += 8 * at_once) {
      const Global_index end = (std::min)(last, begin + 8 * at_once);
      bytes.resize(static_cast<std::size_t>(end - begin) * size);
      read(array.offset + static_cast<std::uint64_t>(begin) * size, bytes.data(), bytes.size());
      for (std::size_t i = 0; i < bytes.size(); i += size)
        *values++ = decode_number<Value>(bytes.data() + i, array.type, reverse_);
    }
  }

  void read_at(std::uint64_t offset, char* bytes, std::size_t size) { Vtu_slices::read(offset, bytes, size); }

  const std::string input_, output_;
  std::ifstream in_;
  std::uint64_t appended_ = 0; // where the data begin
  bool reverse_ = false;
  std::size_t size_of_header_ = 4;
  Global_index number_of_vertices_ = 0, number_of_hexahedra_ = 0;
  Array points_, connectivity_, types_, labels_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_SLICES_H
