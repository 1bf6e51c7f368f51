// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes of several regions, with internal faces, and with boundaries that are no manifolds: what is between regions
// stays where it is while all becomes valid, and the guarantees hold. All is measured on the mesh that is handed back.

#include <CGAL/optimize_hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/hexahedra_to_linear_cell_complex.h>
#include <CGAL/Hex_mesh_optimization/linear_cell_complex_to_hexahedra.h>
#include <CGAL/Hex_mesh_optimization/quality.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>

#include "boundary_surface_mesh.h"
#include "Marked_vertices.h"
#include "labelled_meshes.h"
#include "mesh_checks.h"

#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace params = CGAL::parameters;
using namespace HMO::internal;
using HMO::Status;
using Point = Indexed_mesh::Point;
using Surface_mesh = CGAL::Surface_mesh<Point>;

auto regions_of(const Labelled_mesh& mesh)
{
  return params::hexahedron_label_map(CGAL::make_property_map(mesh.labels)).internal_faces(mesh.internal_faces);
}

Status optimize(Labelled_mesh& mesh)
{
  if (mesh.labels.empty())
    return CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, params::internal_faces(mesh.internal_faces));
  return CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, regions_of(mesh));
}

// The faces between two labels, or listed within one, by their labels
std::map<std::array<int, 2>, std::vector<std::array<int, 4>>> interfaces(const Labelled_mesh& mesh)
{
  std::map<std::array<int, 2>, std::vector<std::array<int, 4>>> result;
  const auto complex = mesh.regions();
  for (const auto& f : complex.boundary_faces)
    if (f.beyond >= 0)
      result[{complex.label(f.hexahedron), complex.label(f.beyond)}].push_back(f.vertices);
  return result;
}

// From a lattice of points on each face of one
double largest_distance(const std::vector<std::array<int, 4>>& faces, const Positions& from, const Positions& to)
{
  const int n = 6;
  const Triangle_surface surface(to, split_quads(faces));
  double largest = 0;
  for (const Triangle_indices& t : split_quads(faces))
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const double u = double(i) / n, v = double(j) / n;
        const Vector_3 p = (1 - u - v) * from[t[0]] + u * from[t[1]] + v * from[t[2]];
        largest = (std::max)(largest, (surface.closest_point(p).point - p).norm());
      }
  return largest;
}

double mean_edge(const std::vector<std::array<int, 4>>& faces, const Positions& points)
{
  std::set<std::array<int, 2>> edges;
  for (const auto& q : faces)
    for (int k = 0; k < 4; ++k)
      edges.insert({(std::min)(q[k], q[(k + 1) % 4]), (std::max)(q[k], q[(k + 1) % 4])});
  double sum = 0;
  for (const auto& e : edges)
    sum += (points[e[0]] - points[e[1]]).norm();
  return sum / double(edges.size());
}

// Where the surfaces of the mesh were and are, and what the status says of that
void expect_kept(const Labelled_mesh& intact, const Labelled_mesh& mesh, const Status& status)
{
  const auto between = interfaces(intact);
  const Positions before = positions(intact), after = positions(mesh);
  ASSERT_EQ(status.interfaces.size(), between.size());
  std::size_t i = 0;
  for (const auto& [labels, faces] : between) {
    const HMO::Interface_statistics& reported = status.interfaces[i++];
    EXPECT_EQ(reported.labels, labels);
    EXPECT_EQ(reported.number_of_faces, faces.size());
    const double deviation = (std::max)(largest_distance(faces, before, after), largest_distance(faces, after, before));
    const double edge = mean_edge(faces, before);
    EXPECT_LE(deviation, .1 * edge) << "between " << labels[0] << " and " << labels[1];
    EXPECT_LE(reported.deviation.maximum, .1 * edge);
    EXPECT_NEAR(reported.deviation.maximum, deviation, .03 * edge);
    EXPECT_LE(reported.deviation.average, reported.deviation.maximum);
  }
  const std::set<int> labels = intact.labels.empty() ? std::set<int>{0}
                                                     : std::set<int>(intact.labels.begin(), intact.labels.end());
  ASSERT_EQ(status.regions.size(), labels.size());
  i = 0;
  double sum_before = 0, sum_after = 0;
  for (int label : labels) {
    const HMO::Region_volume& reported = status.regions[i++];
    EXPECT_EQ(reported.label, label);
    const double volume = volume_of_label(intact, label);
    EXPECT_NEAR(reported.before, volume, 1e-9 * volume) << "wherever the interior is";
    EXPECT_NEAR(reported.after, volume_of_label(mesh, label), 1e-9 * volume);
    EXPECT_NEAR(reported.after, volume, .01 * volume) << "of label " << label;
    sum_before += reported.before;
    sum_after += reported.after;
  }
  EXPECT_NEAR(sum_before, status.volume_before, 1e-9 * sum_before);
  EXPECT_NEAR(sum_after, status.volume_after, 1e-9 * sum_after);
}

class Regions_of : public ::testing::TestWithParam<Labelled_family>
{};

INSTANTIATE_TEST_SUITE_P(Families, Regions_of, ::testing::ValuesIn(labelled_families()), Family_name());

TEST_P(Regions_of, are_untangled_and_keep_their_interfaces)
{
  const Labelled_mesh intact = GetParam().make();
  ASSERT_TRUE(invalid_hexahedra(intact).empty());
  for (unsigned seed = 0; seed < 4; ++seed)
    for (double edges : {.3, 1.}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(edges) + " edges");
      Labelled_mesh mesh = intact;
      scramble_within_regions(mesh, seed, edges);
      EXPECT_TRUE(edges < 1 || !invalid_hexahedra(mesh).empty());
      const Status status = optimize(mesh);
      EXPECT_TRUE(status.valid_mesh());
      EXPECT_TRUE(invalid_hexahedra(mesh).empty());
      expect_kept(intact, mesh, status);
    }
}

// Without labels the same mesh loses its interface: what the labels do is seen
TEST(Regions, are_what_keeps_an_interface)
{
  const Labelled_mesh intact = ball_in_a_block();
  const auto faces = interfaces(intact).begin()->second;
  Labelled_mesh with = intact, without = intact;
  scramble_within_regions(with, 1, 1);
  without.points = with.points;
  without.labels.clear();
  optimize(with);
  const Status status = optimize(without);
  EXPECT_TRUE(status.interfaces.empty());
  EXPECT_EQ(status.regions.size(), 1u);
  const auto farthest = [&](const Labelled_mesh& mesh) {
    return largest_distance(faces, positions(mesh), positions(intact));
  };
  EXPECT_LT(3 * farthest(with), farthest(without));
}

// They need not be tangled to be improved: vertices slide within an interface, also where those of the outer boundary are
// fixed, but not where they are fixed themselves.
TEST_P(Regions_of, have_vertices_that_slide_in_interfaces)
{
  Labelled_mesh input = GetParam().make();
  std::mt19937 random(7);
  const auto complex = input.regions();
  const Positions before = positions(input);
  const Surface_faces faces = boundary_surface_faces(complex);
  const auto surface = boundary_as_reference(complex, faces, before, Feature_parameters());
  Boundary_attachment attachment = attach_to_own_boundary(complex, *surface);
  // within smooth interfaces, towards a neighbor
  std::set<int> moved;
  std::vector<char> is_between(input.points.size(), false);
  for (const Surface_faces::Vertex& v : faces.vertices)
    if (faces.is_interface(v.face)) {
      is_between[v.vertex] = true;
      if (attachment.kind[v.vertex] != Vertex_kind::SURFACE || random() % 2 != 0)
        continue;
      const auto& q = faces.quads[v.face];
      const int next = q[(std::find(q.begin(), q.end(), v.vertex) - q.begin() + 1) % 4];
      if (moved.count(next))
        continue;
      moved.insert(v.vertex);
      input.points[v.vertex] = CGAL::ORIGIN + (.7 * (input.points[v.vertex] - CGAL::ORIGIN) +
                                               .3 * (input.points[next] - CGAL::ORIGIN));
    }
  ASSERT_GT(moved.size(), 0u);
  const auto is_outside = input.complex().is_on_boundary;
  enum { NOTHING, OUTSIDE, BOTH };
  for (int fixed : {NOTHING, OUTSIDE, BOTH}) {
    SCOPED_TRACE(fixed);
    Labelled_mesh mesh = input;
    std::vector<char> is_frozen(mesh.points.size(), false);
    if (fixed == BOTH)
      is_frozen = is_between;
    const Status status = CGAL::optimize_hex_mesh(
      mesh.points, mesh.hexahedra,
      regions_of(mesh).fixed_boundary(fixed != NOTHING).vertex_is_constrained_map(Marked_vertices{&is_frozen}));
    EXPECT_TRUE(status.valid_mesh());
    EXPECT_GE(status.after.minimum, status.before.minimum);
    if (fixed != BOTH) {
      EXPECT_GT(status.after.average, status.before.average);
    }
    expect_kept(input, mesh, status);
    int slid = 0;
    for (int v : moved)
      slid += !same_bits(mesh.points[v], input.points[v]);
    EXPECT_EQ(slid > 0, fixed != BOTH);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if ((fixed != NOTHING && is_outside[v]) || is_frozen[v]) {
        EXPECT_TRUE(same_bits(mesh.points[v], input.points[v])) << v;
      }
  }
}

TEST_P(Regions_of, come_out_with_the_same_bits_in_one_thread_and_two)
{
  Labelled_mesh sequential = GetParam().make();
  scramble_within_regions(sequential, 3, .7);
  const Labelled_mesh input = sequential;
  optimize(sequential);
#ifdef CGAL_LINKED_WITH_TBB
  for (int threads : {1, 2}) {
    Labelled_mesh mesh = input;
    tbb::task_arena arena(threads);
    arena.execute([&] { CGAL::optimize_hex_mesh<CGAL::Parallel_tag>(mesh.points, mesh.hexahedra, regions_of(mesh)); });
    EXPECT_TRUE(same_points(mesh.points, sequential.points)) << threads;
  }
#endif
  Labelled_mesh again = input;
  optimize(again);
  EXPECT_TRUE(same_points(again.points, sequential.points));
}

// --- Guarantees ----------------------------------------------------------------------------

void expect_never_worse(const Labelled_mesh& input, const Labelled_mesh& mesh)
{
  const HMO::Quality_statistics a = HMO::quality_statistics(input.points, input.hexahedra);
  const HMO::Quality_statistics b = HMO::quality_statistics(mesh.points, mesh.hexahedra);
  EXPECT_LE(b.number_of_inverted, a.number_of_inverted);
  if (invalid_hexahedra(input).empty()) {
    EXPECT_TRUE(invalid_hexahedra(mesh).empty());
    EXPECT_GE(b.minimum, a.minimum);
  }
}

// Noise on all vertices, those of interfaces too: the mesh that comes in is its own reference
TEST_P(Regions_of, are_never_made_worse)
{
  const Labelled_mesh intact = GetParam().make();
  for (unsigned seed = 0; seed < 4; ++seed)
    for (double edges : {0., .05, .2, .6}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(edges) + " edges");
      Labelled_mesh mesh = intact;
      std::mt19937 random(seed);
      const double size = edges * mesh.mean_edge_length();
      const auto step = [&] { return size * (random() / 2147483648. - 1); };
      for (Point& p : mesh.points) {
        const double x = step(), y = step(), z = step();
        p = Point(p.x() + x, p.y() + y, p.z() + z);
      }
      std::vector<char> is_frozen(mesh.points.size(), false);
      for (std::size_t v = seed; v < is_frozen.size(); v += 5)
        is_frozen[v] = seed % 2;
      const Labelled_mesh input = mesh;
      CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra,
                              regions_of(mesh).vertex_is_constrained_map(Marked_vertices{&is_frozen}));
      expect_never_worse(input, mesh);
      for (std::size_t v = 0; v < is_frozen.size(); ++v)
        if (is_frozen[v]) {
          EXPECT_TRUE(same_bits(mesh.points[v], input.points[v])) << v;
        }
    }
}

TEST_P(Regions_of, have_an_outer_boundary_that_can_be_fixed)
{
  const Labelled_mesh intact = GetParam().make();
  Labelled_mesh mesh = intact;
  scramble_within_regions(mesh, 5, 1);
  const Labelled_mesh input = mesh;
  const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, regions_of(mesh).fixed_boundary(true));
  EXPECT_TRUE(status.valid_mesh());
  expect_never_worse(input, mesh);
  expect_kept(intact, mesh, status);
  const auto is_outside = mesh.complex().is_on_boundary;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (is_outside[v]) {
      EXPECT_TRUE(same_bits(mesh.points[v], input.points[v])) << v;
    }
}

// --- Internal faces ------------------------------------------------------------------------

TEST(Internal_faces, of_a_baffle_are_kept)
{
  const Labelled_mesh intact = block_with_a_baffle();
  ASSERT_EQ(intact.internal_faces.size(), 12u);
  for (unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    Labelled_mesh mesh = intact;
    scramble_within_regions(mesh, seed, 1);
    const Status status = optimize(mesh);
    EXPECT_TRUE(status.valid_mesh());
    expect_kept(intact, mesh, status);
    ASSERT_EQ(status.interfaces.size(), 1u);
    EXPECT_EQ(status.interfaces[0].labels, (std::array<int, 2>{0, 0}));
    EXPECT_EQ(status.interfaces[0].number_of_faces, 12u);
  }
}

TEST(Internal_faces, may_be_given_as_a_map_of_facets)
{
  Labelled_mesh intact = block_with_a_baffle();
  scramble_within_regions(intact, 1, 1);
  Labelled_mesh of_list = intact, of_map = intact;
  optimize(of_list);
  std::set<std::array<std::size_t, 4>> facets;
  for (const auto& face : intact.internal_faces) {
    std::array<std::size_t, 4> facet;
    std::copy(face.begin(), face.end(), facet.begin());
    std::sort(facet.begin(), facet.end());
    facets.insert(facet);
  }
  CGAL::optimize_hex_mesh(of_map.points, of_map.hexahedra,
                          params::facet_is_constrained_map(CGAL::make_boolean_property_map(facets)));
  for (std::size_t v = 0; v < intact.points.size(); ++v)
    EXPECT_TRUE(same_bits(of_list.points[v], of_map.points[v])) << v;
}

TEST(Internal_faces, are_kept_beside_interfaces)
{
  Labelled_mesh intact = block_with_a_baffle();
  intact.label([](const Point& p) { return p.z() < 2 ? 4 : 2; });
  for (unsigned seed = 0; seed < 2; ++seed) {
    Labelled_mesh mesh = intact;
    scramble_within_regions(mesh, seed, .8);
    const Status status = optimize(mesh);
    EXPECT_TRUE(status.valid_mesh());
    EXPECT_EQ(status.interfaces.size(), 3u); // 2 2, 2 4, 4 4
    expect_kept(intact, mesh, status);
  }
}

// --- Boundaries that are no manifolds -------------------------------------------------------

struct Contacts
{
  int at_edges = 0, at_vertices = 0;
};

// The contacts of a mesh of voxels that has been damaged and is optimized now
Contacts expect_contacts_kept(const Labelled_mesh& intact, unsigned seed)
{
  Labelled_mesh mesh = intact;
  HMO::jitter_boundary(mesh.points, mesh.hexahedra, seed, .2);
  scramble_within_regions(mesh, seed, .8);
  const Labelled_mesh input = mesh;
  EXPECT_TRUE(optimize(mesh).valid_mesh());
  expect_never_worse(input, mesh);
  Contacts contacts;
  const auto complex = mesh.complex();
  for (int v : touching_vertices(complex)) {
    ++contacts.at_vertices;
    EXPECT_TRUE(same_bits(mesh.points[v], intact.points[v])) << v;
  }
  const double edge = intact.mean_edge_length();
  for (const auto& e : complex.boundary_edges)
    if (e.right < 0) { // contacts are straight lines
      ++contacts.at_edges;
      const auto& ends = complex.edges[e.edge];
      const Indexed_mesh::Kernel::Line_3 line(intact.points[ends[0]], intact.points[ends[1]]);
      for (int v : ends)
        EXPECT_LE(std::sqrt(CGAL::squared_distance(mesh.points[v], line)), .1 * edge) << v;
    }
  return contacts;
}

TEST(Contacts, of_random_voxels_are_kept)
{
  int at_edges = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    at_edges += expect_contacts_kept(random_voxels(seed, seed % 2 ? .25 : .45), seed).at_edges;
  }
  EXPECT_GT(at_edges, 20);
}

// A voxel between eight others, each at one of its corners
TEST(Contacts, at_vertices_alone_stay_bit_for_bit)
{
  Labelled_mesh voxels;
  make_voxels(voxels, 3, 3, 3, 3, [](int i, int j, int k) {
    return i % 2 == j % 2 && j % 2 == k % 2; // the middle one and the corners
  });
  for (unsigned seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE(seed);
    const Contacts contacts = expect_contacts_kept(voxels, seed);
    EXPECT_EQ(contacts.at_vertices, 8);
    EXPECT_EQ(contacts.at_edges, 0);
  }
}

TEST(Contacts, with_a_fixed_boundary_stay_bit_for_bit)
{
  for (unsigned seed = 0; seed < 4; ++seed) {
    Labelled_mesh mesh = random_voxels(seed);
    scramble_within_regions(mesh, seed, 1);
    const Labelled_mesh input = mesh;
    EXPECT_TRUE(CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, params::fixed_boundary(true)).valid_mesh());
    const auto is_on_boundary = mesh.complex().is_on_boundary;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (is_on_boundary[v]) {
        EXPECT_TRUE(same_bits(mesh.points[v], input.points[v])) << v;
      }
  }
}

// Voxels of several materials that touch each other in every way
TEST(Contacts, of_voxels_of_several_labels_are_kept)
{
  for (unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    Labelled_mesh intact = random_voxels(seed, .7);
    intact.label([&](const Point& p) {
      const unsigned voxel = unsigned(p.x()) + 3 * unsigned(p.y()) + 9 * unsigned(p.z());
      return int((voxel * 2654435761u + seed * 40503u) >> 30);
    });
    Labelled_mesh mesh = intact;
    scramble_within_regions(mesh, seed, .8);
    const Labelled_mesh input = mesh;
    const Status status = optimize(mesh);
    EXPECT_TRUE(status.valid_mesh());
    expect_never_worse(input, mesh);
    expect_kept(intact, mesh, status);
  }
}

// --- Linear cell complexes ---------------------------------------------------------------

using LCC =
  CGAL::Linear_cell_complex_for_combinatorial_map<3, 3, CGAL::Linear_cell_complex_traits<3, Indexed_mesh::Kernel>>;

// Labels by where the volume of a dart begins: in the mesh that comes in
struct Labels_of_darts
{
#if CGAL_VERSION_NR >= 1050600000
  using key_type = LCC::Dart_const_descriptor;
#else
  using key_type = LCC::Dart_const_handle;
#endif
  using value_type = int;
  using reference = int;
  using category = boost::readable_property_map_tag;
  const LCC* lcc;
  const std::map<std::set<Point>, int>* labels;
  friend int get(const Labels_of_darts& map, key_type dart)
  {
    std::set<Point> corners;
    for (auto it = map.lcc->one_dart_per_incident_cell<0, 3>(dart).begin(),
              end = map.lcc->one_dart_per_incident_cell<0, 3>(dart).end();
         it != end; ++it)
      corners.insert(map.lcc->point(it));
    return map.labels->at(corners);
  }
};

// A mesh as a complex, and as ranges in the order of the complex
struct Complex_and_ranges
{
  explicit Complex_and_ranges(const Labelled_mesh& mesh)
  {
    HMO::hexahedra_to_linear_cell_complex(mesh.points, mesh.hexahedra, lcc);
    for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
      labels_[corners(mesh.points, mesh.hexahedra[h])] = mesh.labels[h];
    HMO::linear_cell_complex_to_hexahedra(lcc, ranges.points, ranges.hexahedra);
    for (const auto& h : ranges.hexahedra)
      ranges.labels.push_back(labels_.at(corners(ranges.points, h)));
  }
  Complex_and_ranges(const Complex_and_ranges&) = delete;

  auto parameters_of_complex() const { return params::hexahedron_label_map(Labels_of_darts{&lcc, &labels_}); }

  void expect_the_same() const
  {
    Labelled_mesh result;
    HMO::linear_cell_complex_to_hexahedra(lcc, result.points, result.hexahedra);
    EXPECT_EQ(result.hexahedra, ranges.hexahedra);
    EXPECT_TRUE(same_points(result.points, ranges.points));
  }

  LCC lcc;
  Labelled_mesh ranges;

private:
  template <class Hexahedron>
  static std::set<Point> corners(const std::vector<Point>& points, const Hexahedron& hexahedron)
  {
    std::set<Point> result;
    for (std::size_t v : hexahedron)
      result.insert(points[v]);
    return result;
  }

  std::map<std::set<Point>, int> labels_;
};

TEST(Labels_of_a_linear_cell_complex, are_those_of_ranges)
{
  Labelled_mesh mesh = three_regions_around_a_curve();
  scramble_within_regions(mesh, 2, .6);
  Complex_and_ranges both(mesh);
  const Status of_complex = CGAL::optimize_hex_mesh(both.lcc, both.parameters_of_complex());
  const Status of_ranges = optimize(both.ranges);
  both.expect_the_same();
  ASSERT_EQ(of_complex.interfaces.size(), 3u);
  ASSERT_EQ(of_ranges.interfaces.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(of_complex.interfaces[i].labels, of_ranges.interfaces[i].labels);
    EXPECT_EQ(of_complex.interfaces[i].deviation.maximum, of_ranges.interfaces[i].deviation.maximum);
  }
}

// --- With a reference ------------------------------------------------------------------------

// Two disks, one on the other, within a cylinder of this radius
Labelled_mesh pile(double radius)
{
  Labelled_mesh mesh;
  HMO::make_cylinder(mesh.points, mesh.hexahedra, 4, 6, radius);
  mesh.label([](const Point& p) { return p.z() < 1 ? 1 : 2; });
  return mesh;
}

// The rim goes along with the outside, however far that is, what is within stays in its plane.
TEST(Reference_of_the_outside, takes_the_rims_of_interfaces_along)
{
  Indexed_mesh finer;
  HMO::make_cylinder(finer.points, finer.hexahedra, 12, 12);
  const Surface_mesh surface = surface_of(finer);
  for (double radius : {1., .99, .94, 1.06})
    for (unsigned seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(std::to_string(radius) + ", seed " + std::to_string(seed));
      Labelled_mesh mesh = pile(radius);
      const Labelled_mesh intact = mesh;
      const double edge = mesh.mean_edge_length();
      scramble_within_regions(mesh, seed, .7);
      const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface, regions_of(mesh));
      EXPECT_TRUE(status.valid_mesh());
      const auto is_on_boundary = mesh.regions().is_on_boundary, is_outside = mesh.complex().is_on_boundary;
      int rim = 0, within = 0;
      for (std::size_t v = 0; v < mesh.points.size(); ++v)
        if (is_on_boundary[v] && intact.points[v].z() == 1) {
          const Point& p = mesh.points[v];
          EXPECT_NEAR(p.z(), 1, .1 * edge) << v;
          ++(is_outside[v] ? rim : within);
          if (is_outside[v]) {
            EXPECT_NEAR(std::hypot(p.x(), p.y()), 1, .1 * edge) << v;
          }
        }
      EXPECT_EQ(rim, 16);
      EXPECT_GT(within, 20);
      ASSERT_EQ(status.interfaces.size(), 1u);
      EXPECT_LE(status.interfaces[0].deviation.maximum, .1 * edge);
      for (const auto& region : status.regions)
        EXPECT_NEAR(region.after, volume_of_label(mesh, region.label), 1e-9);
    }
}

// Interfaces between waves, which go on as they end. All of the outside is elsewhere.
TEST(Reference_of_the_outside, takes_the_rims_of_curved_interfaces_along)
{
  const auto wave = [](const Point& p) { return .4 * std::sin(.9 * p.x()) * std::cos(.5 * p.y()); };
  for (double factor : {.95, 1.05}) {
    SCOPED_TRACE(factor);
    Labelled_mesh mesh = layered_plate(), scaled;
    HMO::make_block(scaled.points, scaled.hexahedra, {{28, 24, 2}}, {{7, 6, 6}});
    scaled.bend([&](const Point& p) {
      const Point q(3.5 + factor * (p.x() - 3.5), 3 + factor * (p.y() - 3), 3 + factor * (p.z() - 3));
      return Point(q.x(), q.y(), q.z() + wave(q));
    });
    scramble_within_regions(mesh, 1, .4);
    const double limit = .1 * mesh.mean_edge_length();
    const Surface_mesh surface = surface_of(scaled);
    const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface,
                                                  regions_of(mesh).maximum_deviation(limit));
    EXPECT_TRUE(status.valid_mesh());
    EXPECT_GT(status.after.minimum, .5);
    EXPECT_TRUE(status.is_within_deviation_bound()) << status.deviation.certified;
    ASSERT_EQ(status.interfaces.size(), 1u);
    EXPECT_LE(status.interfaces[0].deviation.maximum, limit);
    const auto between = interfaces(mesh);
    for (const auto& face : between.begin()->second)
      for (int v : face) {
        const Point& p = mesh.points[v];
        const double z = p.z() - wave(p);
        EXPECT_LE((std::min)(std::abs(z - 2), std::abs(z - 4)), limit) << v;
      }
  }
}

// --- With references of interfaces ---------------------------------------------------------------

// A surface over a square around (3, 3)
using Soup = std::pair<std::vector<Point>, std::vector<std::array<int, 3>>>;

template <class Height>
Soup surface_over(double half, const Height& height)
{
  const int n = 24;
  Soup soup;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = 3 + half * (2. * i / n - 1), y = 3 + half * (2. * j / n - 1);
      soup.first.emplace_back(x, y, height(x, y));
      if (i < n && j < n) {
        const int v = i + (n + 1) * j;
        soup.second.push_back({v, v + 1, v + n + 2});
        soup.second.push_back({v, v + n + 2, v + n + 1});
      }
    }
  return soup;
}

Surface_mesh as_mesh(const Soup& soup)
{
  Surface_mesh mesh;
  for (const Point& p : soup.first)
    mesh.add_vertex(p);
  for (const auto& t : soup.second)
    mesh.add_face(Surface_mesh::Vertex_index(t[0]), Surface_mesh::Vertex_index(t[1]), Surface_mesh::Vertex_index(t[2]));
  return mesh;
}

double wave(double x, double y) { return 3 + .4 * std::sin(1.1 * x) * std::cos(.7 * y); }
double slope(double x, double y) { return 3.2 + .25 * (x - 3) + .15 * (y - 3); }

// A block of voxels, divided as the surface says
Labelled_mesh voxels_below(double (*height)(double, double))
{
  Labelled_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{6, 6, 6}}, {{6, 6, 6}});
  mesh.label([&](const Point& p) { return p.z() < height(p.x(), p.y()) ? 1 : 2; });
  return mesh;
}

void expect_interface_on(const Labelled_mesh& mesh, const Status& status, double (*height)(double, double),
                         double tolerance)
{
  EXPECT_TRUE(status.valid_mesh());
  ASSERT_EQ(status.interfaces.size(), 1u);
  EXPECT_LE(status.interfaces[0].deviation.maximum, .1);
  const auto between = interfaces(mesh);
  for (const auto& face : between.begin()->second)
    for (int v : face)
      EXPECT_NEAR(mesh.points[v].z(), height(mesh.points[v].x(), mesh.points[v].y()), tolerance) << v;
  // the outside is where it was
  const auto is_outside = mesh.complex().is_on_boundary;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (is_outside[v]) {
      const Point& p = mesh.points[v];
      double nearest = 1;
      for (double x : {p.x(), p.y(), p.z()}) {
        EXPECT_NEAR(x, 3, 3.1) << v;
        nearest = (std::min)(nearest, 3 - std::abs(x - 3));
      }
      EXPECT_LE(nearest, .1) << v;
    }
}

TEST(References_of_interfaces, are_what_interfaces_are_brought_to)
{
  for (const auto height : {wave, slope})
    for (double half : {4., 2.6}) { // out of the block, and not up to its sides
      SCOPED_TRACE(std::to_string(height == wave) + ' ' + std::to_string(half));
      const double tolerance = half > 3 ? .1 : .15; // where it ends, it goes on straight
      const Soup soup = surface_over(half, height);
      Labelled_mesh mesh = voxels_below(height), again = mesh;
      const Surface_mesh outside = surface_of(mesh);
      const std::map<std::pair<int, int>, Surface_mesh> surfaces{{{2, 1}, as_mesh(soup)}};
      const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra,
                                                    regions_of(mesh).interface_references(surfaces));
      EXPECT_GE(status.after.minimum, .6);
      expect_interface_on(mesh, status, height, tolerance);
      // with a reference of the outside, and as a soup
      const std::vector<std::pair<std::array<int, 2>, Soup>> soups{{{{1, 2}}, soup}};
      const Status of_both = CGAL::optimize_hex_mesh(again.points, again.hexahedra, outside,
                                                     regions_of(again).interface_references(soups));
      EXPECT_GE(of_both.after.minimum, .6);
      expect_interface_on(again, of_both, height, tolerance);
    }
}

// Pairs of labels without one keep their interface, also where it ends at one that moves.
TEST(References_of_interfaces, leave_the_others_where_they_are)
{
  Labelled_mesh mesh = voxels_below([](double, double) { return 3.; });
  mesh.label([](const Point& p) { return p.z() < 3 ? 1 : p.x() < 3 ? 2 : 3; });
  const std::map<std::pair<int, int>, Soup> surfaces{{{1, 2}, surface_over(4, [](double, double) { return 3.3; })},
                                                     {{1, 3}, surface_over(4, [](double, double) { return 3.3; })}};
  const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra,
                                                regions_of(mesh).interface_references(surfaces));
  EXPECT_TRUE(status.valid_mesh());
  EXPECT_GE(status.after.minimum, .8);
  ASSERT_EQ(status.interfaces.size(), 3u);
  for (const auto& i : status.interfaces)
    EXPECT_LE(i.deviation.maximum, .1);
  const auto between = interfaces(mesh);
  for (const auto& [labels, faces] : between)
    for (const auto& face : faces)
      for (int v : face)
        EXPECT_NEAR(labels[0] == 1 ? mesh.points[v].z() - 3.3 : mesh.points[v].x() - 3, 0, .1) << v;
}

// With a fixed outer boundary, all but the rim is brought to the surface.
TEST(References_of_interfaces, are_followed_within_a_fixed_boundary)
{
  Labelled_mesh mesh = voxels_below([](double, double) { return 3.; });
  const Labelled_mesh input = mesh;
  const std::map<std::pair<int, int>, Soup> surfaces{{{1, 2}, surface_over(4, wave)}};
  const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra,
                                                regions_of(mesh).interface_references(surfaces).fixed_boundary(true));
  EXPECT_TRUE(status.valid_mesh());
  EXPECT_GE(status.after.minimum, .5);
  const auto is_outside = mesh.complex().is_on_boundary;
  const auto between = interfaces(mesh);
  for (const auto& face : between.begin()->second)
    for (int v : face) {
      const Point& p = mesh.points[v];
      if (is_outside[v]) {
        EXPECT_TRUE(same_bits(p, input.points[v])) << v;
      }
      else {
        EXPECT_NEAR(p.z(), wave(p.x(), p.y()), .1) << v;
      }
    }
}

TEST(References_of_interfaces, that_do_not_fit_are_refused)
{
  Labelled_mesh mesh = voxels_below(wave);
  const Labelled_mesh intact = mesh;
  const auto refusal = [&](std::vector<std::pair<std::array<int, 2>, Soup>> surfaces) {
    try {
      CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, regions_of(mesh).interface_references(surfaces));
    }
    catch (const HMO::Input_error& error) {
      EXPECT_TRUE(same_points(mesh.points, intact.points));
      return std::string(error.what());
    }
    return std::string();
  };
  const Soup soup = surface_over(4, wave);
  EXPECT_EQ(refusal({{{{1, 3}}, soup}}), "there is no interface for the reference surface between labels 1 and 3");
  EXPECT_EQ(refusal({{{{1, 2}}, soup}, {{{2, 1}}, soup}}), "there are two references for the labels 2 and 1");
  EXPECT_EQ(refusal({{{{1, 2}}, Soup()}}), "the reference surface between labels 1 and 2 is empty");
  EXPECT_NE(refusal({{{{1, 2}}, surface_over(4, [](double, double) { return 1000.; })}}).find("is far away"),
            std::string::npos);
  Soup open = soup;
  open.second[5] = {0, 1, 100000};
  EXPECT_EQ(
    refusal({{{{1, 2}}, open}}),
    "triangle 5 of the reference surface has a vertex that is not one of its 625 points for the labels 1 and 2");
}

TEST(References_of_interfaces, are_those_of_ranges_for_a_linear_cell_complex)
{
  Complex_and_ranges both(voxels_below(wave));
  const std::map<std::pair<int, int>, Soup> surfaces{{{1, 2}, surface_over(4, wave)}};
  const Status status = CGAL::optimize_hex_mesh(both.lcc, both.parameters_of_complex().interface_references(surfaces));
  CGAL::optimize_hex_mesh(both.ranges.points, both.ranges.hexahedra,
                          regions_of(both.ranges).interface_references(surfaces));
  both.expect_the_same();
  expect_interface_on(both.ranges, status, wave, .1);
}

// --- Periodic pairs ------------------------------------------------------------------------------

using Translation = Indexed_mesh::Kernel::Vector_3;
using Pairs = std::vector<std::tuple<std::size_t, std::size_t, Translation>>;

struct Periodic_block
{
  Labelled_mesh mesh;
  Pairs pairs; // along x and y
};

// A wavy block with sides that are the same, and an interior and a boundary that are not
Periodic_block periodic_block(std::size_t nx, unsigned seed, double edges)
{
  Periodic_block block;
  Labelled_mesh& mesh = block.mesh;
  const double x = double(nx), y = 4;
  HMO::make_block(mesh.points, mesh.hexahedra, {{nx, 4, 4}}, {{x, y, 4}});
  std::map<Point, std::size_t> vertex;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    vertex[mesh.points[v]] = v;
  for (const auto& [p, v] : vertex) {
    if (p.x() == 0)
      block.pairs.emplace_back(v, vertex.at(Point(x, p.y(), p.z())), Translation(x, 0, 0));
    if (p.y() == y)
      block.pairs.emplace_back(v, vertex.at(Point(p.x(), 0, p.z())), Translation(0, -y, 0));
  }
  mesh.bend([&](const Point& p) {
    const double a = 2 * CGAL_PI * p.x() / x, b = 2 * CGAL_PI * p.y() / y;
    return Point(p.x() + .3 * std::sin(b) * std::sin(p.z()), p.y() + .2 * std::sin(a), p.z() + .4 * std::sin(a + b));
  });
  scramble_within_regions(mesh, seed, edges);
  for (const auto& [a, b, t] : block.pairs) // sines of a turn are not 0
    mesh.points[b] = mesh.points[a] + t;
  for (const auto& [a, b, t] : block.pairs)
    mesh.points[b] = mesh.points[a] + t;
  return block;
}

TEST(Periodic_pairs, move_together)
{
  for (const std::size_t nx : {4, 1}) // one hexahedron has both
    for (unsigned seed = 0; seed < 2; ++seed)
      for (const bool on_surface : {false, true})
        for (const HMO::Method method : {HMO::Method::FULL, HMO::Method::RECTIFICATION, HMO::Method::MAXIMIZATION}) {
          SCOPED_TRACE(std::to_string(nx) + ' ' + std::to_string(seed) + ' ' + std::to_string(on_surface) + ' ' +
                       std::to_string(int(method)));
          const Periodic_block input = periodic_block(nx, seed, nx > 1 ? .8 : 0);
          Labelled_mesh mesh = input.mesh;
          const auto np = params::optimization_method(method).boundary_placement(
            on_surface ? HMO::Boundary_placement::ON_SURFACE : HMO::Boundary_placement::WITHIN_TOLERANCE);
          const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, np.periodic_vertices(input.pairs));
          EXPECT_TRUE(status.valid_mesh());
          int moved = 0;
          for (const auto& [a, b, t] : input.pairs) {
            EXPECT_EQ(mesh.points[b], mesh.points[a] + t) << a << ' ' << b;
            moved += !same_bits(mesh.points[a], input.mesh.points[a]);
          }
          expect_never_worse(input.mesh, mesh);
          if (method != HMO::Method::FULL || (nx == 1 && on_surface)) // which is as good as it can be
            continue;
          EXPECT_GT(moved, 4);
          // the pairs are what does it
          Labelled_mesh without = input.mesh;
          const Status of_it = CGAL::optimize_hex_mesh(without.points, without.hexahedra, np);
          int apart = 0;
          for (const auto& [a, b, t] : input.pairs)
            apart += CGAL::squared_distance(without.points[b], without.points[a] + t) > 1e-12;
          EXPECT_GT(apart, 4);
          EXPECT_GE(status.after.minimum, .8 * of_it.after.minimum);
        }
}

TEST(Periodic_pairs, of_a_linear_cell_complex_are_in_its_order)
{
  Periodic_block block = periodic_block(4, 1, .8);
  block.mesh.labels.assign(block.mesh.hexahedra.size(), 0);
  Complex_and_ranges both(block.mesh);
  std::map<Point, std::size_t> vertex;
  for (std::size_t v = 0; v < both.ranges.points.size(); ++v)
    vertex[both.ranges.points[v]] = v;
  Pairs pairs;
  for (const auto& [a, b, t] : block.pairs)
    pairs.emplace_back(vertex.at(block.mesh.points[a]), vertex.at(block.mesh.points[b]), t);
  const Status status = CGAL::optimize_hex_mesh(both.lcc, params::periodic_vertices(pairs));
  EXPECT_TRUE(status.valid_mesh());
  CGAL::optimize_hex_mesh(both.ranges.points, both.ranges.hexahedra, params::periodic_vertices(pairs));
  both.expect_the_same();
  for (const auto& [a, b, t] : pairs)
    EXPECT_EQ(both.ranges.points[b], both.ranges.points[a] + t) << a << ' ' << b;
}

// One that does not move holds the other.
TEST(Periodic_pairs, are_held_by_one_that_is_fixed)
{
  const Periodic_block input = periodic_block(4, 1, .8);
  Labelled_mesh mesh = input.mesh;
  std::vector<char> is_frozen(mesh.points.size(), false);
  for (std::size_t i = 0; i < input.pairs.size(); i += 3)
    is_frozen[i % 2 ? std::get<0>(input.pairs[i]) : std::get<1>(input.pairs[i])] = true;
  const Status status = CGAL::optimize_hex_mesh(
    mesh.points, mesh.hexahedra,
    params::periodic_vertices(input.pairs).vertex_is_constrained_map(Marked_vertices{&is_frozen}));
  EXPECT_TRUE(status.valid_mesh());
  for (std::size_t i = 0; i < input.pairs.size(); ++i) {
    const auto& [a, b, t] = input.pairs[i];
    EXPECT_EQ(mesh.points[b], mesh.points[a] + t);
    if (is_frozen[a] || is_frozen[b]) {
      EXPECT_TRUE(same_bits(mesh.points[a], input.mesh.points[a]));
      EXPECT_TRUE(same_bits(mesh.points[b], input.mesh.points[b]));
    }
  }
}

TEST(Periodic_pairs, that_are_none_are_refused)
{
  Periodic_block block = periodic_block(4, 1, .8);
  const auto refusal = [&](std::size_t i, const Pairs::value_type& pair) {
    Pairs pairs = block.pairs;
    pairs[i] = pair;
    try {
      CGAL::optimize_hex_mesh(block.mesh.points, block.mesh.hexahedra, params::periodic_vertices(pairs));
    }
    catch (const HMO::Input_error& error) {
      EXPECT_EQ(error.element(), HMO::Input_error::Element::PARAMETER);
      EXPECT_EQ(error.element_index(), i);
      return std::string(error.what());
    }
    return std::string();
  };
  const auto [a, b, t] = block.pairs[5];
  EXPECT_EQ(refusal(5, {a, 100000, t}), "periodic pair 5 refers to a vertex that does not exist");
  EXPECT_EQ(refusal(5, {a, b, t / 0.}), "the translation of periodic pair 5 is not finite");
  EXPECT_EQ(refusal(5, {a, b, 1.25 * t}).substr(0, 80),
            ("vertex " + std::to_string(b) + " is not where the translation takes vertex " + std::to_string(a) +
             ", but 1 away")
              .substr(0, 80));
}

} // namespace
