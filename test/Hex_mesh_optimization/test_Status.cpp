// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Why an optimization stopped: each return code where it is true, and the times of the stages.

#include <CGAL/optimize_hex_mesh.h>

#include "mesh_families.h"

#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace params = CGAL::parameters;
using Point = Indexed_mesh::Point;
using Surface_mesh = CGAL::Surface_mesh<Point>;
using HMO::Method;
using HMO::Return_code;
using HMO::Status;

Indexed_mesh block(std::size_t n)
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{n, n, n}});
  return mesh;
}

Indexed_mesh scrambled(Indexed_mesh mesh)
{
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 1);
  return mesh;
}

Indexed_mesh scrambled_ball()
{
  Indexed_mesh mesh;
  HMO::make_ball(mesh.points, mesh.hexahedra, 3);
  return scrambled(mesh);
}

template <class NamedParameters>
Status optimized(Indexed_mesh mesh, const NamedParameters& np)
{
  return CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, np);
}

// What a block can be is soon reached
TEST(Return_code, is_converged_where_nothing_is_gained_any_more)
{
  for (Method method : {Method::FULL, Method::MAXIMIZATION}) {
    const Status status = optimized(scrambled(block(4)), params::optimization_method(method));
    EXPECT_EQ(status.return_code, Return_code::CONVERGED);
    EXPECT_TRUE(status.valid_mesh());
    EXPECT_GT(status.after.minimum, .999);
  }
}

TEST(Return_code, is_the_target_quality_where_that_is_reached)
{
  for (Method method : {Method::FULL, Method::RECTIFICATION, Method::MAXIMIZATION}) {
    const Status status = optimized(scrambled(block(4)), params::optimization_method(method).target_quality(.3));
    EXPECT_EQ(status.return_code, Return_code::TARGET_QUALITY_REACHED);
    EXPECT_GE(status.after.minimum, .3);
  }
}

// The same run, with fewer iterations and with enough of them
TEST(Return_code, is_the_iteration_limit_where_iterations_are_used_up)
{
  const auto run = [](std::size_t iterations) {
    return optimized(scrambled_ball(), params::optimization_method(Method::RECTIFICATION)
                                         .number_of_iterations(iterations)
                                         .number_of_restarts(0)
                                         .maximize_minimum_quality(false));
  };
  for (std::size_t iterations : {1, 2, 5}) {
    const Status status = run(iterations);
    EXPECT_EQ(status.return_code, Return_code::ITERATION_LIMIT);
    EXPECT_EQ(status.iterations, iterations);
  }
  const Status status = run(10000);
  EXPECT_EQ(status.return_code, Return_code::CONVERGED);
  EXPECT_LT(status.iterations, 10000u);
}

TEST(Return_code, is_the_time_limit_where_time_is_over)
{
  const Status status = optimized(scrambled_ball(), params::maximum_running_time(0));
  EXPECT_EQ(status.return_code, Return_code::TIME_LIMIT);
  EXPECT_EQ(status.iterations, 0u);
}

TEST(Return_code, is_that_of_the_visitor_where_it_asked_to_stop)
{
  struct Third
  {
    bool on_iteration(const HMO::Iteration&) { return ++calls < 3; }
    int calls = 0;
  };
  const Status status = optimized(scrambled_ball(), params::visitor(Third()));
  EXPECT_EQ(status.return_code, Return_code::STOPPED_BY_VISITOR);
  EXPECT_EQ(status.iterations, 3u);
}

TEST(Return_code, is_no_improvement_where_there_is_none)
{
  for (Method method : {Method::FULL, Method::RECTIFICATION, Method::MAXIMIZATION}) {
    const Status status = optimized(block(3), params::optimization_method(method).fixed_boundary(true));
    EXPECT_EQ(status.return_code, Return_code::NO_IMPROVEMENT);
    EXPECT_EQ(status.after.minimum, status.before.minimum);
  }
}

// A ball with a fixed boundary is no cube
TEST(Return_code, is_that_of_the_bound_of_the_deviation_where_it_is_not_met)
{
  Indexed_mesh ball;
  HMO::make_ball(ball.points, ball.hexahedra, 3);
  Surface_mesh cube;
  CGAL::make_hexahedron(Point(-1, -1, -1), Point(1, -1, -1), Point(1, 1, -1), Point(-1, 1, -1), Point(-1, 1, 1),
                        Point(-1, -1, 1), Point(1, -1, 1), Point(1, 1, 1), cube);
  CGAL::Polygon_mesh_processing::triangulate_faces(cube);
  for (double bound : {1e-3, 1.}) {
    Indexed_mesh mesh = ball;
    const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, cube,
                                                  params::fixed_boundary(true).maximum_deviation(bound));
    EXPECT_EQ(status.is_within_deviation_bound(), bound == 1);
    EXPECT_EQ(status.return_code == Return_code::DEVIATION_BOUND_NOT_MET, bound < 1);
    EXPECT_TRUE(status.valid_mesh());
  }
}

TEST(Status, has_time_for_those_stages_only_that_ran)
{
  struct Stages
  {
    bool on_iteration(const HMO::Iteration& i) { return has_run[static_cast<int>(i.stage)] = true; }
    bool has_run[3] = {};
  };
  for (Method method : {Method::FULL, Method::RECTIFICATION, Method::MAXIMIZATION}) {
    Stages stages;
    const Status status = optimized(scrambled_ball(), params::optimization_method(method).visitor(std::ref(stages)));
    const double seconds[3] = {status.rectification_seconds, status.untangling_seconds, status.maximization_seconds};
    for (int stage = 0; stage < 3; ++stage)
      EXPECT_EQ(seconds[stage] > 0, stages.has_run[stage]) << stage;
    EXPECT_LE(seconds[0] + seconds[1] + seconds[2], status.total_seconds);
  }
}

// Of two blocks, one is brought to a longer one.
TEST(Status, names_the_pieces_whose_volume_has_changed)
{
  Indexed_mesh mesh = block(3);
  const std::size_t hexahedra = mesh.hexahedra.size(), vertices = mesh.points.size();
  for (std::size_t v = 0; v < vertices; ++v)
    mesh.points.emplace_back(mesh.points[v].x() + 5, mesh.points[v].y(), mesh.points[v].z());
  for (std::size_t h = 0; h < hexahedra; ++h) {
    mesh.hexahedra.push_back(mesh.hexahedra[h]);
    for (std::size_t& v : mesh.hexahedra.back())
      v += vertices;
  }
  EXPECT_TRUE(optimized(mesh, params::default_values()).volume_changes.empty());

  Surface_mesh surface; // of the two, the second longer by a tenth
  for (double length : {0., 1.1}) {
    const double x = length > 0 ? 5 : 0, end = x + (length > 0 ? length : 1);
    CGAL::make_hexahedron(Point(x, 0, 0), Point(end, 0, 0), Point(end, 1, 0), Point(x, 1, 0), Point(x, 1, 1),
                          Point(x, 0, 1), Point(end, 0, 1), Point(end, 1, 1), surface);
  }
  CGAL::Polygon_mesh_processing::triangulate_faces(surface);
  const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface);
  ASSERT_EQ(status.volume_changes.size(), 1u);
  EXPECT_EQ(status.volume_changes[0].hexahedron, hexahedra);
  EXPECT_EQ(status.volume_changes[0].number_of_hexahedra, hexahedra);
  EXPECT_NEAR(status.volume_changes[0].before, 1, 1e-9);
  EXPECT_NEAR(status.volume_changes[0].after, 1.1, .01);
}

TEST(Status, has_all_iterations_in_its_attempts_and_ends_with_what_the_last_taken_one_has_led_to)
{
  for (const Indexed_mesh& mesh : {block(4), scrambled(block(4)), scrambled_ball()}) {
    const Status status = optimized(mesh, params::default_values());
    std::size_t iterations = 0;
    double minimum = status.before.minimum, seconds = 0;
    for (const HMO::Attempt& attempt : status.attempts) {
      EXPECT_FALSE(attempt.name.empty());
      iterations += attempt.iterations;
      seconds += attempt.seconds;
      if (attempt.is_taken)
        minimum = attempt.minimum;
    }
    EXPECT_EQ(iterations, status.iterations);
    EXPECT_LE(seconds, status.total_seconds);
    EXPECT_NEAR(minimum, status.after.minimum, 1e-9);
  }
}

// --- Which attempts are made ----------------------------------------------------------

std::vector<std::string> names(const Status& status)
{
  std::vector<std::string> result;
  for (const HMO::Attempt& attempt : status.attempts)
    result.push_back(attempt.name);
  return result;
}

bool has(const Status& status, const std::string& name)
{
  const std::vector<std::string> all = names(status);
  return std::find(all.begin(), all.end(), name) != all.end();
}

TEST(Attempts, leave_a_sound_boundary_where_it_is_and_end_with_what_is_good_there)
{
  for (std::size_t n : {3, 4}) {
    const Status status = optimized(scrambled(block(n)), params::default_values());
    ASSERT_FALSE(status.attempts.empty());
    EXPECT_EQ(status.attempts[0].name, "untangling within the boundary");
    EXPECT_TRUE(status.attempts[0].is_taken);
    EXPECT_FALSE(has(status, "rectification"));
    EXPECT_LT(status.deviation.maximum_relative, 1e-12);
  }
}

TEST(Attempts, take_feasible_steps_from_what_is_valid)
{
  Indexed_mesh mesh = block(4);
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 1, .3);
  const Status status = optimized(mesh, params::default_values());
  ASSERT_EQ(status.before.number_of_invalid, 0u);
  ASSERT_FALSE(status.attempts.empty());
  EXPECT_EQ(status.attempts[0].name, "interior point");
  EXPECT_TRUE(status.attempts[0].is_taken);
  EXPECT_GT(status.attempts[0].average, status.before.average);
  const Status bounded = optimized(mesh, params::maximum_deviation(1e-6));
  ASSERT_GE(bounded.attempts.size(), 2u);
  EXPECT_EQ(bounded.attempts[0].name, "interior point within the boundary");
  EXPECT_EQ(bounded.attempts[1].name, "interior point");
}

TEST(Attempts, begin_with_a_projection_where_the_mesh_is_off_its_reference)
{
  Surface_mesh longer; // than the mesh
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1.1, 0, 0), Point(1.1, 1, 0), Point(0, 1, 0), Point(0, 1, 1),
                        Point(0, 0, 1), Point(1.1, 0, 1), Point(1.1, 1, 1), longer);
  CGAL::Polygon_mesh_processing::triangulate_faces(longer);
  Indexed_mesh mesh = block(3);
  const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, longer);
  ASSERT_FALSE(status.attempts.empty());
  EXPECT_EQ(status.attempts[0].name, "projection");
}

TEST(Attempts, are_those_of_the_method)
{
  const Status rectified = optimized(scrambled(block(4)), params::optimization_method(Method::RECTIFICATION));
  EXPECT_EQ(names(rectified), std::vector<std::string>{"rectification"});
  const Status maximized = optimized(scrambled(block(4)), params::optimization_method(Method::MAXIMIZATION));
  EXPECT_EQ(names(maximized), (std::vector<std::string>{"untangling", "maximin"}));
}

TEST(Attempts, are_few_where_the_target_is_soon_reached)
{
  const Status status = optimized(block(4), params::target_quality(.5));
  for (const HMO::Attempt& attempt : status.attempts)
    EXPECT_EQ(attempt.iterations, 0u) << attempt.name;
}

} // namespace
