// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_subdivision.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Points = std::vector<Point>;
using Hexahedra = std::vector<std::array<std::size_t, 8>>;

constexpr double pi = 3.14159265358979323846;

struct Family
{
  std::string name;
  std::function<void(Points&, Hexahedra&, std::size_t)> make; // at refinement n = 1, 2, 3, ...
  std::function<std::size_t(std::size_t)> number_of_hexahedra;
  std::function<std::size_t(std::size_t)> number_of_vertices;
  double volume; // of the smooth solid
  bool is_exact; // is the mesh that solid at any refinement?
  int boundary_euler_characteristic;
};

const std::vector<Family>& families()
{
  static const std::vector<Family> all = {
    {"block",
     [](Points& p, Hexahedra& h, std::size_t n) {
       HMO::make_block(p, h, {{n, 2 * n, 3 * n}}, {{1, 3, 2}});
     },
     [](std::size_t n) { return 6 * n * n * n; }, [](std::size_t n) { return (n + 1) * (2 * n + 1) * (3 * n + 1); }, 6,
     true, 2},
    {"graded_block",
     [](Points& p, Hexahedra& h, std::size_t n) {
       HMO::make_block(p, h, {{n, n, 4 * n}}, {{1, 1, 2}}, {{1, .5, 100}});
     },
     [](std::size_t n) { return 4 * n * n * n; }, [](std::size_t n) { return (n + 1) * (n + 1) * (4 * n + 1); }, 2,
     true, 2},
    {"straight_bar", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_bent_bar(p, h, 4 * n, n, 4, 1, 0); },
     [](std::size_t n) { return 4 * n * n * n; }, [](std::size_t n) { return (4 * n + 1) * (n + 1) * (n + 1); }, 4,
     true, 2},
    {"bent_bar", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_bent_bar(p, h, 4 * n, n, 4, 1, -2 * pi / 3); },
     [](std::size_t n) { return 4 * n * n * n; }, [](std::size_t n) { return (4 * n + 1) * (n + 1) * (n + 1); }, 4,
     false, 2},
    {"twisted_bar",
     [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_bent_bar(p, h, 8 * n, n, 6, 1, pi / 2, pi); },
     [](std::size_t n) { return 8 * n * n * n; }, [](std::size_t n) { return (8 * n + 1) * (n + 1) * (n + 1); }, 6,
     false, 2},
    {"cylinder", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_cylinder(p, h, 2 * n, n); },
     [](std::size_t n) { return n * (4 * n * n + 8 * n * n); },
     [](std::size_t n) { return (n + 1) * ((2 * n + 1) * (2 * n + 1) + 8 * n * n); }, 2 * pi, false, 2},
    {"ball", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_ball(p, h, 2 * n, 2); },
     [](std::size_t n) { return 8 * n * n * n + 24 * n * n * n; },
     [](std::size_t n) { return (2 * n + 1) * (2 * n + 1) * (2 * n + 1) + n * (24 * n * n + 2); }, 4. / 3 * pi * 8,
     false, 2},
    {"plate_with_hole", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_plate_with_hole(p, h, 2 * n, n); },
     [](std::size_t n) { return n * 2 * n * 8 * n; }, [](std::size_t n) { return (n + 1) * (2 * n + 1) * 8 * n; },
     16 - pi, false, 0},
    {"l_shape", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_l_shape(p, h, n, 2); },
     [](std::size_t n) { return 3 * n * n * n; },
     [](std::size_t n) { return (n + 1) * ((2 * n + 1) * (n + 1) + n * (n + 1)); }, 24, true, 2},
    {"t_shape", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_t_shape(p, h, n); },
     [](std::size_t n) { return 4 * n * n * n; },
     [](std::size_t n) { return (n + 1) * ((3 * n + 1) * (n + 1) + n * (n + 1)); }, 4, true, 2},
    {"ring", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_ring(p, h, 12 * n, n); },
     [](std::size_t n) { return 12 * n * n * n; }, [](std::size_t n) { return 12 * n * (n + 1) * (n + 1); }, 3 * pi,
     false, 0}};
  return all;
}

double corner_determinant(const Points& points, const std::array<std::size_t, 8>& hexahedron, int corner)
{
  const int* neighbors = HMO::internal::corner_neighbors[corner];
  const Point& p = points[hexahedron[corner]];
  return CGAL::determinant(points[hexahedron[neighbors[0]]] - p, points[hexahedron[neighbors[1]]] - p,
                           points[hexahedron[neighbors[2]]] - p);
}

std::vector<std::array<std::size_t, 4>> boundary_of(const Hexahedra& hexahedra)
{
  std::map<std::array<std::size_t, 4>, std::vector<std::array<std::size_t, 4>>> faces;
  for (const auto& hexahedron : hexahedra)
    for (const auto& corners : HMO::internal::hexahedron_faces) {
      std::array<std::size_t, 4> quad, sorted;
      for (int i = 0; i < 4; ++i)
        quad[i] = hexahedron[corners[i]];
      sorted = quad;
      std::sort(sorted.begin(), sorted.end());
      faces[sorted].push_back(quad);
    }
  std::vector<std::array<std::size_t, 4>> boundary;
  for (const auto& face : faces) {
    EXPECT_LE(face.second.size(), 2u) << "three hexahedra share a face";
    if (face.second.size() == 1)
      boundary.push_back(face.second.front());
  }
  return boundary;
}

// The divergence theorem over the boundary; each bilinear quad is integrated
// exactly by the mean of its two triangulations.
double enclosed_volume(const Points& points, const std::vector<std::array<std::size_t, 4>>& boundary)
{
  double sum = 0;
  const auto cone = [&](std::size_t a, std::size_t b, std::size_t c) {
    return CGAL::determinant(points[a] - CGAL::ORIGIN, points[b] - CGAL::ORIGIN, points[c] - CGAL::ORIGIN);
  };
  for (const auto& q : boundary)
    sum += cone(q[0], q[1], q[2]) + cone(q[0], q[2], q[3]) + cone(q[1], q[2], q[3]) + cone(q[1], q[3], q[0]);
  return sum / 12;
}

class Generators : public ::testing::TestWithParam<std::size_t>
{
protected:
  const Family& family() const { return families()[GetParam()]; }
};

TEST_P(Generators, have_the_stated_counts)
{
  for (std::size_t n : {1, 2, 4}) {
    Points points;
    Hexahedra hexahedra;
    family().make(points, hexahedra, n);
    EXPECT_EQ(hexahedra.size(), family().number_of_hexahedra(n));
    EXPECT_EQ(points.size(), family().number_of_vertices(n));
  }
}

TEST_P(Generators, are_positive_at_every_corner)
{
  for (std::size_t n : {1, 2, 4}) {
    Points points;
    Hexahedra hexahedra;
    family().make(points, hexahedra, n);
    double minimum = std::numeric_limits<double>::infinity();
    for (const auto& hexahedron : hexahedra)
      for (int corner = 0; corner < 8; ++corner)
        minimum = (std::min)(minimum, corner_determinant(points, hexahedron, corner));
    EXPECT_GT(minimum, 0) << "at refinement " << n;
  }
}

TEST_P(Generators, name_each_vertex_once_and_use_it)
{
  for (std::size_t n : {1, 2, 4}) {
    Points points;
    Hexahedra hexahedra;
    family().make(points, hexahedra, n);

    std::vector<char> is_used(points.size(), 0);
    for (const auto& hexahedron : hexahedra) {
      EXPECT_EQ(std::set<std::size_t>(hexahedron.begin(), hexahedron.end()).size(), 8u);
      for (std::size_t v : hexahedron) {
        ASSERT_LT(v, points.size());
        is_used[v] = 1;
      }
    }
    EXPECT_EQ(std::count(is_used.begin(), is_used.end(), 1), static_cast<std::ptrdiff_t>(points.size()));

    // Sorted by x, near duplicates are close to one another
    const double tolerance = 1e-9;
    Points sorted = points;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i)
      for (std::size_t j = i + 1; j < sorted.size() && sorted[j].x() - sorted[i].x() < tolerance; ++j)
        EXPECT_GT(CGAL::squared_distance(sorted[i], sorted[j]), tolerance * tolerance);
  }
}

TEST_P(Generators, have_a_closed_manifold_boundary)
{
  for (std::size_t n : {1, 2, 4}) {
    Points points;
    Hexahedra hexahedra;
    family().make(points, hexahedra, n);

    const auto boundary = boundary_of(hexahedra);
    std::set<std::pair<std::size_t, std::size_t>> halfedges;
    std::map<std::size_t, std::map<std::size_t, std::size_t>> next_around; // vertex -> link
    for (const auto& quad : boundary)
      for (int i = 0; i < 4; ++i) {
        EXPECT_TRUE(halfedges.emplace(quad[i], quad[(i + 1) % 4]).second) << "an edge is used twice in one direction";
        next_around[quad[i]][quad[(i + 1) % 4]] = quad[(i + 3) % 4];
      }
    for (const auto& halfedge : halfedges)
      EXPECT_TRUE(halfedges.count({halfedge.second, halfedge.first})) << "an edge has one quad only";
    // The quads at each vertex form one fan
    for (const auto& vertex : next_around) {
      std::size_t steps = 0, first = vertex.second.begin()->first, neighbor = first;
      do {
        neighbor = vertex.second.at(neighbor);
        ++steps;
      } while (neighbor != first && steps <= vertex.second.size());
      EXPECT_EQ(steps, vertex.second.size()) << "at vertex " << vertex.first;
    }
    const int euler = static_cast<int>(next_around.size()) - static_cast<int>(halfedges.size() / 2) +
                      static_cast<int>(boundary.size());
    EXPECT_EQ(euler, family().boundary_euler_characteristic);
  }
}

TEST_P(Generators, converge_to_the_volume_of_the_solid)
{
  std::vector<double> errors;
  for (std::size_t n : {2, 4, 8}) {
    Points points;
    Hexahedra hexahedra;
    family().make(points, hexahedra, n);
    errors.push_back(std::abs(enclosed_volume(points, boundary_of(hexahedra)) / family().volume - 1));
  }
  if (family().is_exact) {
    for (double error : errors)
      EXPECT_LT(error, 1e-12);
  }
  else {
    // Second order: a quarter of the error at half the cell size
    EXPECT_LT(errors[1], errors[0] / 3);
    EXPECT_LT(errors[2], errors[1] / 3);
    EXPECT_LT(errors[2], .01);
  }
}

TEST_P(Generators, are_deterministic_and_replace_former_contents)
{
  Points points, points_again = {Point(7, 7, 7)};
  Hexahedra hexahedra, hexahedra_again = {{{0, 0, 0, 0, 0, 0, 0, 0}}};
  family().make(points, hexahedra, 2);
  family().make(points_again, hexahedra_again, 2);
  EXPECT_EQ(points, points_again);
  EXPECT_EQ(hexahedra, hexahedra_again);
}

INSTANTIATE_TEST_SUITE_P(all_families, Generators, ::testing::Range<std::size_t>(0, families().size()),
                         [](const ::testing::TestParamInfo<std::size_t>& info) { return families()[info.param].name; });

TEST(Block, grows_geometrically_from_the_first_to_the_last_cell)
{
  Points points;
  Hexahedra hexahedra;
  HMO::make_block(points, hexahedra, {{1, 1, 5}}, {{1, 1, 3}}, {{1, 1, 16}});
  std::vector<double> heights;
  for (const auto& hexahedron : hexahedra)
    heights.push_back(points[hexahedron[4]].z() - points[hexahedron[0]].z());
  for (std::size_t i = 1; i < heights.size(); ++i)
    EXPECT_NEAR(heights[i] / heights[i - 1], 2, 1e-12);
}

TEST(Cylinder, has_its_outer_vertices_on_the_circle)
{
  Points points;
  Hexahedra hexahedra;
  HMO::make_cylinder(points, hexahedra, 5, 2, 3, 1);
  std::size_t on_circle = 0;
  for (const Point& p : points) {
    const double radius = std::hypot(p.x(), p.y());
    EXPECT_LT(radius, 3 + 1e-12);
    if (radius > 3 - 1e-12)
      ++on_circle;
  }
  EXPECT_EQ(on_circle, 20u * 3u);
}

TEST(Generator_parameters, are_refused_where_nothing_can_be_meshed)
{
  Points points;
  Hexahedra hexahedra;
  EXPECT_THROW(HMO::make_block(points, hexahedra, {{1, 0, 1}}), HMO::Input_error);
  EXPECT_THROW(HMO::make_block(points, hexahedra, {{1, 1, 1}}, {{1, -1, 1}}), HMO::Input_error);
  EXPECT_THROW(HMO::make_block(points, hexahedra, {{1, 1, 1}}, {{1, 1, 1}}, {{1, 0, 1}}), HMO::Input_error);
  EXPECT_THROW(HMO::make_bent_bar(points, hexahedra, 4, 1, 1, 1, 3), HMO::Input_error);
  EXPECT_THROW(HMO::make_cylinder(points, hexahedra, 2, 2, 0), HMO::Input_error);
  EXPECT_THROW(HMO::make_ball(points, hexahedra, 0), HMO::Input_error);
  EXPECT_THROW(HMO::make_plate_with_hole(points, hexahedra, 2, 1, 2, 1), HMO::Input_error);
  EXPECT_THROW(HMO::make_ring(points, hexahedra, 2, 1), HMO::Input_error);
  EXPECT_THROW(HMO::make_ring(points, hexahedra, 8, 1, 2, 1), HMO::Input_error);
}

// A block divided is the block with more cells, up to the numbering
TEST(Subdivision, of_a_block_is_a_finer_block)
{
  for (std::size_t n : {1, 2, 3}) {
    Points coarse, fine;
    Hexahedra coarse_cells, fine_cells;
    HMO::make_block(coarse, coarse_cells, {{2, 3, 1}}, {{2, 3, 1}});
    HMO::make_block(fine, fine_cells, {{2 * n, 3 * n, n}}, {{2, 3, 1}});
    const Points given = coarse;
    HMO::subdivide_hex_mesh(coarse, coarse_cells, n);
    ASSERT_EQ(coarse.size(), fine.size());
    ASSERT_EQ(coarse_cells.size(), fine_cells.size());
    EXPECT_TRUE(std::equal(given.begin(), given.end(), coarse.begin()));
    const auto cells = [](const Points& points, const Hexahedra& hexahedra) {
      std::multiset<std::array<long, 24>> result; // coordinates of the corners, rounded
      for (const auto& h : hexahedra) {
        std::array<long, 24> key;
        for (int c = 0; c < 8; ++c)
          for (int d = 0; d < 3; ++d)
            key[3 * c + d] = std::lround(1e6 * points[h[c]][d]);
        result.insert(key);
      }
      return result;
    };
    EXPECT_EQ(cells(coarse, coarse_cells), cells(fine, fine_cells));
  }
}

} // namespace
