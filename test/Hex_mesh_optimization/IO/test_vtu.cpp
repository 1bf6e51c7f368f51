// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// VTK files in XML: all of their data come back, and what cannot be read is refused.

#include "Io_test.h"

#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB
#include <zlib.h>
#endif

#include <string>
#include <vector>

namespace {

class Vtu : public Io_test
{};

TEST_F(Vtu, in_other_layouts)
{
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  const auto read = [&](const std::string& text) {
    points.clear();
    hexahedra.clear();
    read_hex_mesh(write("a.vtu", text), points, hexahedra);
    return points.size() == 8 && hexahedra.size() == 1 && points[6] == Simple::Point_3(1, 1, 1) &&
           points[1] == Simple::Point_3(1, 0, 0) && hexahedra[0] == Cell{0, 1, 2, 3, 4, 5, 6, 7};
  };
  const std::string ascii = "format=\"ascii\">";
  const std::string text = vtu("", ascii + cube_points, ascii + "0 1 2 3 4 5 6 7", ascii + "8", ascii + "12");
  EXPECT_TRUE(read(text));
  EXPECT_TRUE(read(vtu("", ascii + cube_points, ascii + "0 1 3 2 4 5 7 6", ascii + "8", ascii + "11"))) << "voxel";

  for (const bool little : {true, false})
    for (const bool wide : {true, false}) {
      const std::string attributes = std::string("byte_order=\"") + (little ? "LittleEndian" : "BigEndian") +
                                     "\" header_type=\"" + (wide ? "UInt64" : "UInt32") + "\"";
      const std::string blocks[4] = {
        bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1}, little),
        bytes_of<std::int32_t>({0, 1, 2, 3, 4, 5, 6, 7}, little), bytes_of<std::int32_t>({8}, little),
        bytes_of<std::uint8_t>({12}, little)};
      const auto size = [&](std::size_t s) {
        return wide ? bytes_of<std::uint64_t>({s}, little) : bytes_of<std::uint32_t>({std::uint32_t(s)}, little);
      };

      std::string inlined[4], split[4], raw[4], encoded[4], raw_data, encoded_data;
      for (int b = 0; b < 4; ++b) {
        const std::string header = size(blocks[b].size());
        inlined[b] = "format=\"binary\">\n  " + base64(header + blocks[b]) + "\n";
        split[b] = "format=\"binary\">\n" + base64(header) + base64(blocks[b]) + "\n";
        raw[b] = "format=\"appended\" offset=\"" + std::to_string(raw_data.size()) + "\">";
        raw_data += header + blocks[b];
        encoded[b] = "format=\"appended\" offset=\"" + std::to_string(encoded_data.size()) + "\">";
        encoded_data += base64(header + blocks[b]);
      }
      EXPECT_TRUE(read(vtu(attributes, inlined[0], inlined[1], inlined[2], inlined[3])));
      EXPECT_TRUE(read(vtu(attributes, split[0], split[1], split[2], split[3])));
      EXPECT_TRUE(read(vtu(attributes, raw[0], raw[1], raw[2], raw[3],
                           "<AppendedData encoding=\"raw\">\n  _" + raw_data + "\n</AppendedData>")));
      EXPECT_TRUE(read(vtu(attributes, encoded[0], encoded[1], encoded[2], encoded[3],
                           "<AppendedData encoding=\"base64\">\n_" + encoded_data + "\n</AppendedData>")));
      refused("a.vtu",
              vtu(attributes, raw[0], raw[1], raw[2], raw[3],
                  "<AppendedData encoding=\"raw\">\n  _" + raw_data.substr(0, 40) + "\n</AppendedData>"),
              0, "incomplete");
      refused("a.vtu", vtu(attributes, inlined[0].substr(0, 60), inlined[1], inlined[2], inlined[3]), 0, "incomplete");
      refused("a.vtu", vtu(attributes, inlined[1], inlined[1], inlined[2], inlined[3]), 0, "32 bytes, not 96");
    }

#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB
  const auto compressed = [&](const std::string& block, std::size_t block_size) {
    std::vector<std::uint32_t> header = {std::uint32_t((block.size() + block_size - 1) / block_size),
                                         std::uint32_t(block_size), std::uint32_t(block.size() % block_size)};
    std::string data, head;
    for (std::size_t begin = 0; begin < block.size(); begin += block_size) {
      const std::string part = block.substr(begin, block_size);
      std::string packed(compressBound(part.size()), ' ');
      uLongf length = packed.size();
      compress(reinterpret_cast<Bytef*>(&packed[0]), &length, reinterpret_cast<const Bytef*>(part.data()), part.size());
      data += packed.substr(0, length);
      header.push_back(std::uint32_t(length));
    }
    for (const std::uint32_t h : header)
      CGAL::Hex_mesh_optimization::internal::IO::append_binary(head, h, true);
    return "format=\"binary\">" + base64(head) + base64(data);
  };
  const std::string with_zlib = "compressor=\"vtkZLibDataCompressor\"";
  for (const std::size_t block_size : {1000, 96, 32, 7})
    EXPECT_TRUE(read(
      vtu(with_zlib,
          compressed(bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1}, true),
                     block_size),
          compressed(bytes_of<std::int32_t>({0, 1, 2, 3, 4, 5, 6, 7}, true), block_size),
          compressed(bytes_of<std::int32_t>({8}, true), block_size),
          compressed(bytes_of<std::uint8_t>({12}, true), block_size))));
#else
  refused("a.vtu", vtu("compressor=\"vtkZLibDataCompressor\"", ascii, ascii, ascii, ascii), 0, "without zlib");
#endif
}

TEST_F(Vtu, errors)
{
  const std::string ascii = "format=\"ascii\">";
  const std::string p = ascii + cube_points, c = ascii + "0 1 2 3 4 5 6 7", o = ascii + "8", t = ascii + "12";
  refused("a.vtu", "<a>\n<b>\n</a>\n", 4, "unexpected end of data");
  refused("a.vtu", "<a></a>", 0, "no VTKFile element");
  refused("a.vtu", "<VTKFile type=\"PolyData\"></VTKFile>", 0, "the file holds a PolyData");
  refused("a.vtu", "<VTKFile type=\"UnstructuredGrid\"></VTKFile>", 0, "no UnstructuredGrid");
  refused("a.vtu", vtu("byte_order=\"Middle\"", p, c, o, t), 0, "byte order");
  refused("a.vtu", vtu("compressor=\"vtkLZMADataCompressor\"", p, c, o, t), 0, "vtkLZMADataCompressor");
  refused("a.vtu", vtu("", p, ascii + "0 1 2 3 4 5 6 8", o, t), 0, "cell 0: point 8 does not exist");
  refused("a.vtu", vtu("", p, ascii + "0 1 2 3 4 5 6 -2", o, t), 0, "cell 0: point -2 does not exist");
  refused("a.vtu", vtu("", p, ascii + "0 1 2 3 4 5 6", o, t), 0, "incomplete");
  refused("a.vtu", vtu("", p, ascii + "0 1 2 3 4 5 6 7 8", o, t), 0, "longer than");
  refused("a.vtu", vtu("", p, c, ascii + "99999999999999", t), 0, "connectivity are incomplete");
  refused("a.vtu", vtu("", p, c, ascii + "-1", t), 0, "do not ascend");
  refused("a.vtu", vtu("", p, c, o, ascii + "14"), 0, "cell 0: it is a pyramid");
  for (const char* type : {"25", "29", "72"})
    refused("a.vtu", vtu("", p, c, o, ascii + type), 0,
            std::string("cell 0: it is a hexahedron of higher order (type ") + type);
  refused("a.vtu", vtu("", p, c, o, "format=\"appended\" offset=\"77\">"), 0, "outside the file");
  refused("a.vtu", vtu("", p, c, o, "format=\"new\">"), 0, "\"new\"");
  refused("a.vtu", vtu("", ascii + "nan" + cube_points.substr(1), c, o, t), 0, "not a finite number");
  std::string many = vtu("", p, c, o, t);
  many.replace(many.find("NumberOfPoints=\"8\""), 18, "NumberOfPoints=\"88888888888888888\"");
  refused("a.vtu", many, 0, "incomplete");
}

// What a reader and writer of VTK would write: active arrays, names of components, values of the mesh as a whole
TEST_F(Vtu, data_come_back)
{
  const std::string text =
    "<?xml version=\"1.0\"?>\n"
    "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
    "<UnstructuredGrid>\n<FieldData>\n"
    "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">\n0.5\n</DataArray>\n"
    "<DataArray type=\"String\" Name=\"who\" NumberOfTuples=\"2\" format=\"ascii\">\n72 105 0\n0\n</DataArray>\n"
    "</FieldData>\n<Piece NumberOfPoints=\"8\" NumberOfCells=\"2\">\n"
    "<PointData Vectors=\"v\">\n"
    "<DataArray type=\"Float32\" Name=\"v\" NumberOfComponents=\"3\" ComponentName0=\"x &amp; y\" format=\"ascii\">\n"
    "0 0 1\n0 1 0\n1 0 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n0.5 1e-09 3\n</DataArray>\n</PointData>\n"
    "<CellData Scalars=\"MaterialIds\">\n"
    "<DataArray type=\"Int64\" Name=\"MaterialIds\" format=\"ascii\">\n7\n-1\n</DataArray>\n"
    "<DataArray type=\"UInt8\" Name=\"flags\" NumberOfComponents=\"2\" format=\"ascii\">\n1 2\n3 255\n</DataArray>\n"
    "</CellData>\n<Points>\n"
    "<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n" +
    cube_points +
    "</DataArray>\n</Points>\n<Cells>\n"
    "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n0 1 2 3\n0 1 2 3 4 5 6 7\n</DataArray>\n"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n4\n12\n</DataArray>\n"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n9\n12\n</DataArray>\n</Cells>\n"
    "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  Mesh_data mesh_data;
  read_hex_mesh(write("a.vtu", text), points, hexahedra, mesh_data);
  EXPECT_TRUE(mesh_data.skipped.empty()) << mesh_data.skipped[0];
  EXPECT_EQ(mesh_data.hexahedron_labels, std::vector<std::int64_t>{-1});
  EXPECT_EQ(mesh_data.other_cells.at(0).label, 7);
  EXPECT_EQ(mesh_data.field_data.at(1).values, Array::Values(std::vector<std::string>{"Hi", ""}));
  write_hex_mesh(path("b.vtu"), points, hexahedra, mesh_data);
  EXPECT_EQ(content(path("b.vtu")), text);
}

// A piece with a hexahedron above the unit cube, after one with the cube
std::string second_piece(const std::string& data)
{
  return "<Piece NumberOfPoints=\"4\" NumberOfCells=\"0\"><Points><DataArray type=\"Float32\" "
         "NumberOfComponents=\"3\" format=\"ascii\">0 0 2 1 0 2 1 1 2 0 1 2</DataArray></Points>" +
         data + "</Piece></UnstructuredGrid>";
}

TEST_F(Vtu, pieces_are_joined)
{
  const std::string ascii = "format=\"ascii\">";
  const auto with_data = [&](const std::string& first, const std::string& second) {
    std::string text = vtu("", ascii + cube_points, ascii + "0 1 2 3 4 5 6 7", ascii + "8", ascii + "12");
    const std::size_t begin = text.find("<PointData>"), end = text.find("</PointData>") + 12;
    text.replace(begin, end - begin, first);
    text.replace(text.find("</UnstructuredGrid>"), 19, second_piece(second));
    return write("a.vtu", text);
  };
  const auto data = [](const std::string& type, const std::string& values) {
    return "<PointData><DataArray type=\"" + type + "\" Name=\"p\" format=\"ascii\">" + values +
           "</DataArray></PointData>";
  };
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  Mesh_data mesh_data;
  read_hex_mesh(with_data(data("Int8", "1 2 3 4 5 6 7 8"), data("Int8", "9 10 11 12")), points, hexahedra, mesh_data);
  EXPECT_EQ(points.size(), 12u);
  ASSERT_EQ(mesh_data.point_data.size(), 1u);
  EXPECT_EQ(mesh_data.point_data[0].values,
            Array::Values(std::vector<std::int8_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));

  for (const std::string& other : {data("Int16", "9 10 11 12"), data("Int8", "9 10 11"), std::string()}) {
    read_hex_mesh(with_data(data("Int8", "1 2 3 4 5 6 7 8"), other), points, hexahedra, mesh_data);
    EXPECT_TRUE(mesh_data.point_data.empty());
    bool is_named = false;
    for (const std::string& line : mesh_data.skipped)
      is_named = is_named || line.find("\"p\"") != std::string::npos;
    EXPECT_TRUE(is_named) << other;
  }
}

TEST_F(Vtu, damaged_data_are_named)
{
  const std::string ascii = "format=\"ascii\">";
  const std::string text = vtu("", ascii + cube_points, ascii + "0 1 2 3 4 5 6 7", ascii + "8", ascii + "12");
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  Mesh_data mesh_data;
  read_hex_mesh(write("a.vtu", text), points, hexahedra, mesh_data);
  EXPECT_EQ(hexahedra.size(), 1u);
  ASSERT_EQ(mesh_data.skipped.size(), 2u);
  EXPECT_NE(mesh_data.skipped[0].find("\"p\" are incomplete"), std::string::npos) << mesh_data.skipped[0];
  EXPECT_NE(mesh_data.skipped[1].find("a string of \"a\" has no end"), std::string::npos) << mesh_data.skipped[1];
  EXPECT_TRUE(mesh_data.point_data.empty() && mesh_data.field_data.empty());

  std::string key = text;
  key.replace(key.find("nan<"), 3,
              "1 2 3 4 5 6 7 8<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">m"
              "</InformationKey><InformationKey name=\"L2_NORM_RANGE\"></InformationKey>");
  read_hex_mesh(write("a.vtu", key), points, hexahedra, mesh_data);
  EXPECT_EQ(mesh_data.point_data.size(), 1u);
  EXPECT_EQ(mesh_data.skipped.at(0), "the information key \"UNITS_LABEL\" of the array \"p\" of the points");
}

} // namespace
