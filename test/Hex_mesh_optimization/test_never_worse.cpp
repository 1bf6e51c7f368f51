// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What optimize_hex_mesh() guarantees for every input, over many generated ones: small meshes of all shapes, intact or
// damaged in any way, repairable or not, with all options that constrain the result. The measures are those of the
// public quality and validity functions on the mesh that is handed back, not those of the status.
// The environment variable NEVER_WORSE_CASES says how many inputs are generated for each shape and damage.

#include <CGAL/optimize_hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/quality.h>

#include "Marked_vertices.h"
#include "mesh_checks.h"
#include "mesh_families.h"

#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <ostream>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace params = CGAL::parameters;
using Point = Indexed_mesh::Point;
using Surface_mesh = CGAL::Surface_mesh<Point>;
using HMO::Method;
using HMO::Status;

// --- Small meshes ---------------------------------------------------------------------

const std::vector<Mesh_family> small_families = {
  {"block",
   [](Indexed_mesh& m) {
     HMO::make_block(m.points, m.hexahedra, {{3, 2, 3}}, {{3, 2, 3}});
   }},
  {"thin_block",
   [](Indexed_mesh& m) {
     HMO::make_block(m.points, m.hexahedra, {{4, 4, 3}}, {{4, 4, .1}});
   }},
  {"twisted_bar", [](Indexed_mesh& m) { HMO::make_bent_bar(m.points, m.hexahedra, 6, 2, 4, 1, 1, 1.5); }},
  {"cylinder", [](Indexed_mesh& m) { HMO::make_cylinder(m.points, m.hexahedra, 2, 2); }},
  {"ball", [](Indexed_mesh& m) { HMO::make_ball(m.points, m.hexahedra, 2); }},
  {"plate_with_hole", [](Indexed_mesh& m) { HMO::make_plate_with_hole(m.points, m.hexahedra, 2, 2, 4, 1, 1.5); }},
  {"l_shape", [](Indexed_mesh& m) { HMO::make_l_shape(m.points, m.hexahedra, 2); }},
  {"ring", [](Indexed_mesh& m) { HMO::make_ring(m.points, m.hexahedra, 8, 2); }}};

// --- Damages ----------------------------------------------------------------------------

template <class Move>
void move_all(Indexed_mesh& mesh, const Move& move)
{
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    mesh.points[v] = move(mesh.points[v], v);
}

// Every vertex anywhere in a cube around its place
void add_noise(Indexed_mesh& mesh, std::uint64_t seed, double edges)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double size = edges * mesh.mean_edge_length();
  move_all(mesh, [&](const Point& p, std::size_t) {
    const double x = p.x() + size * uniform(random), y = p.y() + size * uniform(random);
    return Point(x, y, p.z() + size * uniform(random));
  });
}

struct Damage
{
  const char* name;
  void (*apply)(Indexed_mesh&, std::uint64_t seed);
};

std::ostream& operator<<(std::ostream& os, const Damage& damage) { return os << damage.name; }

const std::vector<Damage> damages = {
  {"intact", [](Indexed_mesh&, std::uint64_t) {}},
  {"slightly_noisy", [](Indexed_mesh& m, std::uint64_t seed) { add_noise(m, seed, .1); }},
  {"noisy", [](Indexed_mesh& m, std::uint64_t seed) { add_noise(m, seed, .3); }},
  {"chaotic", [](Indexed_mesh& m, std::uint64_t seed) { add_noise(m, seed, 3); }},
  {"scrambled", [](Indexed_mesh& m, std::uint64_t seed) { HMO::scramble_interior(m.points, m.hexahedra, seed); }},
  {"rotated", [](Indexed_mesh& m, std::uint64_t seed) { HMO::rotate_hexahedra(m.points, m.hexahedra, seed, .3); }},
  {"jittered", [](Indexed_mesh& m, std::uint64_t seed) { HMO::jitter_boundary(m.points, m.hexahedra, seed, .5); }},
  {"displaced", [](Indexed_mesh& m, std::uint64_t seed) { HMO::displace_vertex(m.points, m.hexahedra, seed); }},
  {"sheared",
   [](Indexed_mesh& m, std::uint64_t seed) {
     const double s = (1 + double(seed % 4)) / 2; // a reference of another size is refused
     move_all(m, [=](const Point& p, std::size_t) { return Point(p.x() + s * p.z(), p.y() - s * p.x(), p.z()); });
   }},
  {"squashed",
   [](Indexed_mesh& m, std::uint64_t seed) {
     const double s = std::ldexp(1., -4 - 6 * int(seed % 4));
     move_all(m, [=](const Point& p, std::size_t) { return Point(p.x(), p.y(), s * p.z()); });
   }},
  {"flat", [](Indexed_mesh& m,
              std::uint64_t) { move_all(m, [](const Point& p, std::size_t) { return Point(p.x(), p.y(), 0); }); }},
  {"mirrored_in_part",
   [](Indexed_mesh& m, std::uint64_t) {
     move_all(m, [](const Point& p, std::size_t) { return Point(p.x(), std::abs(p.y() - .7), p.z()); });
   }},
  {"collapsed_in_part",
   [](Indexed_mesh& m, std::uint64_t seed) {
     const Point q = m.points[seed % m.points.size()];
     move_all(m, [=](const Point& p, std::size_t v) { return (v + seed) % 5 == 0 ? q : p; });
   }},
  {"exchanged", [](Indexed_mesh& m, std::uint64_t seed) {
     std::swap(m.points[seed % m.points.size()], m.points[(7 * seed + 3) % m.points.size()]);
   }}};

// --- Options ------------------------------------------------------------------------------

struct Options
{
  Method method = Method::FULL;
  bool has_reference = false;
  bool fixed_boundary = false;
  bool has_fixed_vertices = false;
  double maximum_deviation = std::numeric_limits<double>::infinity(); // in mean edge lengths
  std::size_t iterations = 20;

  Options(std::uint64_t seed, const std::string& name) // other options for every name
  {
    std::seed_seq numbers(name.begin(), name.end());
    std::mt19937_64 random(numbers);
    random.discard(16 * seed);
    const auto one_in = [&](std::uint64_t n) { return random() % n == 0; };
    method = one_in(4) ? Method::RECTIFICATION : one_in(4) ? Method::MAXIMIZATION : Method::FULL;
    has_reference = one_in(2);
    fixed_boundary = one_in(4);
    has_fixed_vertices = one_in(3);
    if (one_in(3))
      maximum_deviation = std::ldexp(1., -int(random() % 12));
    if (one_in(4))
      iterations = random() % 4;
  }
};

std::ostream& operator<<(std::ostream& os, const Options& o)
{
  return os << "method " << int(o.method) << (o.has_reference ? ", reference" : "")
            << (o.fixed_boundary ? ", fixed boundary" : "") << (o.has_fixed_vertices ? ", fixed vertices" : "")
            << ", deviation " << o.maximum_deviation << ", iterations " << o.iterations;
}

// --- The guarantees -------------------------------------------------------------------------

struct Tally
{
  int cases = 0, valid_before = 0, valid_after = 0, improved = 0, bounded = 0;
};

void expect_guarantees(const Indexed_mesh& intact, const Damage& damage, std::uint64_t seed, const Options& options,
                       Tally& tally)
{
  Indexed_mesh mesh = intact;
  damage.apply(mesh, seed);
  const Indexed_mesh input = mesh;
  const auto complex = input.complex();
  std::vector<char> is_frozen(mesh.points.size(), false);
  if (options.has_fixed_vertices)
    for (std::size_t v = seed % 7; v < is_frozen.size(); v += 7)
      is_frozen[v] = true;
  const double length = input.mean_edge_length(), bound = options.maximum_deviation * length;
  const auto np = params::optimization_method(options.method)
                    .fixed_boundary(options.fixed_boundary)
                    .vertex_is_constrained_map(Marked_vertices{&is_frozen})
                    .maximum_deviation(bound)
                    .number_of_iterations(options.iterations);
  Surface_mesh surface;
  if (options.has_reference) {
    using Vertex = Surface_mesh::Vertex_index;
    for_boundary(
      intact, [&](const Point& p) { return surface.add_vertex(p); },
      [&](Vertex a, Vertex b, Vertex c) { surface.add_face(a, b, c); });
  }
  const auto optimize = [&](Indexed_mesh& m) {
    return options.has_reference ? CGAL::optimize_hex_mesh(m.points, m.hexahedra, surface, np)
                                 : CGAL::optimize_hex_mesh(m.points, m.hexahedra, np);
  };
  const Status status = optimize(mesh);
  ++tally.cases;

  // hexahedra that are inside out are measured with top and bottom exchanged
  Indexed_mesh before = input, after = mesh;
  EXPECT_EQ(mesh.hexahedra, input.hexahedra);
  for (Indexed_mesh* m : {&before, &after})
    for (std::size_t h : status.reoriented_hexahedra)
      std::swap_ranges(m->hexahedra[h].begin(), m->hexahedra[h].begin() + 4, m->hexahedra[h].begin() + 4);
  const HMO::Quality_statistics a = HMO::quality_statistics(before.points, before.hexahedra);
  const HMO::Quality_statistics b = HMO::quality_statistics(after.points, after.hexahedra);
  const std::vector<std::size_t> invalid = invalid_hexahedra(after);
  EXPECT_LE(b.number_of_inverted, a.number_of_inverted);
  if (invalid_hexahedra(before).empty()) {
    ++tally.valid_before;
    EXPECT_TRUE(invalid.empty());
    // angles protect no mesh that lies off its reference
    if (!options.has_reference && !std::isfinite(bound)) {
      EXPECT_GE(b.minimum, a.minimum);
    }
  }
  EXPECT_EQ(status.invalid_hexahedra, invalid);
  EXPECT_EQ(status.valid_mesh(), invalid.empty());
  EXPECT_EQ(status.after.minimum, b.minimum);
  EXPECT_EQ(status.after.number_of_inverted, b.number_of_inverted);
  tally.valid_after += invalid.empty();
  tally.improved += b.minimum > a.minimum;

  ASSERT_EQ(mesh.points.size(), input.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    for (int d = 0; d < 3; ++d)
      EXPECT_TRUE(std::isfinite(mesh.points[v][d]));
    if (is_frozen[v] || (options.fixed_boundary && complex.is_on_boundary[v])) {
      EXPECT_TRUE(same_bits(mesh.points[v], input.points[v])) << v;
    }
  }

  // a bound that the input obeys is only left for a hexahedron that becomes valid
  EXPECT_EQ(status.is_within_deviation_bound(), status.deviation.certified <= bound);
  if (std::isfinite(bound)) {
    Indexed_mesh unmoved = input;
    const std::vector<char> all(unmoved.points.size(), true);
    const auto hold = params::vertex_is_constrained_map(Marked_vertices{&all}).maximum_deviation(bound);
    const Status given = options.has_reference
                           ? CGAL::optimize_hex_mesh(unmoved.points, unmoved.hexahedra, surface, hold)
                           : CGAL::optimize_hex_mesh(unmoved.points, unmoved.hexahedra, hold);
    if (given.is_within_deviation_bound() && b.number_of_invalid >= a.number_of_invalid) {
      ++tally.bounded;
      EXPECT_TRUE(status.is_within_deviation_bound()) << status.deviation.certified << " of " << bound;
      if (invalid_hexahedra(before).empty()) {
        EXPECT_GE(b.minimum, a.minimum);
      }
    }
    const bool was_stopped = status.return_code == HMO::Return_code::TIME_LIMIT ||
                             status.return_code == HMO::Return_code::STOPPED_BY_VISITOR;
    EXPECT_TRUE(was_stopped || status.is_within_deviation_bound() !=
                                 (status.return_code == HMO::Return_code::DEVIATION_BOUND_NOT_MET));
  }
}

class Never_worse : public ::testing::TestWithParam<std::tuple<Mesh_family, Damage>>
{};

std::string case_name(const ::testing::TestParamInfo<std::tuple<Mesh_family, Damage>>& info)
{
  return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param).name;
}

INSTANTIATE_TEST_SUITE_P(Families, Never_worse,
                         ::testing::Combine(::testing::ValuesIn(small_families), ::testing::ValuesIn(damages)),
                         case_name);

TEST_P(Never_worse, whatever_the_options)
{
  const Indexed_mesh intact = std::get<0>(GetParam())();
  const Damage damage = std::get<1>(GetParam());
  Tally tally;
  const char* const given = std::getenv("NEVER_WORSE_CASES");
  const std::uint64_t number_of_cases = given ? std::strtoull(given, nullptr, 10) : 6;
  ASSERT_GT(number_of_cases, 0u);
  for (std::uint64_t seed = 0; seed < number_of_cases; ++seed) {
    const Options options(seed, case_name({GetParam(), 0}));
    std::ostringstream description;
    description << "seed " << seed << ", " << options;
    SCOPED_TRACE(description.str());
    expect_guarantees(intact, damage, seed, options, tally);
  }
  if (std::string(damage.name) == "intact") {
    EXPECT_EQ(tally.valid_before, tally.cases) << "the guarantee for valid meshes is tested";
  }
  RecordProperty("cases", tally.cases);
  RecordProperty("valid_before", tally.valid_before);
  RecordProperty("valid_after", tally.valid_after);
  RecordProperty("improved", tally.improved);
  RecordProperty("bounded", tally.bounded);
}

} // namespace
