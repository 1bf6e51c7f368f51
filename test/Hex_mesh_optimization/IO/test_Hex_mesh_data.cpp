// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Labels are found in the cell arrays of VTK files, and quadrilaterals among their cells.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace {

using Mesh_data = CGAL::IO::Hex_mesh_data;
using Labels = std::vector<std::int64_t>;

void add(Mesh_data& mesh_data, const std::string& name, const CGAL::IO::Hex_mesh_data_array::Values& values,
         std::size_t number_of_components = 1)
{
  mesh_data.cell_data.emplace_back();
  mesh_data.cell_data.back().name = name;
  mesh_data.cell_data.back().number_of_components = number_of_components;
  mesh_data.cell_data.back().values = values;
}

Labels found(const std::string& name)
{
  Mesh_data mesh_data;
  add(mesh_data, name, std::vector<int>{4, -5});
  mesh_data.find_label_array();
  EXPECT_EQ(mesh_data.label_array, mesh_data.hexahedron_labels.empty() ? "" : name);
  return mesh_data.hexahedron_labels;
}

TEST(Hex_mesh_data, labels_have_many_names)
{
  for (const char* name :
       {"material",  "Materials",     "MATERIAL_ID",   "MaterialIds", "material ids", "label",    "labels", "region",
        "region_id", "subdomain",     "domain",        "block",       "block_id",     "BlockId",  "part",   "part_id",
        "medit:ref", "gmsh:physical", "CellEntityIds", "cell_tags",   "ObjectId",     "attribute"})
    EXPECT_EQ(found(name), (Labels{4, -5})) << name;
  for (const char* name : {"", "pressure", "mat erial x", "ids", "GlobalCellId", "quality"})
    EXPECT_TRUE(found(name).empty()) << name;
}

TEST(Hex_mesh_data, labels_are_integral_and_one_for_each_cell)
{
  Mesh_data mesh_data;
  add(mesh_data, "material", std::vector<double>{1, 2.5});
  add(mesh_data, "materials", std::vector<int>{1, 2, 3, 4}, 2);
  add(mesh_data, "material_id", std::vector<std::string>{"1", "2"});
  add(mesh_data, "mat", std::vector<double>{1, std::numeric_limits<double>::quiet_NaN()});
  add(mesh_data, "region", std::vector<std::uint64_t>{1, ~std::uint64_t(0)});
  mesh_data.find_label_array();
  EXPECT_TRUE(mesh_data.hexahedron_labels.empty());
  EXPECT_TRUE(mesh_data.label_array.empty());
  add(mesh_data, "part", std::vector<float>{3, -2});
  add(mesh_data, "label", std::vector<std::int8_t>{7, 8});
  mesh_data.find_label_array();
  EXPECT_EQ(mesh_data.hexahedron_labels, (Labels{7, 8})) << "more telling than \"part\"";
  EXPECT_EQ(mesh_data.label_array, "label");
}

TEST(Hex_mesh_data, any_array_can_be_chosen)
{
  Mesh_data mesh_data;
  add(mesh_data, "material", std::vector<int>{1, 2});
  add(mesh_data, "my own", std::vector<float>{3, 4});
  add(mesh_data, "halves", std::vector<float>{.5, 1.5});
  mesh_data.find_label_array();
  EXPECT_TRUE(mesh_data.use_label_array("my own"));
  EXPECT_EQ(mesh_data.hexahedron_labels, (Labels{3, 4}));
  EXPECT_FALSE(mesh_data.use_label_array("halves"));
  EXPECT_FALSE(mesh_data.use_label_array("My Own"));
  EXPECT_EQ(mesh_data.label_array, "my own");
  EXPECT_EQ(mesh_data.hexahedron_labels, (Labels{3, 4}));
}

TEST(Hex_mesh_data, labels_of_other_cells_are_told_from_those_of_hexahedra)
{
  Mesh_data mesh_data;
  mesh_data.other_cells = {{1, {0}, 0, 0}, {9, {4, 5, 6, 7}, 0, 1}, {8, {0, 1, 3, 2}, 0, 1}, {3, {0, 1}, 0, 2}};
  add(mesh_data, "material", std::vector<int>{10, 1, 20, 30, 2, 40});
  mesh_data.find_label_array();
  EXPECT_EQ(mesh_data.hexahedron_labels, (Labels{1, 2}));
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(mesh_data.other_cells[i].label, 10 * std::int64_t(i + 1));
  const auto quads = mesh_data.labelled_quadrilaterals();
  ASSERT_EQ(quads.size(), 2u);
  EXPECT_EQ(quads[0].vertices, (std::array<std::size_t, 4>{{4, 5, 6, 7}}));
  EXPECT_EQ(quads[0].label, 20);
  EXPECT_EQ(quads[1].vertices, (std::array<std::size_t, 4>{{0, 1, 2, 3}})) << "the corners of a pixel are in rows";
  EXPECT_EQ(quads[1].label, 30);
}

} // namespace
