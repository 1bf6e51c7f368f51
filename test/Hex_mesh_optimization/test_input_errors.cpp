// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Unusable input is refused by name before anything moves; unusual input is handled.

#include <CGAL/optimize_hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/coincident_vertices.h>
#include <CGAL/Hex_mesh_optimization/quality.h>

#include "mesh_families.h"

#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace params = CGAL::parameters;
using Element = HMO::Input_error::Element;
using Point = Indexed_mesh::Point;
using Points = std::vector<Point>;
using Surface_mesh = CGAL::Surface_mesh<Point>;
using Cells = std::vector<std::vector<int>>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A mesh whose cells can be anything
struct Mesh
{
  Points points;
  Cells cells;
};

Mesh block(std::size_t nx, std::size_t ny, std::size_t nz, bool is_tangled = true)
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{nx, ny, nz}}, {{double(nx), double(ny), double(nz)}});
  if (is_tangled)
    HMO::scramble_interior(mesh.points, mesh.hexahedra, 1);
  Mesh result{mesh.points, {}};
  for (const auto& h : mesh.hexahedra)
    result.cells.emplace_back(h.begin(), h.end());
  return result;
}

bool is_same(const Point& a, const Point& b)
{
  for (int d = 0; d < 3; ++d)
    if (a[d] != b[d] && !(std::isnan(a[d]) && std::isnan(b[d])))
      return false;
  return true;
}

template <class Optimize>
void expect_refused(Points& points, Element element, std::size_t index, const std::string& words,
                    const Optimize& optimize)
{
  const Points before = points;
  try {
    optimize();
    ADD_FAILURE() << "nothing was thrown";
  }
  catch (const HMO::Input_error& error) {
    EXPECT_EQ(int(error.element()), int(element)) << error.message();
    EXPECT_EQ(error.element_index(), index) << error.message();
    EXPECT_NE(error.message().find(words), std::string::npos) << error.message();
    EXPECT_EQ(error.what(), error.message());
  }
  ASSERT_EQ(points.size(), before.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    EXPECT_TRUE(is_same(points[v], before[v])) << v;
}

void expect_refused(Mesh mesh, Element element, std::size_t index, const std::string& words)
{
  expect_refused(mesh.points, element, index, words, [&] { CGAL::optimize_hex_mesh(mesh.points, mesh.cells); });
}

TEST(Input_errors, of_an_empty_mesh)
{
  expect_refused(Mesh(), Element::MESH, 0, "no hexahedra");
  expect_refused(Mesh{{Point(0, 0, 0), Point(1, 0, 0)}, {}}, Element::MESH, 0, "no hexahedra");
}

TEST(Input_errors, of_a_cell_with_seven_or_nine_vertices)
{
  Mesh mesh = block(3, 3, 3);
  mesh.cells[5].pop_back();
  expect_refused(mesh, Element::HEXAHEDRON, 5, "7 vertices");
  mesh = block(3, 3, 3);
  mesh.cells[26].push_back(0);
  expect_refused(mesh, Element::HEXAHEDRON, 26, "9 vertices");
}

TEST(Input_errors, of_an_index_out_of_range)
{
  for (int bad : {64, 1000000, std::numeric_limits<int>::max(), -1, std::numeric_limits<int>::min()}) {
    Mesh mesh = block(3, 3, 3);
    mesh.cells[7][3] = bad;
    expect_refused(mesh, Element::HEXAHEDRON, 7, "hexahedron 7");
  }
  Mesh mesh = block(3, 3, 3);
  std::vector<std::array<std::size_t, 8>> cells;
  for (const auto& c : mesh.cells) {
    cells.emplace_back();
    std::copy(c.begin(), c.end(), cells.back().begin());
  }
  cells[2][0] = std::size_t(1) << 32; // would be 0 if it were cut off
  expect_refused(mesh.points, Element::HEXAHEDRON, 2, "hexahedron 2",
                 [&] { CGAL::optimize_hex_mesh(mesh.points, cells); });
  cells[2][0] = std::numeric_limits<std::size_t>::max();
  expect_refused(mesh.points, Element::HEXAHEDRON, 2, "hexahedron 2",
                 [&] { CGAL::optimize_hex_mesh(mesh.points, cells); });
}

TEST(Input_errors, of_a_vertex_at_two_corners)
{
  Mesh mesh = block(3, 3, 3);
  mesh.cells[9][6] = mesh.cells[9][1];
  expect_refused(mesh, Element::HEXAHEDRON, 9, "vertex " + std::to_string(mesh.cells[9][1]));
}

TEST(Input_errors, of_a_coordinate_that_is_not_finite)
{
  for (double bad : {nan, infinity, -infinity})
    for (int d = 0; d < 3; ++d) {
      Mesh mesh = block(3, 3, 3);
      double x[3] = {.5, .5, .5};
      x[d] = bad;
      mesh.points[21] = Point(x[0], x[1], x[2]);
      expect_refused(mesh, Element::VERTEX, 21, "vertex 21");
    }
}

TEST(Input_errors, of_three_hexahedra_on_a_face)
{
  Mesh mesh = block(2, 1, 1);
  const std::vector<int> c = mesh.cells[1];
  for (int i = 0; i < 4; ++i)
    mesh.points.push_back(Point(1.5, i, 2));
  mesh.cells.push_back({c[0], 12, 13, c[3], c[4], 14, 15, c[7]});
  expect_refused(mesh, Element::HEXAHEDRON, 2, "third");
}

TEST(Input_errors, of_neighbors_that_share_four_vertices_and_no_face)
{
  Mesh mesh = block(2, 1, 1);
  std::swap(mesh.cells[1][0], mesh.cells[1][3]);
  expect_refused(mesh, Element::HEXAHEDRON, 1, "hexahedra 0 and 1 share four vertices");
}

// A ring of which the last hexahedron meets the first with its corners mirrored
TEST(Input_errors, of_a_mesh_without_an_orientation)
{
  Mesh mesh;
  for (int i = 0; i < 5; ++i) {
    const double a = 2 * 3.14159265358979 * i / 5;
    for (double r : {2., 3.})
      for (double z : {0., 1.})
        mesh.points.emplace_back(r * std::cos(a), r * std::sin(a), z);
    const int n = 4 * i, m = 4 * ((i + 1) % 5), inner = i < 4 ? 0 : 2;
    mesh.cells.push_back({n, n + 2, m + 2 - inner, m + inner, n + 1, n + 3, m + 3 - inner, m + 1 + inner});
  }
  expect_refused(mesh, Element::HEXAHEDRON, 3, "has no orientation");
}

TEST(Input_errors, of_a_mesh_in_one_point)
{
  Mesh mesh = block(2, 2, 2);
  for (Point& p : mesh.points)
    p = Point(3, 4, 5);
  expect_refused(mesh, Element::MESH, 0, "in one point");
}

TEST(Input_errors, name_the_first_element_at_fault)
{
  Mesh mesh = block(3, 3, 3);
  mesh.points[30] = mesh.points[40] = Point(0, nan, 0);
  expect_refused(mesh, Element::VERTEX, 30, "vertex 30");
  mesh = block(3, 3, 3);
  mesh.cells[4][0] = mesh.cells[8][0] = -5;
  expect_refused(mesh, Element::HEXAHEDRON, 4, "hexahedron 4");
}

// --- References ----------------------------------------------------------------------

Surface_mesh cube(double size)
{
  Surface_mesh surface;
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{1, 1, 1}}, {{size, size, size}});
  for_boundary(
    mesh, [&](const Point& p) { return surface.add_vertex(p); },
    [&](Surface_mesh::Vertex_index a, Surface_mesh::Vertex_index b, Surface_mesh::Vertex_index c) {
      surface.add_face(a, b, c);
    });
  return surface;
}

void expect_refused(const Surface_mesh& reference, Element element, std::size_t index, const std::string& words)
{
  Mesh mesh = block(3, 3, 3);
  expect_refused(mesh.points, element, index, words,
                 [&] { CGAL::optimize_hex_mesh(mesh.points, mesh.cells, reference); });
}

TEST(Input_errors, of_an_empty_reference)
{
  expect_refused(Surface_mesh(), Element::MESH, 0, "reference surface is empty");
  Surface_mesh without_faces;
  without_faces.add_vertex(Point(0, 0, 0));
  expect_refused(without_faces, Element::MESH, 0, "reference surface is empty");
}

TEST(Input_errors, of_a_reference_with_a_quad)
{
  Surface_mesh surface = cube(3);
  const auto a = surface.add_vertex(Point(9, 0, 0)), b = surface.add_vertex(Point(10, 0, 0)),
             c = surface.add_vertex(Point(10, 1, 0)), d = surface.add_vertex(Point(9, 1, 0));
  surface.add_face(a, b, c, d);
  expect_refused(surface, Element::REFERENCE_FACE, 12, "not triangulated");
}

TEST(Input_errors, of_a_reference_with_a_coordinate_that_is_not_finite)
{
  for (double bad : {nan, infinity}) {
    Surface_mesh surface = cube(3);
    surface.point(Surface_mesh::Vertex_index(5)) = Point(0, bad, 0);
    expect_refused(surface, Element::REFERENCE_VERTEX, 5, "vertex 5");
  }
}

TEST(Input_errors, of_a_reference_without_area)
{
  Surface_mesh surface = cube(3);
  for (const auto v : surface.vertices())
    surface.point(v) = Point(1, 2, 3);
  expect_refused(surface, Element::MESH, 0, "no face with an area");
}

// A reference with some faces of no area is usual
TEST(Input_errors, are_not_raised_for_single_degenerate_reference_faces)
{
  Surface_mesh surface = cube(3);
  const auto a = surface.add_vertex(Point(3, 3, 3)), b = surface.add_vertex(Point(3, 3, 3)),
             c = surface.add_vertex(Point(3, 3, 3));
  surface.add_face(a, b, c);
  Mesh mesh = block(3, 3, 3);
  const HMO::Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.cells, surface);
  EXPECT_TRUE(status.valid_mesh());
}

// --- Parameters ------------------------------------------------------------------------

template <class NamedParameters>
void expect_bad_parameter(const std::string& name, const NamedParameters& np)
{
  SCOPED_TRACE(name);
  Mesh mesh = block(3, 3, 3);
  expect_refused(mesh.points, Element::PARAMETER, 0, name,
                 [&] { CGAL::optimize_hex_mesh(mesh.points, mesh.cells, np); });
}

TEST(Input_errors, of_parameters_without_a_usable_value)
{
  expect_bad_parameter("target_quality", params::target_quality(nan));
  for (double bad : {0., -1., -infinity, nan})
    expect_bad_parameter("maximum_deviation", params::maximum_deviation(bad));
  for (double bad : {-1., nan})
    expect_bad_parameter("maximum_running_time", params::maximum_running_time(bad));
  for (double bad : {-1., 181., nan, infinity})
    expect_bad_parameter("features_angle_bound", params::features_angle_bound(bad));
  for (double bad : {0., -1., nan, infinity})
    expect_bad_parameter("surface_weight", params::surface_weight(bad));
  for (double bad : {0., -1., nan, infinity})
    expect_bad_parameter("feature_weight", params::feature_weight(bad));
  for (double bad : {-1., nan, infinity})
    expect_bad_parameter("regularization_weight", params::regularization_weight(bad));
  for (double bad : {0., -1., 90., 100., nan})
    expect_bad_parameter("cone_angle_bound", params::cone_angle_bound(bad));
}

struct Length
{
  using key_type = std::pair<std::size_t, std::size_t>;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;
  double value;
  friend double get(const Length& map, const key_type& edge)
  {
    return edge == key_type(0, 1) || edge == key_type(1, 0) ? map.value : 1;
  }
};

TEST(Input_errors, of_target_lengths_that_are_not_positive)
{
  for (double bad : {0., -1., nan, infinity}) {
    Mesh mesh = block(3, 3, 3);
    expect_refused(mesh.points, Element::PARAMETER, 0, "from vertex 0 to vertex 1", [&] {
      CGAL::optimize_hex_mesh(mesh.points, mesh.cells, params::target_edge_length_map(Length{bad}));
    });
  }
}

TEST(Input_errors, of_internal_faces_with_vertices_that_do_not_exist)
{
  for (long long bad : {64ll, -1ll, 1ll << 32}) {
    Mesh mesh = block(3, 3, 3);
    const std::vector<std::array<long long, 4>> faces = {{0, 1, 2, 3}, {0, 1, 2, 63}, {0, 1, bad, 3}};
    expect_refused(mesh.points, Element::PARAMETER, 2, "internal face 2",
                   [&] { CGAL::optimize_hex_mesh(mesh.points, mesh.cells, params::internal_faces(faces)); });
  }
}

// --- Linear cell complexes ---------------------------------------------------------------

using LCC = CGAL::Linear_cell_complex_for_combinatorial_map<3>;

TEST(Input_errors, of_an_empty_linear_cell_complex)
{
  LCC lcc;
  EXPECT_THROW(CGAL::optimize_hex_mesh(lcc), HMO::Input_error);
}

TEST(Input_errors, of_a_volume_that_is_not_a_hexahedron)
{
  LCC lcc;
  using P = LCC::Point;
  lcc.make_hexahedron(P(0, 0, 0), P(1, 0, 0), P(1, 1, 0), P(0, 1, 0), P(0, 1, 1), P(0, 0, 1), P(1, 0, 1), P(1, 1, 1));
  lcc.make_tetrahedron(P(5, 0, 0), P(6, 0, 0), P(5, 1, 0), P(5, 0, 1));
  std::vector<P> before;
  for (auto it = lcc.vertex_attributes().begin(); it != lcc.vertex_attributes().end(); ++it)
    before.push_back(it->point());
  try {
    CGAL::optimize_hex_mesh(lcc);
    ADD_FAILURE() << "nothing was thrown";
  }
  catch (const HMO::Input_error& error) {
    EXPECT_EQ(error.element(), Element::HEXAHEDRON);
    EXPECT_EQ(error.element_index(), 1u);
  }
  std::size_t i = 0;
  for (auto it = lcc.vertex_attributes().begin(); it != lcc.vertex_attributes().end(); ++it)
    EXPECT_EQ(it->point(), before[i++]);
}

// --- Unusual, but handled -------------------------------------------------------------------

void expect_honest(Mesh before, Mesh after, const HMO::Status& status)
{
  for (Mesh* mesh : {&before, &after}) // the statistics refer to the numbering with top and bottom exchanged
    for (std::size_t h : status.reoriented_hexahedra)
      std::swap_ranges(mesh->cells[h].begin(), mesh->cells[h].begin() + 4, mesh->cells[h].begin() + 4);
  const HMO::Quality_statistics a = HMO::quality_statistics(before.points, before.cells);
  const HMO::Quality_statistics b = HMO::quality_statistics(after.points, after.cells);
  EXPECT_EQ(status.before.number_of_inverted, a.number_of_inverted);
  EXPECT_EQ(status.after.number_of_inverted, b.number_of_inverted);
  EXPECT_EQ(status.after.number_of_invalid, b.number_of_invalid);
  EXPECT_EQ(status.invalid_hexahedra.size(), b.number_of_invalid);
  EXPECT_EQ(status.after.minimum, b.minimum);
  EXPECT_LE(b.number_of_inverted, a.number_of_inverted);
  for (const Point& p : after.points)
    for (int d = 0; d < 3; ++d)
      EXPECT_TRUE(std::isfinite(p[d]));
}

HMO::Status optimized(Mesh& mesh)
{
  const Mesh before = mesh;
  const HMO::Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.cells);
  expect_honest(before, mesh, status);
  return status;
}

TEST(Unusual_input, of_one_hexahedron)
{
  Mesh mesh = block(1, 1, 1);
  HMO::Status status = optimized(mesh);
  EXPECT_TRUE(status.valid_mesh());
  EXPECT_EQ(status.after.minimum, 1);

  mesh.points[6] = Point(.1, .2, .1); // pushed in
  status = optimized(mesh);
  EXPECT_TRUE(status.valid_mesh() || status.after.number_of_invalid == 1);
}

TEST(Unusual_input, of_components_apart)
{
  Mesh mesh = block(3, 3, 3);
  const std::size_t n = mesh.points.size(), m = mesh.cells.size();
  for (std::size_t v = 0; v < n; ++v)
    mesh.points.push_back(mesh.points[v] + Indexed_mesh::Kernel::Vector_3(5, 6, 7));
  for (std::size_t h = 0; h < m; ++h) {
    mesh.cells.push_back(mesh.cells[h]);
    for (int& v : mesh.cells.back())
      v += int(n);
  }
  EXPECT_TRUE(optimized(mesh).valid_mesh());
}

// One component the right way around, a smaller one inside out, which alone is turned
TEST(Unusual_input, of_components_of_opposite_orientation)
{
  Mesh mesh = block(3, 3, 3, false);
  const int n = int(mesh.points.size());
  const Mesh cube = block(1, 1, 1);
  for (const Point& p : cube.points)
    mesh.points.push_back(p + Indexed_mesh::Kernel::Vector_3(9, 9, 9));
  mesh.cells.push_back({n + 4, n + 5, n + 6, n + 7, n, n + 1, n + 2, n + 3});
  for (std::size_t i = 0; i < 8; ++i)
    mesh.cells.back()[i] = n + cube.cells[0][(i + 4) % 8];
  const HMO::Status status = optimized(mesh);
  EXPECT_EQ(status.reoriented_hexahedra, std::vector<std::size_t>{27});
  EXPECT_TRUE(status.valid_mesh());
}

// What touches has its edge or its vertex in common, and keeps it.
TEST(Unusual_input, of_parts_that_touch)
{
  for (int d : {2, 3}) { // in as many directions they are neighbors
    SCOPED_TRACE(d == 2 ? "along an edge" : "at a vertex");
    const std::size_t n = 3;
    Mesh mesh = block(2 * n, 2 * n, d == 3 ? 2 * n : n, false);
    Cells cells;
    const auto center = [&](const std::vector<int>& cell) {
      return CGAL::midpoint(mesh.points[std::size_t(cell[0])], mesh.points[std::size_t(cell[6])]);
    };
    for (const auto& cell : mesh.cells) {
      const Point c = center(cell);
      const bool x = c.x() > n, y = c.y() > n, z = d == 3 ? c.z() > n : x;
      if (x == y && y == z)
        cells.push_back(cell);
    }
    mesh.cells = cells;
    ASSERT_EQ(mesh.cells.size(), 2 * n * n * n);
    Points intact = mesh.points;
    HMO::scramble_interior(mesh.points, mesh.cells, 1, .8);
    EXPECT_FALSE(mesh.points == intact);
    EXPECT_TRUE(optimized(mesh).valid_mesh());
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const Point& p = intact[v];
      if (p.x() == n && p.y() == n && (d == 2 ? p.z() == 0 || p.z() == n : p.z() == n)) {
        EXPECT_EQ(mesh.points[v], p) << v;
      }
    }
  }
}

TEST(Unusual_input, with_coordinates_near_the_limits_of_double)
{
  for (double scale : {1e-100, 1e100}) {
    SCOPED_TRACE(scale);
    Mesh mesh = block(3, 3, 3);
    for (Point& p : mesh.points)
      p = Point(scale * p.x(), scale * p.y(), scale * p.z());
    EXPECT_TRUE(optimized(mesh).valid_mesh());
  }
  for (double scale : {1e-300, 1e-200, 1e200, 1e300}) {
    SCOPED_TRACE(scale);
    Mesh mesh = block(3, 3, 3);
    for (Point& p : mesh.points)
      p = Point(scale * p.x(), scale * p.y(), scale * p.z());
    const Points before = mesh.points;
    try {
      optimized(mesh);
    }
    catch (const HMO::Input_error&) { // too large or small to be squared: may be refused, by the documented exception
      EXPECT_EQ(mesh.points, before);
    }
  }
}

TEST(Unusual_input, far_from_the_origin)
{
  Mesh mesh = block(3, 3, 3);
  for (Point& p : mesh.points)
    p = Point(p.x() + 1e9, p.y() - 1e9, p.z() + 1e9);
  EXPECT_TRUE(optimized(mesh).valid_mesh());
}

TEST(Unusual_input, that_is_flat)
{
  Mesh mesh = block(3, 3, 3);
  for (Point& p : mesh.points)
    p = Point(p.x(), p.y(), 0);
  const HMO::Status status = optimized(mesh);
  EXPECT_EQ(status.before.number_of_inverted, mesh.cells.size());
}

TEST(Unusual_input, that_is_a_line)
{
  Mesh mesh = block(2, 2, 2);
  for (Point& p : mesh.points)
    p = Point(p.x(), 0, 0);
  EXPECT_THROW(optimized(mesh), HMO::Input_error); // no surface is left to hold the boundary on
}

// Vertices that faces have in the same places are counted, and merging them makes neighbors.
TEST(Unusual_input, of_hexahedra_with_vertices_of_their_own)
{
  const Mesh whole = block(3, 3, 3);
  Mesh mesh;
  for (const auto& cell : whole.cells) {
    mesh.cells.emplace_back();
    for (int v : cell) {
      mesh.cells.back().push_back(int(mesh.points.size()));
      mesh.points.push_back(whole.points[std::size_t(v)]);
    }
  }
  Mesh merged = mesh;
  EXPECT_EQ(optimized(mesh).number_of_coincident_vertices, 27u * 8u - 64u);
  const std::vector<std::size_t> first = HMO::coincident_vertices(merged.points, merged.cells);
  for (auto& cell : merged.cells)
    for (int& v : cell)
      v = int(first[std::size_t(v)]);
  const HMO::Status status = optimized(merged);
  EXPECT_EQ(status.number_of_coincident_vertices, 0u);
  EXPECT_TRUE(status.valid_mesh());
}

TEST(Unusual_input, with_coincident_vertices)
{
  Mesh mesh = block(4, 4, 4, false);
  std::size_t v = 0;
  for (Point& p : mesh.points)
    if (p.x() > 0 && p.x() < 4 && p.y() > 0 && p.y() < 4 && p.z() > 0 && p.z() < 4) {
      p = Point(2, 2, 2);
      ++v;
    }
  ASSERT_EQ(v, 27u);
  EXPECT_TRUE(optimized(mesh).valid_mesh());
}

// Names both of the two, the second as the one that is too much
TEST(Unusual_input, of_a_hexahedron_that_occurs_twice)
{
  Mesh mesh = block(2, 1, 1);
  mesh.cells.push_back(mesh.cells[0]);
  expect_refused(mesh, Element::HEXAHEDRON, 2, "third");
  mesh = block(1, 1, 1);
  mesh.cells.push_back(mesh.cells[0]);
  EXPECT_THROW(optimized(mesh), HMO::Input_error); // the faces of both coincide, and none is a boundary
}

// A hexahedron and its mirror image share all six faces
TEST(Input_errors, of_a_mesh_without_a_boundary)
{
  Mesh mesh = block(1, 1, 1);
  const std::vector<int> c = mesh.cells[0];
  mesh.cells.push_back({c[4], c[5], c[6], c[7], c[0], c[1], c[2], c[3]});
  expect_refused(mesh, Element::MESH, 0, "no boundary");
}

TEST(Unusual_input, of_1e150_and_1e_minus_150)
{
  for (double scale : {1e-150, 1e150}) {
    SCOPED_TRACE(scale);
    Mesh mesh = block(3, 3, 3);
    for (Point& p : mesh.points)
      p = Point(scale * p.x(), scale * p.y(), scale * p.z());
    const Mesh before = mesh;
    Surface_mesh surface = cube(3);
    for (const auto v : surface.vertices()) {
      const Point& p = surface.point(v);
      surface.point(v) = Point(scale * p.x(), scale * p.y(), scale * p.z());
    }
    EXPECT_TRUE(optimized(mesh).valid_mesh());
    mesh = before;
    const HMO::Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.cells, surface);
    expect_honest(before, mesh, status);
    EXPECT_TRUE(status.valid_mesh());
  }
}

// A vertex of another magnitude than all others
TEST(Unusual_input, with_one_coordinate_of_1e150)
{
  for (double far : {1e150, -1e150, 1e300}) {
    SCOPED_TRACE(far);
    Mesh mesh = block(2, 2, 2, false);
    for (Point& p : mesh.points)
      if (p == Point(1, 1, 1))
        p = Point(1, far, 1);
    const HMO::Status status = optimized(mesh); // an interior vertex
    EXPECT_EQ(status.number_of_reoriented_hexahedra(), 0u);
    EXPECT_GT(status.before.number_of_invalid, 0u);
    EXPECT_LT(status.before.number_of_invalid, 8u);
    EXPECT_TRUE(status.valid_mesh() || std::abs(far) > 1e150); // whose square is no number any more
    mesh = block(2, 2, 2, false);
    mesh.points[0] = Point(far, 0, 0); // a corner
    const Points before = mesh.points;
    try {
      optimized(mesh);
    }
    catch (const HMO::Input_error&) {
      EXPECT_EQ(mesh.points, before);
    }
  }
}

// --- Unusual references ----------------------------------------------------------------------

// The tangled block of three cubes a side with this reference
template <class NamedParameters = params::Default_named_parameters>
HMO::Status optimized(const Surface_mesh& surface, const NamedParameters& np = params::default_values())
{
  Mesh mesh = block(3, 3, 3);
  const Mesh before = mesh;
  const HMO::Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.cells, surface, np);
  expect_honest(before, mesh, status);
  return status;
}

Surface_mesh surface_of_soup(const Points& points, const std::vector<std::array<int, 3>>& triangles)
{
  Surface_mesh surface;
  for (const auto& t : triangles) // every face apart
    surface.add_face(surface.add_vertex(points[t[0]]), surface.add_vertex(points[t[1]]),
                     surface.add_vertex(points[t[2]]));
  return surface;
}

// The faces of a surface, those aside whose index is among `without`, as triangles of a soup
std::vector<std::array<int, 3>> triangles_of(const Surface_mesh& surface, std::size_t without)
{
  std::vector<std::array<int, 3>> result;
  for (const auto f : surface.faces()) {
    std::array<int, 3> t;
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      t[k++] = int(v);
    if (std::size_t(f) >= without)
      result.push_back(t);
  }
  return result;
}

Points points_of(const Surface_mesh& surface)
{
  Points result;
  for (const auto v : surface.vertices())
    result.push_back(surface.point(v));
  return result;
}

TEST(Unusual_reference, that_is_open)
{
  Surface_mesh surface = cube(3);
  for (std::size_t f : {0, 1, 5})
    CGAL::Euler::remove_face(surface.halfedge(Surface_mesh::Face_index(Surface_mesh::size_type(f))), surface);
  surface.collect_garbage();
  EXPECT_EQ(num_faces(surface), 9u);
  EXPECT_TRUE(optimized(surface).valid_mesh());
}

TEST(Unusual_reference, of_one_triangle)
{
  optimized(surface_of_soup({Point(0, 0, 0), Point(3, 0, 0), Point(0, 3, 0)}, {{{0, 1, 2}}}));
}

// As a soup of triangles: every edge is a border
TEST(Unusual_reference, that_is_not_connected)
{
  const Surface_mesh closed = cube(3);
  EXPECT_TRUE(optimized(surface_of_soup(points_of(closed), triangles_of(closed, 0))).valid_mesh());
}

// Three sheets at every edge: the cube twice and a half, one upon the other
TEST(Unusual_reference, that_is_not_a_manifold)
{
  const Surface_mesh closed = cube(3);
  std::vector<std::array<int, 3>> triangles = triangles_of(closed, 0);
  for (std::size_t without : {0, 6})
    for (const auto& t : triangles_of(closed, without))
      triangles.push_back({{t[0], t[2], t[1]}}); // and the orientations do not agree
  EXPECT_TRUE(optimized(surface_of_soup(points_of(closed), triangles)).valid_mesh());
}

TEST(Unusual_reference, that_intersects_itself)
{
  Surface_mesh surface = cube(3), other = cube(3);
  for (const auto v : other.vertices())
    other.point(v) = other.point(v) + Indexed_mesh::Kernel::Vector_3(1.5, 1.2, .9);
  surface.join(other);
  EXPECT_GT(num_faces(surface), 12u);
  optimized(surface);
}

// The message of the refusal of this reference of the block, empty if it is accepted
std::string refusal(const Surface_mesh& surface)
{
  Mesh mesh = block(3, 3, 3);
  const Mesh before = mesh;
  try {
    const auto np =
      params::optimization_method(HMO::Method::RECTIFICATION).number_of_iterations(5).number_of_restarts(0);
    const HMO::Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.cells, surface, np);
    expect_honest(before, mesh, status);
    return "";
  }
  catch (const HMO::Input_error& error) {
    EXPECT_EQ(error.element(), Element::MESH);
    EXPECT_EQ(mesh.points, before.points);
    return error.message();
  }
}

// The cube of the block after x -> scale x + shift (1, 0, 0)
Surface_mesh moved_cube(double scale, double shift)
{
  Surface_mesh surface = cube(3);
  for (const auto v : surface.vertices()) {
    const Point& p = surface.point(v);
    surface.point(v) = Point(scale * p.x() + shift, scale * p.y(), scale * p.z());
  }
  return surface;
}

// Both boxes are named
TEST(Unusual_reference, of_another_unit_of_length_is_refused)
{
  EXPECT_EQ(refusal(moved_cube(1000, 0)), "the reference surface is 1000 times as large as the mesh: it spans (0 0 0) "
                                          "to (3000 3000 3000), the mesh (0 0 0) to (3 3 3): "
                                          "are both in the same unit of length?");
  for (double scale : {1e-3, .3, 3.1, 1e3, 1e100}) {
    const std::string message = refusal(moved_cube(scale, 0));
    EXPECT_NE(message.find("times as large as the mesh"), std::string::npos) << scale << ": " << message;
  }
  for (double scale : {.4, 1., 2.9})
    EXPECT_EQ(refusal(moved_cube(scale, 0)), "") << scale;
  // nothing is left of it in the units of the mesh
  EXPECT_NE(refusal(moved_cube(1e-100, 0)).find("has no face with an area"), std::string::npos);
}

TEST(Unusual_reference, that_is_far_away_is_refused)
{
  for (double distance :
       {8., 1e3, 1e9, 1e150, -8.}) { // the cube's side is 3, and a quarter of its diagonal on both sides is tolerated
    const std::string message = refusal(moved_cube(1, distance));
    EXPECT_NE(message.find("far away from the mesh"), std::string::npos) << distance << ": " << message;
    EXPECT_NE(message.find("the mesh (0 0 0) to (3 3 3)"), std::string::npos) << distance << ": " << message;
  }
  for (double distance : {5., -5., 1.})
    EXPECT_EQ(refusal(moved_cube(1, distance)), "") << distance;
}

// What counts is the boundary, and the triangles: not points that stand elsewhere
TEST(Unusual_reference, is_compared_with_the_boundary_only)
{
  Mesh mesh = block(3, 3, 3);
  const auto is_inside = [](double x) { return x > 0 && x < 3; };
  for (Point& p : mesh.points)
    if (is_inside(p.x()) && is_inside(p.y()) && is_inside(p.z()))
      p = Point(100 * p.x(), p.y(), p.z());
  mesh.points.emplace_back(1e6, 0, 0);
  Surface_mesh surface = cube(3);
  surface.add_vertex(Point(-1e6, 0, 0));
  const auto np = params::number_of_iterations(1).number_of_restarts(0);
  EXPECT_NO_THROW(CGAL::optimize_hex_mesh(mesh.points, mesh.cells, surface, np));
}

// Needles, caps, and triangles shrunk to a point or an edge among good ones
TEST(Unusual_reference, with_many_degenerate_triangles)
{
  const Surface_mesh closed = cube(3);
  Points points = points_of(closed);
  std::vector<std::array<int, 3>> triangles = triangles_of(closed, 0);
  const std::size_t n = triangles.size();
  for (std::size_t t = 0; t < n; ++t) {
    const std::array<int, 3> good = triangles[t];
    const Point a = points[good[0]], b = points[good[1]]; // no references: points grows
    const int middle = int(points.size());
    points.push_back(CGAL::midpoint(a, b));
    points.push_back(a + 1e-14 * (b - a));
    triangles.push_back({{good[0], middle, good[1]}});
    triangles.push_back({{good[0], middle + 1, good[2]}});
    triangles.push_back({{good[0], good[0], good[0]}});
    triangles.push_back({{good[0], good[1], good[0]}});
  }
  Surface_mesh surface;
  for (const auto& t : triangles) {
    std::array<Surface_mesh::Vertex_index, 3> v;
    for (int k = 0; k < 3; ++k)
      v[k] = surface.add_vertex(points[t[k]]);
    surface.add_face(v[0], v[1], v[2]);
  }
  EXPECT_TRUE(optimized(surface).valid_mesh());
}

TEST(Unusual_reference, of_coordinates_that_are_huge)
{
  Surface_mesh surface = cube(3);
  surface.point(Surface_mesh::Vertex_index(3)) = Point(1e200, 1e200, -1e200);
  try {
    optimized(surface);
  }
  catch (const HMO::Input_error& error) {
    EXPECT_NE(error.message().find("reference"), std::string::npos) << error.message();
  }
}

} // namespace
