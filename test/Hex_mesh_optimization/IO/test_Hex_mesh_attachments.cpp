// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Labels are found in the cell arrays of VTK files, and quadrilaterals among their cells.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_attachments.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace {

using Attachments = CGAL::IO::Hex_mesh_attachments;
using Labels = std::vector<std::int64_t>;

void add(Attachments& attachments, const std::string& name, const CGAL::IO::Hex_mesh_data_array::Values& values,
         std::size_t number_of_components = 1)
{
  attachments.cell_data.emplace_back();
  attachments.cell_data.back().name = name;
  attachments.cell_data.back().number_of_components = number_of_components;
  attachments.cell_data.back().values = values;
}

Labels found(const std::string& name)
{
  Attachments attachments;
  add(attachments, name, std::vector<int>{4, -5});
  attachments.find_label_array();
  EXPECT_EQ(attachments.label_array, attachments.hexahedron_labels.empty() ? "" : name);
  return attachments.hexahedron_labels;
}

TEST(Hex_mesh_attachments, labels_have_many_names)
{
  for (const char* name :
       {"material",  "Materials",     "MATERIAL_ID",   "MaterialIds", "material ids", "label",    "labels", "region",
        "region_id", "subdomain",     "domain",        "block",       "block_id",     "BlockId",  "part",   "part_id",
        "medit:ref", "gmsh:physical", "CellEntityIds", "cell_tags",   "ObjectId",     "attribute"})
    EXPECT_EQ(found(name), (Labels{4, -5})) << name;
  for (const char* name : {"", "pressure", "mat erial x", "ids", "GlobalCellId", "quality"})
    EXPECT_TRUE(found(name).empty()) << name;
}

TEST(Hex_mesh_attachments, labels_are_integral_and_one_for_each_cell)
{
  Attachments attachments;
  add(attachments, "material", std::vector<double>{1, 2.5});
  add(attachments, "materials", std::vector<int>{1, 2, 3, 4}, 2);
  add(attachments, "material_id", std::vector<std::string>{"1", "2"});
  add(attachments, "mat", std::vector<double>{1, std::numeric_limits<double>::quiet_NaN()});
  add(attachments, "region", std::vector<std::uint64_t>{1, ~std::uint64_t(0)});
  attachments.find_label_array();
  EXPECT_TRUE(attachments.hexahedron_labels.empty());
  EXPECT_TRUE(attachments.label_array.empty());
  add(attachments, "part", std::vector<float>{3, -2});
  add(attachments, "label", std::vector<std::int8_t>{7, 8});
  attachments.find_label_array();
  EXPECT_EQ(attachments.hexahedron_labels, (Labels{7, 8})) << "more telling than \"part\"";
  EXPECT_EQ(attachments.label_array, "label");
}

TEST(Hex_mesh_attachments, any_array_can_be_chosen)
{
  Attachments attachments;
  add(attachments, "material", std::vector<int>{1, 2});
  add(attachments, "my own", std::vector<float>{3, 4});
  add(attachments, "halves", std::vector<float>{.5, 1.5});
  attachments.find_label_array();
  EXPECT_TRUE(attachments.use_label_array("my own"));
  EXPECT_EQ(attachments.hexahedron_labels, (Labels{3, 4}));
  EXPECT_FALSE(attachments.use_label_array("halves"));
  EXPECT_FALSE(attachments.use_label_array("My Own"));
  EXPECT_EQ(attachments.label_array, "my own");
  EXPECT_EQ(attachments.hexahedron_labels, (Labels{3, 4}));
}

TEST(Hex_mesh_attachments, labels_of_other_cells_are_told_from_those_of_hexahedra)
{
  Attachments attachments;
  attachments.other_cells = {{1, {0}, 0, 0}, {9, {4, 5, 6, 7}, 0, 1}, {8, {0, 1, 3, 2}, 0, 1}, {3, {0, 1}, 0, 2}};
  add(attachments, "material", std::vector<int>{10, 1, 20, 30, 2, 40});
  attachments.find_label_array();
  EXPECT_EQ(attachments.hexahedron_labels, (Labels{1, 2}));
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(attachments.other_cells[i].label, 10 * std::int64_t(i + 1));
  const auto quads = attachments.labelled_quadrilaterals();
  ASSERT_EQ(quads.size(), 2u);
  EXPECT_EQ(quads[0].vertices, (std::array<std::size_t, 4>{{4, 5, 6, 7}}));
  EXPECT_EQ(quads[0].label, 20);
  EXPECT_EQ(quads[1].vertices, (std::array<std::size_t, 4>{{0, 1, 2, 3}})) << "the corners of a pixel are in rows";
  EXPECT_EQ(quads[1].label, 30);
}

} // namespace
