// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/optimize_hex_mesh_file.h>

#include <CGAL/Hex_mesh_optimization/IO/vtu.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/quality.h>
#include <CGAL/optimize_hex_mesh.h>

#include <CGAL/Simple_cartesian.h>

#include "Folder_test.h"
#include "raw_vtu.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace fs = std::filesystem;
using Point = CGAL::Simple_cartesian<double>::Point_3;

using Mesh = test::Labelled_mesh;
using test::tangled_ball;

class Parts : public test::Folder_test
{
protected:
  void write(const Mesh& mesh) const { test::write_raw_vtu(file("in.vtu"), mesh.points, mesh.hexahedra, mesh.labels); }

  static HMO::Mesh_division division(int number_of_parts)
  {
    HMO::Mesh_division result;
    result.number_of_parts = number_of_parts;
    return result;
  }

  Mesh output() const
  {
    Mesh mesh;
    CGAL::IO::read_vtu_hex_mesh(file("out.vtu"), mesh.points, mesh.hexahedra);
    return mesh;
  }
};

Mesh block(std::size_t n)
{
  Mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{n, n, n}});
  return mesh;
}

TEST_F(Parts, A_tangled_ball_becomes_about_as_good_in_four_parts_as_in_one_piece)
{
  Mesh whole = tangled_ball(10);
  write(whole);
  const HMO::Status in_parts = CGAL::optimize_hex_mesh_file(file("in.vtu"), file("out.vtu"), division(4));
  const HMO::Status in_one_piece = CGAL::optimize_hex_mesh(whole.points, whole.hexahedra);
  EXPECT_GT(in_parts.before.number_of_inverted, 0u);
  EXPECT_TRUE(in_parts.valid_mesh());
  EXPECT_NEAR(in_parts.after.minimum, in_one_piece.after.minimum, .03);
  EXPECT_NEAR(in_parts.after.average, in_one_piece.after.average, .01);
  EXPECT_LT(in_parts.deviation.maximum, 1.2 * in_one_piece.deviation.maximum + 1e-12);
}

TEST_F(Parts, The_status_says_of_the_output_what_measuring_it_does)
{
  const Mesh input = tangled_ball(6);
  write(input);
  const HMO::Status status = CGAL::optimize_hex_mesh_file(file("in.vtu"), file("out.vtu"), division(3));
  const HMO::Quality_statistics before = input.statistics(), after = output().statistics();
  for (const auto& [found, expected] : {std::pair(&status.before, &before), std::pair(&status.after, &after)}) {
    EXPECT_EQ(found->number_of_hexahedra, expected->number_of_hexahedra);
    EXPECT_EQ(found->number_of_inverted, expected->number_of_inverted);
    EXPECT_EQ(found->number_of_invalid, expected->number_of_invalid);
    EXPECT_EQ(found->minimum, expected->minimum);
    EXPECT_EQ(found->minimum_with_center, expected->minimum_with_center);
    EXPECT_NEAR(found->average, expected->average, 1e-12);
    EXPECT_NEAR(found->standard_deviation, expected->standard_deviation, 1e-6);
    EXPECT_NEAR(found->median_edge_ratio, expected->median_edge_ratio, 1e-6 * expected->median_edge_ratio);
    EXPECT_NEAR(found->edge_ratio_99, expected->edge_ratio_99, 1e-6 * expected->edge_ratio_99);
    EXPECT_EQ(found->maximum_edge_ratio, expected->maximum_edge_ratio);
  }
  EXPECT_NEAR(status.volume_before, 4.1, .2);
  EXPECT_NEAR(status.volume_after, status.volume_before, .05);
}

TEST_F(Parts, Everything_but_coordinates_of_the_file_stays)
{
  Mesh input = tangled_ball(6);
  input.labels.assign(input.hexahedra.size(), 7);
  write(input);
  const std::string before = bytes("in.vtu");
  CGAL::optimize_hex_mesh_file(file("in.vtu"), file("out.vtu"), division(2));
  const std::string after = bytes("out.vtu");
  EXPECT_TRUE(bytes("in.vtu") == before);
  ASSERT_EQ(after.size(), before.size());
  const std::size_t data = before.find("\n_") + 2 + 8, end = data + 24 * input.points.size();
  EXPECT_TRUE(after.substr(0, data) == before.substr(0, data));
  EXPECT_FALSE(after.substr(data, end - data) == before.substr(data, end - data));
  EXPECT_TRUE(after.substr(end) == before.substr(end));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2) << "no temporary files";
}

TEST_F(Parts, The_output_may_be_the_input)
{
  write(tangled_ball(6));
  CGAL::optimize_hex_mesh_file(file("in.vtu"), file("out.vtu"), division(2));
  CGAL::optimize_hex_mesh_file(file("in.vtu"), file("in.vtu"), division(2));
  EXPECT_TRUE(bytes("in.vtu") == bytes("out.vtu"));
}

TEST_F(Parts, Hexahedra_that_are_inverted_in_four_parts_at_once_are_untangled)
{
  Mesh mesh = block(8);
  const Point center(.5, .5, .5);
  for (Point& p : mesh.points)
    if (p == center)
      p = Point(.81, .77, .83);
  write(mesh);
  const HMO::Status status = CGAL::optimize_hex_mesh_file(file("in.vtu"), file("out.vtu"), division(4));
  EXPECT_GT(status.before.number_of_inverted, 1u);
  EXPECT_EQ(status.after.number_of_invalid, 0u);
  EXPECT_GT(status.after.minimum, .95);
}

TEST_F(Parts, A_valid_mesh_does_not_get_worse)
{
  Mesh mesh = block(6);
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 3, .2);
  write(mesh);
  const HMO::Status status = CGAL::optimize_hex_mesh_file(file("in.vtu"), file("out.vtu"), division(5));
  EXPECT_EQ(status.before.number_of_invalid, 0u);
  EXPECT_EQ(status.after.number_of_invalid, 0u);
  EXPECT_GE(status.after.minimum, status.before.minimum);
  EXPECT_GT(status.after.average, .99);
}

TEST_F(Parts, An_interface_through_all_parts_stays_where_it_is)
{
  Mesh mesh = block(8);
  for (Point& p : mesh.points)
    p = Point(p.x(), p.y(), p.z() + .05 * p.x() * p.y());
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 5, .5);
  // the interface is on a plane of the lattice
  Mesh straight = block(8);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (straight.points[v].z() == .5)
      mesh.points[v] = Point(straight.points[v].x(), straight.points[v].y(),
                             .5 + .05 * straight.points[v].x() * straight.points[v].y());
  for (const auto& h : mesh.hexahedra)
    mesh.labels.push_back(straight.points[h[4]].z() > .5 && straight.points[h[0]].z() >= .5 ? 5 : 2);
  write(mesh);
  const HMO::Status status = CGAL::optimize_hex_mesh_file(file("in.vtu"), file("out.vtu"), division(4));
  EXPECT_GT(status.before.number_of_inverted, 0u);
  EXPECT_TRUE(status.valid_mesh());
  ASSERT_EQ(status.interfaces.size(), 1u);
  EXPECT_EQ(status.interfaces[0].labels, (std::array<int, 2>{2, 5}));
  EXPECT_EQ(status.interfaces[0].number_of_faces, 64u);
  EXPECT_LT(status.interfaces[0].deviation.maximum, .1 / 8);
  ASSERT_EQ(status.regions.size(), 2u);
  EXPECT_NEAR(status.regions[0].before, .5, 1e-9);
  EXPECT_NEAR(status.regions[0].after, status.regions[0].before, 1e-3);
}

TEST_F(Parts, A_bound_of_the_deviation_is_certified_over_all)
{
  write(tangled_ball(8));
  const HMO::Status status = CGAL::optimize_hex_mesh_file(file("in.vtu"), file("out.vtu"), division(4),
                                                          CGAL::parameters::maximum_deviation(.01));
  EXPECT_TRUE(status.valid_mesh());
  EXPECT_LE(status.deviation.certified, .01);
  EXPECT_LE(status.deviation.maximum, status.deviation.certified);
}

TEST_F(Parts, A_fixed_boundary_stays)
{
  const Mesh input = tangled_ball(6);
  write(input);
  const HMO::Status status = CGAL::optimize_hex_mesh_file(file("in.vtu"), file("out.vtu"), division(3),
                                                          CGAL::parameters::fixed_boundary(true));
  EXPECT_LT(status.deviation.maximum, 1e-12);
  EXPECT_TRUE(status.valid_mesh());
}

TEST_F(Parts, A_mesh_that_is_inside_out_all_over_is_optimized)
{
  Mesh mesh = tangled_ball(6);
  for (auto& h : mesh.hexahedra)
    std::swap_ranges(h.begin(), h.begin() + 4, h.begin() + 4);
  write(mesh);
  const HMO::Status status = CGAL::optimize_hex_mesh_file(file("in.vtu"), file("out.vtu"), division(3));
  EXPECT_TRUE(status.valid_mesh());
  EXPECT_EQ(output().hexahedra, mesh.hexahedra);
}

TEST_F(Parts, Hexahedra_that_disagree_which_way_is_out_are_named)
{
  Mesh mesh = block(4);
  std::swap_ranges(mesh.hexahedra[21].begin(), mesh.hexahedra[21].begin() + 4, mesh.hexahedra[21].begin() + 4);
  write(mesh);
  try {
    CGAL::optimize_hex_mesh_file(file("in.vtu"), file("out.vtu"), division(2));
    FAIL();
  }
  catch (const HMO::Input_error& error) {
    EXPECT_NE(std::string(error.what()).find(" 21 "), std::string::npos) << error.what();
  }
  EXPECT_FALSE(fs::exists(file("out.vtu")));
}

TEST_F(Parts, Other_kinds_of_files_are_refused)
{
  const Mesh mesh = block(2);
  CGAL::IO::write_vtu_hex_mesh(file("in.vtu"), mesh.points, mesh.hexahedra);
  try {
    CGAL::optimize_hex_mesh_file(file("in.vtu"), file("out.vtu"), division(2));
    FAIL();
  }
  catch (const CGAL::IO::Hex_mesh_file_error& error) {
    EXPECT_NE(std::string(error.what()).find("raw appended data"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(fs::exists(file("out.vtu")));
}

TEST_F(Parts, When_time_is_over_the_best_mesh_so_far_is_written)
{
  const Mesh input = tangled_ball(8);
  write(input);
  const HMO::Status status = CGAL::optimize_hex_mesh_file(file("in.vtu"), file("out.vtu"), division(4),
                                                          CGAL::parameters::maximum_running_time(.3));
  EXPECT_EQ(status.return_code, HMO::Return_code::TIME_LIMIT);
  EXPECT_LE(output().statistics().number_of_inverted, input.statistics().number_of_inverted);
}

TEST(Mesh_division, Less_memory_makes_more_parts)
{
  HMO::Mesh_division division;
  EXPECT_EQ(division.number_of_parts_of(1000000), 1);
  division.maximum_memory = std::size_t(4) << 30;
  const int few = division.number_of_parts_of(4000000);
  division.maximum_memory = std::size_t(1) << 30;
  EXPECT_GT(few, 1);
  EXPECT_GT(division.number_of_parts_of(4000000), few);
  division.number_of_parts = 5;
  EXPECT_EQ(division.number_of_parts_of(4000000), 5);
}

} // namespace
