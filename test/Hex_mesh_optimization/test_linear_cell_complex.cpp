// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Hexahedra to linear cell complexes of all kinds and back: nothing may be lost,
// reordered or renumbered, and what such a complex cannot carry is refused.

#include <CGAL/Hex_mesh_optimization/hexahedra_to_linear_cell_complex.h>
#include <CGAL/Hex_mesh_optimization/linear_cell_complex_to_hexahedra.h>
#include <CGAL/Hex_mesh_optimization/validity.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Linear_cell_complex_for_generalized_map.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace HMO = CGAL::Hex_mesh_optimization;

namespace {

using Simple = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Hexahedron = std::array<std::size_t, 8>;

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
    using Edge_attribute = CGAL::Cell_attribute<LCC, double>;
    using Face_attribute = CGAL::Cell_attribute<LCC>;
    using Volume_attribute = CGAL::Cell_attribute<LCC, int>;
    using Attributes = std::tuple<Vertex_attribute, Edge_attribute, Face_attribute, Volume_attribute>;
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

// A grid of nx * ny * nz boxes with vertices, hexahedra and corners numbered at random.
struct Grid
{
  std::vector<std::array<double, 3>> points;
  std::vector<Hexahedron> hexahedra;

  Grid(std::size_t nx, std::size_t ny, std::size_t nz, unsigned int seed)
  {
    const auto vertex = [&](std::size_t i, std::size_t j, std::size_t k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
    std::mt19937 random(seed);
    std::vector<std::size_t> number(vertex(nx, ny, nz) + 1);
    for (std::size_t v = 0; v < number.size(); ++v)
      number[v] = v;
    std::shuffle(number.begin(), number.end(), random);

    points.resize(number.size());
    for (std::size_t k = 0; k <= nz; ++k)
      for (std::size_t j = 0; j <= ny; ++j)
        for (std::size_t i = 0; i <= nx; ++i)
          points[number[vertex(i, j, k)]] = {0.1 * i, 0.3 * j, 0.7 * k};

    const int rotations[2][8] = {{1, 2, 3, 0, 5, 6, 7, 4}, {0, 3, 7, 4, 1, 2, 6, 5}};
    for (std::size_t k = 0; k < nz; ++k)
      for (std::size_t j = 0; j < ny; ++j)
        for (std::size_t i = 0; i < nx; ++i) {
          Hexahedron h = {
            vertex(i, j, k),     vertex(i + 1, j, k),     vertex(i + 1, j + 1, k),     vertex(i, j + 1, k),
            vertex(i, j, k + 1), vertex(i + 1, j, k + 1), vertex(i + 1, j + 1, k + 1), vertex(i, j + 1, k + 1)};
          for (int turns = 5; turns > 0; --turns) {
            const Hexahedron from = h;
            const int* rotation = rotations[random() % 2];
            for (int c = 0; c < 8; ++c)
              h[c] = from[rotation[c]];
          }
          for (std::size_t& v : h)
            v = number[v];
          hexahedra.push_back(h);
        }
    std::shuffle(hexahedra.begin(), hexahedra.end(), random);
  }
};

// The same box numbered as its mirror image.
Hexahedron mirrored(const Hexahedron& h) { return {h[4], h[5], h[6], h[7], h[0], h[1], h[2], h[3]}; }

template <class LCC>
std::vector<typename LCC::Point> points_of(const Grid& grid)
{
  std::vector<typename LCC::Point> points;
  for (const auto& p : grid.points)
    points.emplace_back(p[0], p[1], p[2]);
  return points;
}

// The index of the hexahedron that the input error names.
template <class LCC, class Hexahedra>
std::size_t refused_hexahedron(std::size_t number_of_points, const Hexahedra& hexahedra, const std::string& reason)
{
  LCC lcc;
  std::vector<typename LCC::Point> points(number_of_points, typename LCC::Point(0, 0, 0));
  try {
    HMO::hexahedra_to_linear_cell_complex(points, hexahedra, lcc);
  }
  catch (const HMO::Input_error& error) {
    EXPECT_EQ(error.element(), HMO::Input_error::Element::HEXAHEDRON);
    EXPECT_NE(error.message().find(reason), std::string::npos) << error.message();
    EXPECT_TRUE(lcc.is_empty()) << "the complex was changed";
    EXPECT_EQ(lcc.number_of_vertex_attributes(), 0u) << "the complex was changed";
    return error.element_index();
  }
  ADD_FAILURE() << "nothing was thrown";
  return 0;
}

template <class LCC>
class Linear_cell_complex : public ::testing::Test
{};

using Complexes = ::testing::Types<Cmap<Min_items>, Gmap<Min_items>, Cmap<Min_items, Simple>, Gmap<Min_items, Simple>,
                                   Cmap<Rich_items>, Gmap<Rich_items>
#if CGAL_VERSION_NR >= 1050600000
                                   ,
                                   Cmap<Index_items>, Gmap<Index_items>
#endif
                                   >;
TYPED_TEST_SUITE(Linear_cell_complex, Complexes);

TYPED_TEST(Linear_cell_complex, gives_back_what_it_was_made_from)
{
  for (unsigned int seed = 0; seed < 4; ++seed) {
    Grid grid(2 + seed, 3, 4, seed);
    grid.points.insert(grid.points.begin() + 7, {-1., -2., -3.}); // unreferenced
    grid.points.push_back({1e-300, 1. / 3., -0.});                // unreferenced
    for (Hexahedron& h : grid.hexahedra)
      for (std::size_t& v : h)
        v += v >= 7;
    const auto points = points_of<TypeParam>(grid);

    TypeParam lcc;
    HMO::hexahedra_to_linear_cell_complex(points, grid.hexahedra, lcc);
    EXPECT_TRUE(lcc.is_valid());
    const auto cells = lcc.count_all_cells();
    const std::size_t nx = 2 + seed, ny = 3, nz = 4;
    EXPECT_EQ(cells[0], (nx + 1) * (ny + 1) * (nz + 1));
    EXPECT_EQ(cells[1], nx * (ny + 1) * (nz + 1) + (nx + 1) * ny * (nz + 1) + (nx + 1) * (ny + 1) * nz);
    EXPECT_EQ(cells[2], nx * ny * (nz + 1) + nx * (ny + 1) * nz + (nx + 1) * ny * nz);
    EXPECT_EQ(cells[3], nx * ny * nz);
    EXPECT_EQ(cells[4], 1u);
    EXPECT_EQ(lcc.number_of_vertex_attributes(), points.size());

    std::vector<typename TypeParam::Point> points_back;
    std::vector<std::vector<int>> hexahedra_back;
    const TypeParam& constant = lcc;
    HMO::linear_cell_complex_to_hexahedra(constant, points_back, hexahedra_back);
    EXPECT_EQ(points_back, points);
    ASSERT_EQ(hexahedra_back.size(), grid.hexahedra.size());
    for (std::size_t h = 0; h < grid.hexahedra.size(); ++h)
      EXPECT_TRUE(std::equal(hexahedra_back[h].begin(), hexahedra_back[h].end(), grid.hexahedra[h].begin())) << h;
  }
}

TYPED_TEST(Linear_cell_complex, keeps_mirrored_numbering)
{
  Grid grid(2, 2, 2, 5);
  for (Hexahedron& h : grid.hexahedra)
    h = mirrored(h);
  TypeParam lcc;
  HMO::hexahedra_to_linear_cell_complex(points_of<TypeParam>(grid), grid.hexahedra, lcc);
  std::vector<typename TypeParam::Point> points;
  std::vector<Hexahedron> hexahedra;
  HMO::linear_cell_complex_to_hexahedra(lcc, points, hexahedra);
  EXPECT_EQ(hexahedra, grid.hexahedra);
}

TYPED_TEST(Linear_cell_complex, is_written_back_through_vertex_attributes)
{
  const Grid grid(3, 2, 2, 1);
  TypeParam lcc;
  HMO::hexahedra_to_linear_cell_complex(points_of<TypeParam>(grid), grid.hexahedra, lcc);
  std::vector<typename TypeParam::Point> points, moved;
  std::vector<Hexahedron> hexahedra;
#if CGAL_VERSION_NR >= 1050600000
  std::vector<typename TypeParam::Vertex_attribute_descriptor> vertices;
#else
  std::vector<typename TypeParam::Vertex_attribute_handle> vertices;
#endif
  HMO::linear_cell_complex_to_hexahedra(lcc, points, hexahedra, vertices);
  ASSERT_EQ(vertices.size(), points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    lcc.point_of_vertex_attribute(vertices[v]) = points[v] = typename TypeParam::Point(double(v), 0, 1);
  HMO::linear_cell_complex_to_hexahedra(lcc, moved, hexahedra);
  EXPECT_EQ(moved, points);
}

TYPED_TEST(Linear_cell_complex, invalid_hexahedra_are_found_by_a_dart_each)
{
  Grid grid(3, 3, 3, 2);
  grid.hexahedra[4] = mirrored(grid.hexahedra[4]);
  const std::size_t moved = grid.hexahedra[11][5];
  grid.points[moved] = {-9, 9, -9};
  TypeParam lcc;
  const auto points = points_of<TypeParam>(grid);
  // the mirrored one cannot be sewn to its neighbors: it is on its own
  std::vector<Hexahedron> sewn = grid.hexahedra, alone;
  alone.push_back(sewn[4]);
  sewn.erase(sewn.begin() + 4);
  for (const std::vector<Hexahedron>& hexahedra : {sewn, alone}) {
    lcc.clear();
    HMO::hexahedra_to_linear_cell_complex(points, hexahedra, lcc);
    std::vector<std::size_t> indices;
    HMO::invalid_hexahedra(points, hexahedra, std::back_inserter(indices));
    std::vector<typename HMO::internal::Linear_cell_complex_types<TypeParam>::Dart> darts;
    HMO::invalid_hexahedra(lcc, std::back_inserter(darts));
    EXPECT_FALSE(indices.empty());
    ASSERT_EQ(darts.size(), indices.size());
    for (std::size_t i = 0; i < darts.size(); ++i) {
      EXPECT_EQ(lcc.point(darts[i]), points[hexahedra[indices[i]][0]]);
      EXPECT_EQ(lcc.point(lcc.next(darts[i])), points[hexahedra[indices[i]][4]]);
    }
  }
}

TYPED_TEST(Linear_cell_complex, made_by_hand_is_listed)
{
  using Point = typename TypeParam::Point;
  TypeParam lcc;
  const auto box = [&](double x) {
    return lcc.make_hexahedron(Point(x, 0, 0), Point(x + 1, 0, 0), Point(x + 1, 1, 0), Point(x, 1, 0), Point(x, 1, 1),
                               Point(x, 0, 1), Point(x + 1, 0, 1), Point(x + 1, 1, 1));
  };
  box(0);
  box(1);
  EXPECT_EQ(lcc.number_of_vertex_attributes(), 16u);
  lcc.sew3_same_facets();
  ASSERT_EQ(lcc.number_of_vertex_attributes(), 12u);

  std::vector<Point> points;
  std::vector<Hexahedron> hexahedra;
  HMO::linear_cell_complex_to_hexahedra(lcc, points, hexahedra);
  EXPECT_EQ(points.size(), 12u);
  ASSERT_EQ(hexahedra.size(), 2u);
  for (std::size_t h = 0; h < 2; ++h) {
    const double x = double(h);
    const Point corners[8] = {Point(x, 0, 0), Point(x + 1, 0, 0), Point(x + 1, 1, 0), Point(x, 1, 0),
                              Point(x, 0, 1), Point(x + 1, 0, 1), Point(x + 1, 1, 1), Point(x, 1, 1)};
    for (int c = 0; c < 8; ++c)
      EXPECT_EQ(points[hexahedra[h][c]], corners[c]);
  }
}

TYPED_TEST(Linear_cell_complex, refuses_what_is_not_a_hexahedron)
{
  using Point = typename TypeParam::Point;
  std::vector<Point> points;
  std::vector<Hexahedron> hexahedra;
  const auto refused = [&](const TypeParam& lcc) {
    try {
      HMO::linear_cell_complex_to_hexahedra(lcc, points, hexahedra);
    }
    catch (const HMO::Input_error& error) {
      return error.element_index();
    }
    ADD_FAILURE() << "nothing was thrown";
    return std::size_t(0);
  };

  const Grid grid(2, 2, 1, 0);
  TypeParam lcc;
  HMO::hexahedra_to_linear_cell_complex(points_of<TypeParam>(grid), grid.hexahedra, lcc);
  lcc.make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1));
  EXPECT_EQ(refused(lcc), 4u);

  TypeParam square;
  square.make_quadrangle(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0));
  EXPECT_EQ(refused(square), 0u);

  TypeParam segment;
  segment.make_segment(Point(0, 0, 0), Point(1, 0, 0), true);
  EXPECT_EQ(refused(segment), 0u);

  TypeParam split;
  auto dart = split.make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 1, 1),
                                    Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1));
  split.template insert_barycenter_in_cell<1>(dart);
  EXPECT_EQ(refused(split), 0u);

  TypeParam no_vertices;
  no_vertices.make_combinatorial_hexahedron();
  EXPECT_EQ(refused(no_vertices), 0u);
}

TYPED_TEST(Linear_cell_complex, refuses_bad_hexahedra)
{
  using LCC = TypeParam;
  Grid grid(2, 2, 2, 3);
  const std::size_t n = grid.points.size();

  auto bad = grid.hexahedra;
  bad[5][3] = n;
  EXPECT_EQ(refused_hexahedron<LCC>(n, bad, "vertex index 27 is out of range"), 5u);

  std::vector<std::vector<int>> ranges;
  for (const Hexahedron& h : grid.hexahedra)
    ranges.emplace_back(h.begin(), h.end());
  ranges[4][0] = -1;
  EXPECT_EQ(refused_hexahedron<LCC>(n, ranges, "vertex index -1 is out of range"), 4u);
  ranges[3].pop_back();
  EXPECT_EQ(refused_hexahedron<LCC>(n, ranges, "it has 7 vertices"), 3u);

  bad = grid.hexahedra;
  bad[2][6] = bad[2][1];
  EXPECT_EQ(refused_hexahedron<LCC>(n, bad, "occurs twice"), 2u);
}

TYPED_TEST(Linear_cell_complex, refuses_bad_faces)
{
  using LCC = TypeParam;
  const std::vector<Hexahedron> two = {{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}};
  auto bad = two;
  bad.push_back({4, 5, 6, 7, 12, 13, 14, 15});
  EXPECT_EQ(refused_hexahedron<LCC>(16, bad, "already belongs to the hexahedra 0 and 1"), 2u);
  bad = {two[0], mirrored(two[1])};
  EXPECT_EQ(refused_hexahedron<LCC>(12, bad, "orientation is opposite to that of hexahedron 0"), 1u);
  bad = {two[0], {4, 6, 5, 7, 8, 9, 10, 11}};
  EXPECT_EQ(refused_hexahedron<LCC>(12, bad, "by other edges than hexahedron 0"), 1u);
}

TYPED_TEST(Linear_cell_complex, refuses_non_manifold_vertices_and_edges)
{
  using LCC = TypeParam;
  // One common vertex.
  std::vector<Hexahedron> bad = {{0, 1, 2, 3, 4, 5, 6, 7}, {6, 8, 9, 10, 11, 12, 13, 14}};
  EXPECT_EQ(refused_hexahedron<LCC>(15, bad, "vertex 6"), 1u);
  // One common edge.
  bad = {{0, 1, 2, 3, 4, 5, 6, 7}, {2, 8, 9, 10, 6, 11, 12, 13}};
  EXPECT_EQ(refused_hexahedron<LCC>(14, bad, "non-manifold"), 1u);

  // An edge whose end vertices are fine: around the middle edge of a grid of
  // four by two by two, two opposite hexahedra stay in the middle layers, the outer
  // layers are complete and connect them.
  Grid grid(2, 2, 3, 0);
  Hexahedron order[3][2][2];
  for (const Hexahedron& h : grid.hexahedra) {
    double center[3] = {0, 0, 0};
    for (std::size_t v : h)
      for (int i = 0; i < 3; ++i)
        center[i] += grid.points[v][i] / 8;
    order[int(center[2] / 0.7)][int(center[1] / 0.3)][int(center[0] / 0.1)] = h;
  }
  bad.clear();
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i)
        if (k != 1 || i == j)
          bad.push_back(order[k][j][i]);
  ASSERT_EQ(bad.size(), 10u);
  EXPECT_EQ(refused_hexahedron<LCC>(grid.points.size(), bad, "at edge"), 5u);
}

// Darts of a generalized map do not tell the orientation: the first volume does.
TEST(Generalized_map, orients_a_component_as_its_first_volume)
{
  using LCC = Gmap<Min_items>;
  using Point = LCC::Point;
  LCC lcc;
  lcc.make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 1, 1), Point(0, 0, 1),
                      Point(1, 0, 1), Point(1, 1, 1));
  // Bottom and top exchanged: numbered as its own mirror image.
  lcc.make_hexahedron(Point(1, 0, 1), Point(2, 0, 1), Point(2, 1, 1), Point(1, 1, 1), Point(1, 1, 0), Point(1, 0, 0),
                      Point(2, 0, 0), Point(2, 1, 0));
  ASSERT_EQ(lcc.sew3_same_facets(), 1u);
  std::vector<Point> points;
  std::vector<Hexahedron> hexahedra;
  HMO::linear_cell_complex_to_hexahedra(lcc, points, hexahedra);
  ASSERT_EQ(hexahedra.size(), 2u);
  for (const Hexahedron& h : hexahedra)
    EXPECT_EQ(CGAL::orientation(points[h[0]], points[h[1]], points[h[3]], points[h[4]]), CGAL::POSITIVE);
}

} // namespace
