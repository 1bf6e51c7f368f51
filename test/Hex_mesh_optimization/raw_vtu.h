// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_RAW_VTU_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_RAW_VTU_H

// Meshes that are optimized in parts, and the .vtu files with raw appended data that they are in.

#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/quality.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace test {

struct Labelled_mesh
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  std::vector<int> labels; // of the hexahedra, or none

  CGAL::Hex_mesh_optimization::Quality_statistics statistics() const
  {
    return CGAL::Hex_mesh_optimization::quality_statistics(points, hexahedra);
  }
};

inline Labelled_mesh tangled_ball(std::size_t n)
{
  Labelled_mesh mesh;
  CGAL::Hex_mesh_optimization::make_ball(mesh.points, mesh.hexahedra, n);
  CGAL::Hex_mesh_optimization::scramble_interior(mesh.points, mesh.hexahedra, 7, .6);
  return mesh;
}

// labels: of the hexahedra, or none
template <class Point>
void write_raw_vtu(const std::string& filename, const std::vector<Point>& points,
                   const std::vector<std::array<std::size_t, 8>>& hexahedra, const std::vector<int>& labels = {})
{
  std::string arrays[5]; // in the order of the file
  std::vector<std::uint64_t> offsets(1, 0);
  const auto append = [](std::string& to, auto number) {
    to.append(reinterpret_cast<const char*>(&number), sizeof(number));
  };
  for (const Point& p : points)
    for (int i = 0; i < 3; ++i)
      append(arrays[0], double(p[i]));
  for (std::size_t h = 0; h < hexahedra.size(); ++h) {
    for (std::size_t v : hexahedra[h])
      append(arrays[1], static_cast<std::int64_t>(v));
    append(arrays[2], static_cast<std::int64_t>(8 * h + 8));
    append(arrays[3], static_cast<std::uint8_t>(12));
    if (!labels.empty())
      append(arrays[4], static_cast<std::int32_t>(labels[h]));
  }
  for (const std::string& a : arrays)
    offsets.push_back(offsets.back() + 8 + a.size());
  std::ofstream out(filename, std::ios::binary);
  const auto array = [&](int i, const std::string& attributes) {
    out << "<DataArray " << attributes << " format=\"appended\" offset=\"" << offsets[i] << "\"/>\n";
  };
  out << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << points.size() << "\" NumberOfCells=\"" << hexahedra.size()
      << "\">\n<Points>\n";
  array(0, "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"");
  out << "</Points>\n<Cells>\n";
  array(1, "type=\"Int64\" Name=\"connectivity\"");
  array(2, "type=\"Int64\" Name=\"offsets\"");
  array(3, "type=\"UInt8\" Name=\"types\"");
  out << "</Cells>\n";
  if (!labels.empty()) {
    out << "<CellData>\n";
    array(4, "type=\"Int32\" Name=\"material\"");
    out << "</CellData>\n";
  }
  out << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  for (const std::string& a : arrays) {
    std::string header;
    append(header, static_cast<std::uint64_t>(a.size()));
    out << header << a;
  }
  out << "\n</AppendedData>\n</VTKFile>\n";
}

} // namespace test

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_RAW_VTU_H
