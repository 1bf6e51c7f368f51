// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_IO_IO_TEST_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_IO_IO_TEST_H

// What the tests of files share: a folder for each, and the text of small meshes.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/base64.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/binary_number.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

using Simple = CGAL::Simple_cartesian<double>;
using Cell = std::array<std::size_t, 8>;
using Points = std::vector<Simple::Point_3>;
using Cells = std::vector<Cell>;
using Array = CGAL::IO::Hex_mesh_data_array;
using Role = Array::Role;
using Mesh_data = CGAL::IO::Hex_mesh_data;

// CGAL::IO::read_hex_mesh() and CGAL::IO::write_hex_mesh(), which are templates: compiled once for these types.
void read_hex_mesh(const std::string& filename, Points& points, Cells& hexahedra, Mesh_data& mesh_data);
void read_hex_mesh(const std::string& filename, Points& points, Cells& hexahedra);
void write_hex_mesh(const std::string& filename, const Points& points, const Cells& hexahedra,
                    const Mesh_data& mesh_data = Mesh_data());
void write_hex_mesh(const std::string& filename, const Points& points, const Cells& hexahedra,
                    const Mesh_data& mesh_data, bool is_binary);

// A folder of its own for every test, removed at the end.
class Io_test : public ::testing::Test
{
protected:
  Io_test()
  {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("hex_mesh_io_" + std::string(info->name()) + "_" + std::to_string(std::random_device()()));
    std::filesystem::create_directory(folder_);
  }

  ~Io_test() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  static std::string content(const std::string& filename)
  {
    std::ostringstream out;
    out << std::ifstream(filename, std::ios::binary).rdbuf();
    return out.str();
  }

  // Reading must fail at this line for this reason, and change nothing.
  void refused(const std::string& name, const std::string& text, std::size_t line, const std::string& reason) const
  {
    const std::string filename = write(name, text);
    std::vector<Simple::Point_3> points(1, Simple::Point_3(7, 8, 9));
    std::vector<Cell> hexahedra(2);
    try {
      read_hex_mesh(filename, points, hexahedra);
      ADD_FAILURE() << "nothing was thrown for " << reason;
    }
    catch (const CGAL::IO::Hex_mesh_file_error& error) {
      EXPECT_EQ(error.file(), filename);
      EXPECT_EQ(error.line(), line) << error.what();
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
      const std::string start = filename + ":" + (line == 0 ? "" : std::to_string(line) + ":") + " ";
      EXPECT_EQ(std::string(error.what()).substr(0, start.size()), start);
    }
    EXPECT_EQ(points.size(), 1u);
    EXPECT_EQ(hexahedra.size(), 2u);
  }

  std::filesystem::path folder_;
};

// Two cubes with unreferenced points between and coordinates that are hard to print.
template <class Point>
void make_mesh(std::vector<Point>& points, std::vector<Cell>& hexahedra)
{
  std::mt19937_64 random(1);
  points.emplace_back(5., -0., 1. / 3.); // unreferenced
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i)
        points.emplace_back(i + 1e-9 * double(random()) / 1e19, j * 0.1 + 1e-17, k / 7.);
  points.emplace_back(std::numeric_limits<double>::denorm_min(), (std::numeric_limits<double>::max)(), 1e-300);
  points.emplace_back(-1.7976931348623157e308, 123456789.123456789, 2.2250738585072014e-308);
  hexahedra = {{5, 6, 8, 7, 9, 10, 12, 11}, {1, 2, 4, 3, 5, 6, 8, 7}};
}

inline const std::string cube_points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n";

inline std::string medit_vertices()
{
  std::string text = "Vertices\n8\n";
  std::istringstream in(cube_points);
  for (std::string line; std::getline(in, line);)
    text += line + " 0\n";
  return text;
}

inline const std::string medit_header = "MeshVersionFormatted 2\nDimension 3\n"; // lines 1 and 2
inline const std::string medit_hexahedra = "Hexahedra\n1\n1 2 3 4 5 6 7 8 0\n";  // 3 lines
inline const std::string vtk_header =
  "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\n"; // lines 1 to 4
inline const std::string vtk_points = "POINTS 8 double\n" + cube_points;   // lines 5 to 13
inline const std::string vtk_cells = "CELLS 1 9\n8 0 1 2 3 4 5 6 7\n";     // lines 14 and 15

template <class Number>
std::string bytes_of(std::initializer_list<Number> numbers, bool little_endian)
{
  std::string text;
  for (const Number n : numbers)
    CGAL::Hex_mesh_optimization::internal::IO::append_binary(text, n, little_endian);
  return text;
}

inline std::string vtu(const std::string& attributes, const std::string& points, const std::string& connectivity,
                       const std::string& offsets, const std::string& types, const std::string& appended = "")
{
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" " + attributes +
         ">\n"
         "<!-- a comment --><UnstructuredGrid><FieldData><DataArray type=\"String\" Name=\"a\" "
         "format=\"ascii\">9</DataArray>"
         "</FieldData><Piece NumberOfPoints=\"8\" NumberOfCells=\"1\">\n"
         "<PointData><DataArray type=\"Float32\" Name=\"p\" format=\"ascii\">nan</DataArray></PointData>\n"
         "<Cells><DataArray type=\"Int32\" Name=\"connectivity\" " +
         connectivity +
         "</DataArray>\n"
         "<DataArray type=\"Int32\" Name=\"offsets\" " +
         offsets +
         "</DataArray>\n"
         "<DataArray type=\"UInt8\" Name=\"types\" " +
         types +
         "</DataArray></Cells>\n"
         "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" " +
         points +
         "<InformationKey name=\"L2\" location=\"x\">\n</InformationKey></DataArray></Points>\n"
         "</Piece></UnstructuredGrid>" +
         appended + "</VTKFile>\n";
}

inline std::string base64(const std::string& bytes)
{
  std::string text;
  CGAL::Hex_mesh_optimization::internal::IO::append_base64(text, bytes);
  return text;
}

// Name, role, type, shape and every value
inline void expect_same_arrays(const std::vector<Array>& a, const std::vector<Array>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    SCOPED_TRACE(a[i].name);
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(int(a[i].role), int(b[i].role));
    EXPECT_EQ(a[i].number_of_components, b[i].number_of_components);
    EXPECT_EQ(a[i].values, b[i].values);
    EXPECT_EQ(a[i].lookup_table, b[i].lookup_table);
    EXPECT_EQ(a[i].metadata, b[i].metadata);
    EXPECT_EQ(a[i].attributes, b[i].attributes);
  }
}

// An array of so many values for each type that there is, the extreme ones among them
inline std::vector<Array> arrays_of_all_types(std::size_t size, std::size_t number_of_components)
{
  std::vector<Array> arrays;
  std::mt19937_64 random(size + number_of_components);
  const auto add = [&](auto values, const std::string& name) {
    using Value = typename decltype(values)::value_type;
    if constexpr (std::is_same<Value, std::string>::value)
      for (std::size_t i = 0; i < size; ++i)
        values.push_back(i == 0 ? std::string() : "a string\t%20 \"with\" <&> " + std::string(i % 100, 'x'));
    else if constexpr (std::is_same<Value, bool>::value)
      for (std::size_t i = 0; i < size; ++i)
        values.push_back(random() % 2 == 0);
    else
      for (std::size_t i = 0; i < size; ++i)
        values.push_back(i == 0                                 ? (std::numeric_limits<Value>::max)()
                         : i == 1                               ? std::numeric_limits<Value>::lowest()
                         : std::is_floating_point<Value>::value ? static_cast<Value>(1 / double(random()))
                                                                : static_cast<Value>(random()));
    Array array;
    array.name = name;
    array.number_of_components = number_of_components;
    array.values = values;
    arrays.push_back(array);
  };
  add(std::vector<std::int8_t>(), "int8");
  add(std::vector<std::uint8_t>(), "uint8");
  add(std::vector<std::int16_t>(), "int16");
  add(std::vector<std::uint16_t>(), "uint16");
  add(std::vector<std::int32_t>(), "int32, of two words");
  add(std::vector<std::uint32_t>(), "uint32");
  add(std::vector<std::int64_t>(), "int64");
  add(std::vector<std::uint64_t>(), "uint64");
  add(std::vector<float>(), "float <&> \"quoted\"");
  add(std::vector<double>(), "double");
  add(std::vector<bool>(), "bits");
  add(std::vector<std::string>(), "strings");
  return arrays;
}

// Two hexahedra with a line before, a triangle and a quadrilateral between and a vertex after them
inline void add_other_cells(Mesh_data& mesh_data)
{
  mesh_data.other_cells = {{3, {0, 5}, 0, 0}, {5, {1, 2, 3}, 0, 1}, {9, {5, 6, 8, 7}, 0, 1}, {1, {13}, 0, 2}};
}

inline void expect_same_cells(const Mesh_data& a, const Mesh_data& b)
{
  ASSERT_EQ(a.other_cells.size(), b.other_cells.size());
  for (std::size_t i = 0; i < a.other_cells.size(); ++i) {
    EXPECT_EQ(a.other_cells[i].type, b.other_cells[i].type);
    EXPECT_EQ(a.other_cells[i].vertices, b.other_cells[i].vertices);
    EXPECT_EQ(a.other_cells[i].label, b.other_cells[i].label);
    EXPECT_EQ(a.other_cells[i].number_of_hexahedra_before, b.other_cells[i].number_of_hexahedra_before);
  }
}

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_IO_IO_TEST_H
