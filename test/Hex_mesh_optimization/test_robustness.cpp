// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The result does not depend on how bad the input was: from a corrupted mesh comes
// almost the quality that comes from the intact one.

#include <CGAL/optimize_hex_mesh.h>

#include "mesh_families.h"

#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using Point = Indexed_mesh::Point;
using Surface_mesh = CGAL::Surface_mesh<Point>;
using HMO::Status;

struct Corruption
{
  const char* name;
  void (*apply)(Indexed_mesh&, std::uint64_t seed);
  bool moves_boundary; // which then cannot be its own reference
};

std::ostream& operator<<(std::ostream& os, const Corruption& corruption) { return os << corruption.name; }

const Corruption corruptions[] = {
  {"scrambled", [](Indexed_mesh& m, std::uint64_t seed) { HMO::scramble_interior(m.points, m.hexahedra, seed); },
   false},
  {"rotated", [](Indexed_mesh& m, std::uint64_t seed) { HMO::rotate_hexahedra(m.points, m.hexahedra, seed, .3); },
   false},
  {"jittered", [](Indexed_mesh& m, std::uint64_t seed) { HMO::jitter_boundary(m.points, m.hexahedra, seed, .2); },
   true}};

class Robustness : public ::testing::TestWithParam<std::tuple<Mesh_family, Corruption>>
{};

std::string case_name(const ::testing::TestParamInfo<std::tuple<Mesh_family, Corruption>>& info)
{
  return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param).name;
}

INSTANTIATE_TEST_SUITE_P(Families, Robustness,
                         ::testing::Combine(::testing::ValuesIn(mesh_families()), ::testing::ValuesIn(corruptions)),
                         case_name);

TEST_P(Robustness, the_quality_of_the_intact_mesh_is_recovered)
{
  // what is scrambled or turned does not find back to every one of its lengths, and stays within its boundary where it is
  // good enough there
  const double lost_minimum = .12, lost_average = .09;
  const Corruption corruption = std::get<1>(GetParam());
  Indexed_mesh intact = std::get<0>(GetParam())();
  Surface_mesh surface;
  using Vertex = Surface_mesh::Vertex_index;
  for_boundary(
    intact, [&](const Point& p) { return surface.add_vertex(p); },
    [&](Vertex a, Vertex b, Vertex c) { surface.add_face(a, b, c); });
  const auto optimize = [&](Indexed_mesh& mesh) {
    return corruption.moves_boundary ? CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface)
                                     : CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra);
  };
  const Indexed_mesh given = intact;
  const Status expected = optimize(intact);
  ASSERT_TRUE(expected.valid_mesh());
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Indexed_mesh mesh = given;
    corruption.apply(mesh, seed);
    const Status status = optimize(mesh);
    EXPECT_TRUE(status.valid_mesh()) << status.after.number_of_invalid << " invalid, of which inverted "
                                     << status.after.number_of_inverted << "; before "
                                     << status.before.number_of_inverted;
    EXPECT_GE(status.after.minimum, expected.after.minimum - lost_minimum);
    EXPECT_GE(status.after.average, expected.after.average - lost_average);
  }
}

} // namespace
