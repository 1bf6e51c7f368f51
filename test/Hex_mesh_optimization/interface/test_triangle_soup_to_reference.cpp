// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The reference of the engine is the caller's soup, with its marked edges; what no face graph could be is refused.

#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_soup_to_reference.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <list>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

namespace HMO = CGAL::Hex_mesh_optimization;
namespace params = CGAL::parameters;
using Points = std::list<CGAL::Simple_cartesian<double>::Point_3>;
using Triangles = std::vector<std::vector<std::size_t>>;

Points tetrahedron() { return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }

const Triangles of_tetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

// Every edge once, the lower vertex first
struct Recording_map
{
  std::vector<std::pair<std::size_t, std::size_t>>* asked;
  friend bool get(const Recording_map& map, const std::pair<std::size_t, std::size_t>& edge)
  {
    map.asked->push_back(edge);
    return edge.first == 1;
  }
};

TEST(Triangle_soup_to_reference, keeps_points_and_triangles_in_order)
{
  const Reference_input reference = triangle_soup_to_reference(tetrahedron(), of_tetrahedron, params::default_values());
  ASSERT_EQ(reference.points.size(), 4u);
  EXPECT_EQ(reference.points[2], Vector_3(0, 1, 0));
  EXPECT_EQ(reference.triangles, (std::vector<Triangle_indices>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
  EXPECT_FALSE(reference.sharp_is_given);
}

TEST(Triangle_soup_to_reference, asks_for_each_edge_once)
{
  std::vector<std::pair<std::size_t, std::size_t>> asked;
  const Reference_input reference = triangle_soup_to_reference(tetrahedron(), of_tetrahedron,
                                                               params::edge_is_constrained_map(Recording_map{&asked}));
  EXPECT_EQ(asked, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
  EXPECT_TRUE(reference.sharp_is_given);
  EXPECT_EQ(reference.sharp, (Edge_list{{1, 2}, {1, 3}}));
}

void expect_refused(std::size_t triangle, const Triangles& triangles, const std::string& words)
{
  try {
    triangle_soup_to_reference(tetrahedron(), triangles, params::default_values());
    ADD_FAILURE() << "nothing was thrown for " << words;
  }
  catch (const HMO::Input_error& error) {
    EXPECT_EQ(error.element(), HMO::Input_error::Element::REFERENCE_FACE);
    EXPECT_EQ(error.element_index(), triangle);
    EXPECT_NE(error.message().find(words), std::string::npos) << error.message();
  }
}

TEST(Triangle_soup_to_reference, refuses_what_is_no_oriented_surface)
{
  expect_refused(1, {{0, 2, 1}, {0, 1, 3, 2}}, "4 vertices");
  expect_refused(1, {{0, 2, 1}, {0, 1, 4}}, "not one of its 4 points");
  expect_refused(0, {{0, 2, 2}}, "twice");
  expect_refused(1, {{0, 1, 2}, {0, 1, 3}}, "in the same direction as triangle 0");
  Triangles three = of_tetrahedron;
  three.push_back({0, 1, 2});
  expect_refused(4, three, "in the same direction as triangle 1");
}

} // namespace
