// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random parts that overlap, touch or coincide, written badly: what is made of them has the volume, the bodies and the
// topology of their exact union, or is refused with a reason.
// test_random_surfaces FIRST_SEED NUMBER does the same with other seeds, and prints each.

#include "Random_parts.h"

#include <CGAL/Hex_mesh_optimization/internal/meshing/Solid_of_surface.h>
#include <CGAL/make_hex_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

struct Case
{
  Union_of_parts exact;
  std::vector<Reference_input> parts; // as written
  Reference_input soup;               // of all

  explicit Case(unsigned seed)
  {
    Random_number random(seed);
    const std::vector<Reference_input> given = random_parts(random);
    exact = union_of(given);
    const Matrix_3 rotation = random.rotation();
    const bool rounds = random.integer(0, 1) == 0;
    for (const Reference_input& part : given) {
      parts.push_back(written_badly(part, rotation, random, rounds));
      append(soup, parts.back());
    }
  }
};

struct Mesh
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
};

std::vector<Point> points_of(const Reference_input& soup)
{
  std::vector<Point> result;
  for (const Vector_3& p : soup.points)
    result.emplace_back(p[0], p[1], p[2]);
  return result;
}

HMO::Meshing_status meshed(const Case& c, std::size_t number, Mesh& mesh)
{
  return CGAL::make_hex_mesh(points_of(c.soup), c.soup.triangles, mesh.points, mesh.hexahedra,
                             CGAL::parameters::number_of_hexahedra(number));
}

TEST(random_surfaces, bound_what_corefinement_finds_or_are_refused_with_a_reason)
{
  int refused = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const Case c(seed);
    if (!c.exact.is_known)
      continue;
    try {
      const Solid_of_surface solid(c.soup, 1e5, 0);
      EXPECT_NEAR(solid.report.volume, c.exact.volume, 1e-4 * c.exact.volume);
      EXPECT_EQ(solid.report.number_of_bodies, c.exact.number_of_bodies);
      EXPECT_EQ(solid.report.euler_characteristic, c.exact.euler_characteristic);
    }
    catch (const HMO::Input_error& error) {
      EXPECT_GT(std::string(error.what()).size(), 20u);
      ++refused;
    }
  }
  EXPECT_LE(refused, 2);
}

// Nothing, or what is wrong with the mesh.
std::string fault(const Case& c, const HMO::Meshing_status& status)
{
  if (!status.valid_mesh())
    return "invalid";
  if (!(std::abs(status.volume_after - c.exact.volume) <= .01 * c.exact.volume))
    return "volume";
  if (status.number_of_bodies != c.exact.number_of_bodies)
    return "bodies";
  if (status.euler_characteristic != c.exact.euler_characteristic)
    return "topology";
  return "";
}

TEST(random_surfaces, have_a_mesh_that_matches_their_union)
{
  const Case c(1);
  Mesh mesh;
  EXPECT_EQ(fault(c, meshed(c, 500, mesh)), "");
}

void print(unsigned seed)
{
  const Case c(seed);
  std::cout << "seed " << seed << ": " << c.parts.size() << " parts, " << std::flush;
  if (!c.exact.is_known) {
    std::cout << "the judge has no result\n";
    return;
  }
  try {
    Mesh mesh;
    const HMO::Meshing_status status = meshed(c, 4000, mesh);
    const std::string wrong = fault(c, status);
    std::cout << status.after.number_of_hexahedra << " hexahedra, minimum " << status.after.minimum << ", average "
              << status.after.average << ", volume " << status.volume_after << " of " << c.exact.volume << ", bodies "
              << status.number_of_bodies << " of " << c.exact.number_of_bodies << ", Euler characteristic "
              << status.euler_characteristic << " of " << c.exact.euler_characteristic << ", " << status.total_seconds
              << " s"
              << (wrong.empty() ? "" : (status.matches_surface() ? ": WRONG, UNSAID: " : ": wrong, and said: ") + wrong)
              << std::endl;
  }
  catch (const HMO::Input_error& error) {
    std::cout << "refused: " << error.what() << std::endl;
  }
}

} // namespace

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  if (argc != 3)
    return RUN_ALL_TESTS();
  for (int i = 0; i < std::atoi(argv[2]); ++i)
    print(static_cast<unsigned>(std::atoi(argv[1]) + i));
}
