// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// optimize_hex_mesh() in all its forms: linear cell complexes of all kinds,
// kernels, index ranges, reference types and chained parameters. The same input
// gives the same result in each of them.

#include <CGAL/optimize_hex_mesh.h>

#include "mesh_families.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hex_mesh_optimization/hexahedra_to_linear_cell_complex.h>
#include <CGAL/Hex_mesh_optimization/validity.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Linear_cell_complex_for_generalized_map.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace params = CGAL::parameters;
using Simple = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Coordinates = std::vector<std::array<double, 3>>;

Indexed_mesh tangled_mesh()
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{3, 3, 2}}, {{3, 3, 2}});
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 3, .8);
  HMO::jitter_boundary(mesh.points, mesh.hexahedra, 3, .1);
  return mesh;
}

template <class Points>
Coordinates coordinates(const Points& points)
{
  Coordinates result;
  for (const auto& p : points)
    result.push_back({{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}});
  return result;
}

template <class Points>
Points points_as(const Indexed_mesh& mesh)
{
  Points result;
  for (const auto& p : mesh.points)
    result.push_back(typename Points::value_type(p.x(), p.y(), p.z()));
  return result;
}

// Short runs suffice to tell results apart
const auto quick = params::number_of_iterations(4).number_of_restarts(1).optimization_method(
  HMO::Method::RECTIFICATION);

// --- References ----------------------------------------------------------------------

Indexed_mesh reference_solid()
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{4, 4, 3}}, {{3, 3, 2}});
  return mesh;
}

template <class Kernel>
CGAL::Surface_mesh<typename Kernel::Point_3> surface_mesh()
{
  using Surface = CGAL::Surface_mesh<typename Kernel::Point_3>;
  using Vertex = typename Surface::Vertex_index;
  Surface surface;
  for_boundary(
    reference_solid(),
    [&](const Indexed_mesh::Point& p) { return surface.add_vertex(typename Kernel::Point_3(p.x(), p.y(), p.z())); },
    [&](Vertex a, Vertex b, Vertex c) { surface.add_face(a, b, c); });
  return surface;
}

template <class Kernel>
CGAL::Polyhedron_3<Kernel> polyhedron()
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  struct Builder : CGAL::Modifier_base<typename Polyhedron::HalfedgeDS>
  {
    void operator()(typename Polyhedron::HalfedgeDS& hds) override
    {
      CGAL::Polyhedron_incremental_builder_3<typename Polyhedron::HalfedgeDS> builder(hds, true);
      builder.begin_surface(200, 400);
      std::size_t count = 0;
      for_boundary(
        reference_solid(),
        [&](const Indexed_mesh::Point& p) {
          builder.add_vertex(typename Kernel::Point_3(p.x(), p.y(), p.z()));
          return count++;
        },
        [&](std::size_t a, std::size_t b, std::size_t c) {
          builder.begin_facet();
          for (std::size_t v : {a, b, c})
            builder.add_vertex_to_facet(v);
          builder.end_facet();
        });
      builder.end_surface();
    }
  } builder;
  Polyhedron result;
  result.delegate(builder);
  return result;
}

// Edges of the solid, found by their ends: both on two common sides of the box
template <class Graph>
struct Box_edges
{
  using key_type = typename boost::graph_traits<Graph>::edge_descriptor;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  const Graph* graph;
  friend bool get(const Box_edges& map, const key_type& edge)
  {
    const auto points = get(CGAL::vertex_point, *map.graph);
    const auto& p = get(points, source(edge, *map.graph));
    const auto& q = get(points, target(edge, *map.graph));
    const double size[3] = {3, 3, 2};
    int sides = 0;
    for (int d = 0; d < 3; ++d)
      sides += p[d] == q[d] && (p[d] == 0 || p[d] == size[d]);
    return sides == 2;
  }
};

struct Counter
{
  std::size_t calls = 0;
  bool on_iteration(const HMO::Iteration&)
  {
    ++calls;
    return true;
  }
};

// Index 7 is held, whatever vertices are named by
template <class Key>
struct Hold
{
  using key_type = Key;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  Key held;
  friend bool get(const Hold& map, const Key& key) { return map.held == key; }
};

// --- The result, in index form -----------------------------------------------------------

const Coordinates& expected()
{
  static const Coordinates result = [] {
    Indexed_mesh mesh = tangled_mesh();
    CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, quick);
    return coordinates(mesh.points);
  }();
  return result;
}

const Coordinates& expected_with_reference()
{
  static const Coordinates result = [] {
    Indexed_mesh mesh = tangled_mesh();
    CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface_mesh<Simple>(), quick);
    return coordinates(mesh.points);
  }();
  return result;
}

const Coordinates& expected_with_held_vertex()
{
  static const Coordinates result = [] {
    Indexed_mesh mesh = tangled_mesh();
    CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, quick.vertex_is_constrained_map(Hold<std::size_t>{7}));
    return coordinates(mesh.points);
  }();
  return result;
}

TEST(Overloads, do_something)
{
  const Coordinates input = coordinates(tangled_mesh().points);
  EXPECT_NE(expected(), input);
  EXPECT_NE(expected_with_reference(), input);
  EXPECT_NE(expected_with_reference(), expected());
  EXPECT_NE(expected_with_held_vertex(), expected());
  EXPECT_EQ(expected_with_held_vertex()[7], input[7]);
  EXPECT_NE(expected()[7], input[7]);
}

// --- Linear cell complexes ---------------------------------------------------------------

template <class Items, class Kernel = Epick>
using Cmap = CGAL::Linear_cell_complex_for_combinatorial_map<3, 3, CGAL::Linear_cell_complex_traits<3, Kernel>, Items>;
template <class Items, class Kernel = Epick>
using Gmap = CGAL::Linear_cell_complex_for_generalized_map<3, 3, CGAL::Linear_cell_complex_traits<3, Kernel>, Items>;

using Min_items = CGAL::Linear_cell_complex_min_items;

struct Rich_items
{
  template <class LCC>
  struct Dart_wrapper
  {
    using Dart_info = int;
    using Vertex_attribute = CGAL::Cell_attribute_with_point<LCC, std::string>;
    using Volume_attribute = CGAL::Cell_attribute<LCC, int>;
    using Attributes = std::tuple<Vertex_attribute, void, void, Volume_attribute>;
  };
};

#if CGAL_VERSION_NR >= 1050600000
struct Index_items
{
  using Use_index = CGAL::Tag_true;
  using Index_type = std::uint32_t;
  template <class LCC>
  struct Dart_wrapper
  {
    using Vertex_attribute = CGAL::Cell_attribute_with_point<LCC>;
    using Attributes = std::tuple<Vertex_attribute>;
  };
};
#endif

template <class LCC>
class Overloads_for_linear_cell_complex : public ::testing::Test
{
protected:
  using Vertex = typename HMO::internal::Linear_cell_complex_types<LCC>::Vertex;

  Overloads_for_linear_cell_complex()
  {
    const Indexed_mesh mesh = tangled_mesh();
    HMO::hexahedra_to_linear_cell_complex(points_as<std::vector<typename LCC::Point>>(mesh), mesh.hexahedra, lcc);
    std::vector<typename LCC::Point> points;
    std::vector<std::array<std::size_t, 8>> hexahedra;
    HMO::linear_cell_complex_to_hexahedra(lcc, points, hexahedra, vertices);
  }

  Coordinates result() const
  {
    Coordinates all;
    for (const Vertex v : vertices) {
      const auto& p = lcc.point_of_vertex_attribute(v);
      all.push_back({{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}});
    }
    return all;
  }

  LCC lcc;
  std::vector<Vertex> vertices;
};

using Complexes = ::testing::Types<Cmap<Min_items>, Gmap<Min_items>, Cmap<Rich_items, Simple>, Gmap<Rich_items, Simple>
#if CGAL_VERSION_NR >= 1050600000
                                   ,
                                   Cmap<Index_items>, Gmap<Index_items>
#endif
                                   >;
TYPED_TEST_SUITE(Overloads_for_linear_cell_complex, Complexes);

TYPED_TEST(Overloads_for_linear_cell_complex, without_reference)
{
  const HMO::Status status = CGAL::optimize_hex_mesh(this->lcc, quick);
  EXPECT_EQ(this->result(), expected());
  EXPECT_EQ(status.iterations > 0, true);
  EXPECT_TRUE(this->lcc.is_valid());
}

TYPED_TEST(Overloads_for_linear_cell_complex, with_reference)
{
  CGAL::optimize_hex_mesh(this->lcc, surface_mesh<Simple>(), quick);
  EXPECT_EQ(this->result(), expected_with_reference());
}

TYPED_TEST(Overloads_for_linear_cell_complex, with_a_held_vertex)
{
  using Vertex = typename TestFixture::Vertex;
  CGAL::optimize_hex_mesh(this->lcc, quick.vertex_is_constrained_map(Hold<Vertex>{this->vertices[7]}));
  EXPECT_EQ(this->result(), expected_with_held_vertex());
}

// Each hexahedron in turn is inverted and cannot move: the result names it by its place in the list of hexahedra.
TYPED_TEST(Overloads_for_linear_cell_complex, numbers_hexahedra_as_they_are_listed)
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{3, 1, 1}}, {{3, 1, 1}});
  std::swap(mesh.points[mesh.hexahedra[0][0]], mesh.points[mesh.hexahedra[0][3]]);
  std::reverse(mesh.hexahedra.begin(), mesh.hexahedra.end()); // so that it is not the first one
  HMO::hexahedra_to_linear_cell_complex(points_as<std::vector<typename TypeParam::Point>>(mesh), mesh.hexahedra,
                                        this->lcc);
  const HMO::Status status = CGAL::optimize_hex_mesh(this->lcc, quick.fixed_boundary(true));
  std::vector<typename TypeParam::Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  HMO::linear_cell_complex_to_hexahedra(this->lcc, points, hexahedra);
  std::vector<std::size_t> invalid;
  for (std::size_t h = 0; h < hexahedra.size(); ++h) {
    std::array<Simple::Point_3, 8> corners;
    for (std::size_t c = 0; c < 8; ++c)
      corners[c] = Simple::Point_3(CGAL::to_double(points[hexahedra[h][c]].x()),
                                   CGAL::to_double(points[hexahedra[h][c]].y()),
                                   CGAL::to_double(points[hexahedra[h][c]].z()));
    if (!HMO::is_valid_hexahedron(corners))
      invalid.push_back(h);
  }
  ASSERT_FALSE(invalid.empty());
  EXPECT_LT(invalid.size(), hexahedra.size());
  EXPECT_EQ(status.invalid_hexahedra, invalid);
}

TEST(Overloads, of_a_linear_cell_complex_with_defaults)
{
  const Indexed_mesh mesh = tangled_mesh();
  Cmap<Min_items> a, b;
  const auto points = points_as<std::vector<Epick::Point_3>>(mesh);
  HMO::hexahedra_to_linear_cell_complex(points, mesh.hexahedra, a);
  HMO::hexahedra_to_linear_cell_complex(points, mesh.hexahedra, b);
  const HMO::Status own = CGAL::optimize_hex_mesh(a);
  EXPECT_TRUE(own.valid_mesh());
  const HMO::Status with_reference = CGAL::optimize_hex_mesh(b, surface_mesh<Epick>());
  EXPECT_TRUE(with_reference.valid_mesh());
}

// --- Index ranges --------------------------------------------------------------------------

template <class Points, class Hexahedra>
void expect_expected(const Hexahedra& hexahedra)
{
  Points points = points_as<Points>(tangled_mesh());
  CGAL::optimize_hex_mesh(points, hexahedra, quick);
  EXPECT_EQ(coordinates(points), expected());
}

TEST(Overloads, of_index_ranges_of_all_kinds)
{
  const Indexed_mesh mesh = tangled_mesh();
  std::vector<std::vector<int>> vectors;
  std::deque<std::array<std::int16_t, 8>> shorts;
  for (const auto& h : mesh.hexahedra) {
    vectors.emplace_back(h.begin(), h.end());
    shorts.emplace_back();
    std::copy(h.begin(), h.end(), shorts.back().begin());
  }
  expect_expected<std::vector<Simple::Point_3>>(mesh.hexahedra);
  expect_expected<std::vector<Epick::Point_3>>(vectors);
  expect_expected<std::deque<Epick::Point_3>>(shorts);
}

TEST(Overloads, of_index_ranges_with_defaults)
{
  Indexed_mesh mesh = tangled_mesh();
  EXPECT_TRUE(CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra).valid_mesh());
  mesh = tangled_mesh();
  EXPECT_TRUE(CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface_mesh<Simple>()).valid_mesh());
}

// --- Kinds of references -----------------------------------------------------------------------

void expect_near(const Coordinates& a, const Coordinates& b, double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t v = 0; v < a.size(); ++v)
    for (int d = 0; d < 3; ++d)
      EXPECT_NEAR(a[v][d], b[v][d], tolerance) << v;
}

template <class Graph, class NamedParameters1, class NamedParameters2 = params::Default_named_parameters>
Coordinates optimized(const Graph& reference, const NamedParameters1& np1,
                      const NamedParameters2& np2 = params::default_values())
{
  Indexed_mesh mesh = tangled_mesh();
  CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, reference, np1, np2);
  return coordinates(mesh.points);
}

TEST(Overloads, with_references_of_all_kinds)
{
  EXPECT_EQ(optimized(surface_mesh<Epick>(), quick), expected_with_reference());
  // faces may start at other vertices: the same up to rounding
  expect_near(optimized(polyhedron<Epick>(), quick), expected_with_reference(), 1e-9);
  expect_near(optimized(polyhedron<Simple>(), quick), expected_with_reference(), 1e-9);
}

TEST(Overloads, with_given_feature_edges)
{
  const auto surface = surface_mesh<Simple>();
  const auto poly = polyhedron<Epick>();
  // the edges of the box are what is detected as well
  const auto given = Box_edges<CGAL::Surface_mesh<Simple::Point_3>>{&surface};
  expect_near(optimized(surface, quick, params::edge_is_constrained_map(given)), expected_with_reference(), 1e-9);
  const auto of_poly = Box_edges<CGAL::Polyhedron_3<Epick>>{&poly};
  expect_near(optimized(poly, quick, params::edge_is_constrained_map(of_poly)), expected_with_reference(), 1e-9);

  // CGAL's own kind of map; no features at all
  auto mutable_surface = surface;
  const auto none =
    mutable_surface.add_property_map<CGAL::Surface_mesh<Simple::Point_3>::Edge_index, bool>("e:none", false).first;
  EXPECT_NE(optimized(mutable_surface, quick, params::edge_is_constrained_map(none)), expected_with_reference());
}

TEST(Overloads, with_points_of_the_reference_in_a_map)
{
  auto surface = surface_mesh<Simple>();
  using Vertex = CGAL::Surface_mesh<Simple::Point_3>::Vertex_index;
  auto map = surface.add_property_map<Vertex, Epick::Point_3>("v:other").first;
  for (const Vertex v : surface.vertices()) {
    const auto p = surface.point(v);
    map[v] = Epick::Point_3(p.x(), p.y(), p.z());
    surface.point(v) = Simple::Point_3(0, 0, 0); // not to be looked at
  }
  EXPECT_EQ(optimized(surface, quick, params::vertex_point_map(map)), expected_with_reference());
}

// --- Triangle soups ---------------------------------------------------------------------------------

struct Soup
{
  std::vector<Simple::Point_3> points;
  std::vector<std::array<int, 3>> triangles;
};

Soup soup()
{
  Soup result;
  for_boundary(
    reference_solid(),
    [&](const Indexed_mesh::Point& p) {
      result.points.emplace_back(p.x(), p.y(), p.z());
      return static_cast<int>(result.points.size()) - 1;
    },
    [&](int a, int b, int c) {
      result.triangles.push_back({{a, b, c}});
    });
  return result;
}

// As Box_edges
struct Box_edges_of_soup
{
  const Soup* soup;
  friend bool get(const Box_edges_of_soup& map, const std::pair<std::size_t, std::size_t>& edge)
  {
    const auto &p = map.soup->points[edge.first], &q = map.soup->points[edge.second];
    const double size[3] = {3, 3, 2};
    int sides = 0;
    for (int d = 0; d < 3; ++d)
      sides += p[d] == q[d] && (p[d] == 0 || p[d] == size[d]);
    return sides == 2;
  }
};

struct No_edges_of_soup
{
  friend bool get(const No_edges_of_soup&, const std::pair<std::size_t, std::size_t>&) { return false; }
};

template <class NamedParameters>
Coordinates optimized_toward_soup(const NamedParameters& np2)
{
  Indexed_mesh mesh = tangled_mesh();
  const Soup reference = soup();
  CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, reference.points, reference.triangles, quick, np2);
  return coordinates(mesh.points);
}

TEST(Overloads, with_a_triangle_soup)
{
  const Soup reference = soup();
  // faces of a graph may start at other vertices: the same up to rounding
  expect_near(optimized_toward_soup(params::default_values()), expected_with_reference(), 1e-9);
  expect_near(optimized_toward_soup(params::edge_is_constrained_map(Box_edges_of_soup{&reference})),
              expected_with_reference(), 1e-9);
  EXPECT_NE(optimized_toward_soup(params::edge_is_constrained_map(No_edges_of_soup())), expected_with_reference());
}

TYPED_TEST(Overloads_for_linear_cell_complex, with_a_triangle_soup)
{
  const Soup reference = soup();
  CGAL::optimize_hex_mesh(this->lcc, reference.points, reference.triangles, quick);
  expect_near(this->result(), expected_with_reference(), 1e-9);
}

// --- Chains of parameters -------------------------------------------------------------------------

TEST(Overloads, with_parameters_in_any_order)
{
  Counter first, second;
  const auto surface = surface_mesh<Simple>();
  const Coordinates a = optimized(surface, params::verbose(false)
                                             .number_of_iterations(4)
                                             .geom_traits(Simple())
                                             .features_angle_bound(45)
                                             .visitor(std::ref(first))
                                             .number_of_restarts(1)
                                             .optimization_method(HMO::Method::RECTIFICATION));
  const Coordinates b = optimized(surface,
                                  params::optimization_method(HMO::Method::RECTIFICATION)
                                    .visitor(std::ref(second))
                                    .maximum_running_time(1000)
                                    .features_angle_bound(45)
                                    .number_of_restarts(1)
                                    .number_of_iterations(4)
                                    .verbose(false),
                                  params::vertex_point_map(surface.points()));
  EXPECT_EQ(a, expected_with_reference());
  EXPECT_EQ(b, expected_with_reference());
  EXPECT_GT(first.calls, 0u);
  EXPECT_EQ(first.calls, second.calls);
}

TEST(Overloads, with_every_parameter_at_its_default)
{
  const Coordinates chained = optimized(surface_mesh<Simple>(),
                                        params::fixed_boundary(false)
                                          .optimization_method(HMO::Method::FULL)
                                          .target_edge_lengths(HMO::Target_edge_lengths::ESTIMATED)
                                          .edge_length_update(HMO::Edge_length_update::FULL)
                                          .number_of_iterations(20)
                                          .number_of_restarts(2)
                                          .regularization_weight(1.)
                                          .cone_angle_bound(85.)
                                          .maximize_minimum_quality(true)
                                          .features_angle_bound(45.)
                                          .visitor(HMO::Default_visitor()));
  EXPECT_EQ(chained, optimized(surface_mesh<Simple>(), params::default_values()));
}

// The same bits, whatever the number of threads
TEST(Overloads, with_every_concurrency_tag)
{
  const auto surface = surface_mesh<Simple>();
  Indexed_mesh sequential = tangled_mesh(), parallel = sequential, with_reference = sequential;
  CGAL::optimize_hex_mesh<CGAL::Sequential_tag>(sequential.points, sequential.hexahedra, quick);
  CGAL::optimize_hex_mesh<CGAL::Parallel_if_available_tag>(parallel.points, parallel.hexahedra, quick);
  CGAL::optimize_hex_mesh<CGAL::Parallel_if_available_tag>(with_reference.points, with_reference.hexahedra, surface,
                                                           quick);
  EXPECT_EQ(coordinates(sequential.points), expected());
  EXPECT_EQ(coordinates(parallel.points), expected());
  EXPECT_EQ(coordinates(with_reference.points), expected_with_reference());
}

TEST(Overloads, accept_a_visitor_by_value)
{
  Indexed_mesh mesh = tangled_mesh();
  CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, quick.visitor(Counter()));
  EXPECT_EQ(coordinates(mesh.points), expected());
}

} // namespace
