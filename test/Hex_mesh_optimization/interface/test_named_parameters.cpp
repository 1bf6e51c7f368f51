// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Named parameters reach the engine, defaults stay what they are, and values that cannot be used are refused by name.

#include <CGAL/Hex_mesh_optimization/internal/interface/named_parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

namespace HMO = CGAL::Hex_mesh_optimization;
namespace params = CGAL::parameters;

const std::vector<std::size_t> keys = {10, 11, 12};

TEST(Named_parameters, left_out_are_the_defaults)
{
  const Chosen_parameters given = chosen_parameters(params::default_values(), keys), expected;
  EXPECT_EQ(given.method, expected.method);
  EXPECT_EQ(given.fixed_boundary, expected.fixed_boundary);
  EXPECT_EQ(given.boundary_placement, expected.boundary_placement);
  EXPECT_EQ(given.target_quality, expected.target_quality);
  EXPECT_EQ(given.maximum_deviation, expected.maximum_deviation);
  EXPECT_EQ(given.features.angle_bound, expected.features.angle_bound);
  EXPECT_EQ(given.rectification.iterations, expected.rectification.iterations);
  EXPECT_FALSE(given.on_iteration);
  EXPECT_FALSE(given.target_length);
  EXPECT_EQ(constrained_vertices(params::default_values(), keys), std::vector<char>(3, false));
}

TEST(Named_parameters, that_are_given_reach_the_engine)
{
  const Chosen_parameters p = chosen_parameters(params::fixed_boundary(true)
                                                  .target_quality(.4)
                                                  .maximum_deviation(.5)
                                                  .maximum_running_time(6)
                                                  .features_angle_bound(70)
                                                  .number_of_iterations(8)
                                                  .surface_weight(9)
                                                  .boundary_placement(HMO::Boundary_placement::ON_SURFACE),
                                                keys);
  EXPECT_TRUE(p.fixed_boundary);
  EXPECT_EQ(p.target_quality, .4);
  EXPECT_EQ(p.maximum_deviation, .5);
  EXPECT_EQ(p.maximum_running_time, 6);
  EXPECT_EQ(p.features.angle_bound, 70);
  EXPECT_EQ(p.rectification.iterations, 8u);
  EXPECT_EQ(p.rectification.surface_weight, 9);
  EXPECT_EQ(p.boundary_placement, HMO::Boundary_placement::ON_SURFACE);
}

template <class NamedParameters>
void expect_refused(const NamedParameters& np, const std::string& name)
{
  try {
    chosen_parameters(np, keys);
    ADD_FAILURE() << "nothing was thrown for " << name;
  }
  catch (const HMO::Input_error& error) {
    EXPECT_EQ(error.element(), HMO::Input_error::Element::PARAMETER);
    EXPECT_NE(error.message().find(name), std::string::npos) << error.message();
  }
}

TEST(Named_parameters, without_a_usable_value_are_refused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  expect_refused(params::target_quality(nan), "target_quality");
  for (const double bad : {0., -1., nan}) {
    expect_refused(params::maximum_deviation(bad), "maximum_deviation");
    expect_refused(params::surface_weight(bad), "surface_weight");
  }
  expect_refused(params::surface_weight(infinity), "surface_weight");
  expect_refused(params::maximum_running_time(-1), "maximum_running_time");
  expect_refused(params::features_angle_bound(181), "features_angle_bound");
}

struct Length_map
{
  using key_type = std::pair<std::size_t, std::size_t>;
  friend double get(const Length_map&, const key_type& edge) { return double(edge.first) + double(edge.second) / 100; }
};

struct Is_even
{
  friend bool get(const Is_even&, std::size_t key) { return key % 2 == 0; }
};

TEST(Named_parameters, that_are_maps_are_asked_by_the_keys_of_the_caller)
{
  const Chosen_parameters p = chosen_parameters(params::target_edge_length_map(Length_map()), keys);
  EXPECT_EQ(p.target_length(2, 0), 12.1);
  EXPECT_EQ(constrained_vertices(params::vertex_is_constrained_map(Is_even()), keys),
            (std::vector<char>{true, false, true}));
}

struct Parity
{
  friend long get(const Parity&, std::size_t key) { return long(key % 2) - 1; }
};

TEST(Named_parameters, that_divide_the_mesh_reach_the_engine)
{
  EXPECT_TRUE(regions(params::default_values(), keys).labels.empty());
  const std::vector<std::vector<unsigned>> faces = {{1, 2, 3, 4}, {8, 7, 6, 5}};
  const Regions r = regions(params::hexahedron_label_map(Parity()).internal_faces(faces), keys);
  EXPECT_EQ(r.labels, (std::vector<int>{-1, 0, -1}));
  EXPECT_EQ(r.faces, (std::vector<std::array<int, 4>>{{1, 2, 3, 4}, {8, 7, 6, 5}}));
}

// The faces with a vertex, in increasing order.
struct Has_vertex
{
  std::size_t vertex;
  friend bool get(const Has_vertex& map, const std::array<std::size_t, 4>& face)
  {
    EXPECT_TRUE(std::is_sorted(face.begin(), face.end()));
    return std::binary_search(face.begin(), face.end(), map.vertex);
  }
};

TEST(Named_parameters, that_constrain_facets_reach_the_engine_once_for_each_facet)
{
  const std::vector<Hexahedron> two = {{{0, 1, 2, 3, 4, 5, 6, 7}}, {{4, 5, 6, 7, 8, 9, 10, 11}}};
  Regions r;
  add_constrained_facets(params::facet_is_constrained_map(Has_vertex{4}), two, r);
  EXPECT_EQ(r.faces, (std::vector<std::array<int, 4>>{
                       {0, 1, 4, 5}, {0, 3, 4, 7}, {4, 5, 6, 7}, {4, 5, 8, 9}, {4, 7, 8, 11}}));
  Regions none;
  add_constrained_facets(params::default_values(), two, none);
  EXPECT_TRUE(none.faces.empty());
}

TEST(Named_parameters, that_are_pairs_of_vertices_reach_the_engine)
{
  using Vector = CGAL::Simple_cartesian<float>::Vector_3;
  const std::vector<std::tuple<short, std::size_t, Vector>> pairs = {{short(2), 0, Vector(1, .5f, 0)},
                                                                     {short(-1), 1, Vector(0, 0, 2)}};
  const Regions r = regions(params::periodic_vertices(pairs), keys);
  ASSERT_EQ(r.ties.size(), 2u);
  EXPECT_EQ(r.ties[0].vertex, 2);
  EXPECT_EQ(r.ties[0].partner, 0);
  EXPECT_EQ(r.ties[0].translation, Vector_3(1, .5, 0));
  EXPECT_EQ(r.ties[1].vertex, -1) << "to be refused";
  EXPECT_EQ(r.ties[1].partner, 1);
}

TEST(Named_parameters, that_are_no_faces_are_refused)
{
  for (const std::vector<int>& bad : {std::vector<int>(), {1, 2, 3}, {1, 2, 3, 4, 5}}) {
    const std::vector<std::vector<int>> faces = {{1, 2, 3, 4}, bad};
    try {
      regions(params::internal_faces(faces), keys);
      ADD_FAILURE() << "nothing was thrown for " << bad.size();
    }
    catch (const HMO::Input_error& error) {
      EXPECT_EQ(error.element(), HMO::Input_error::Element::PARAMETER);
      EXPECT_EQ(error.element_index(), 1u);
      EXPECT_NE(error.message().find("internal face 1 has " + std::to_string(bad.size())), std::string::npos);
    }
  }
}

// As a map or another range, a mesh or a soup
TEST(Named_parameters, that_are_references_of_interfaces_reach_the_engine)
{
  using Point = CGAL::Simple_cartesian<float>::Point_3;
  const std::vector<Point> points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 2, 0), Point(0, 0, .5f)};
  const std::vector<std::vector<short>> triangles = {{0, 1, 2}, {0, 3, 1}};
  using Soup = std::pair<std::vector<Point>, std::vector<std::vector<short>>>;
  const std::map<std::array<int, 2>, Soup> soups{{{{-1, 4}}, {points, triangles}}, {{{5, 2}}, {points, {{1, 2, 3}}}}};
  const auto of_soups = chosen_parameters(params::interface_references(soups), keys).interface_references;
  ASSERT_EQ(of_soups.size(), 2u);
  EXPECT_EQ(of_soups[0].labels, (std::array<int, 2>{-1, 4}));
  EXPECT_EQ(of_soups[1].labels, (std::array<int, 2>{2, 5}));
  EXPECT_EQ(of_soups[1].surface.triangles, (std::vector<Triangle_indices>{{1, 2, 3}}));
  CGAL::Surface_mesh<Point> mesh;
  for (const Point& p : points)
    mesh.add_vertex(p);
  using Vertex = CGAL::Surface_mesh<Point>::Vertex_index;
  for (const auto& t : triangles)
    mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  const std::vector<std::pair<std::pair<long, short>, CGAL::Surface_mesh<Point>>> meshes{{{7, 3}, mesh}};
  const auto of_meshes = chosen_parameters(params::interface_references(meshes), keys).interface_references;
  ASSERT_EQ(of_meshes.size(), 1u);
  EXPECT_EQ(of_meshes[0].labels, (std::array<int, 2>{3, 7}));
  EXPECT_EQ(of_meshes[0].surface.points, of_soups[0].surface.points);
  EXPECT_EQ(of_meshes[0].surface.triangles.size(), 2u);
  EXPECT_TRUE(chosen_parameters(params::default_values(), keys).interface_references.empty());
}

struct Counting_visitor
{
  std::size_t calls = 0;
  bool on_iteration(const HMO::Iteration&) { return ++calls < 2; }
};

TEST(Named_parameters, with_a_visitor_ask_it_whether_to_go_on)
{
  Counting_visitor visitor;
  const HMO::Iteration iteration{};
  const Chosen_parameters copied = chosen_parameters(params::visitor(visitor), keys);
  EXPECT_TRUE(copied.on_iteration(iteration));
  EXPECT_FALSE(copied.on_iteration(iteration));
  EXPECT_EQ(visitor.calls, 0u) << "a visitor by value is copied";
  EXPECT_TRUE(chosen_parameters(params::visitor(std::ref(visitor)), keys).on_iteration(iteration));
  EXPECT_EQ(visitor.calls, 1u);
}

} // namespace
