// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// An optimization that is ended, by the visitor or the time limit, ends at once, wherever it is, and gives the best
// state that it has shown. What is at once is counted in calls of the visitor, not measured.

#include <CGAL/optimize_hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/quality.h>
#include <CGAL/Hex_mesh_optimization/validity.h>

#include "mesh_families.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace params = CGAL::parameters;
using HMO::Iteration;
using HMO::Method;
using HMO::Return_code;
using HMO::Status;

constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

struct Recorder
{
  std::function<bool(const Iteration&)> goes_on;
  std::vector<Iteration> seen;

  bool on_iteration(const Iteration& iteration)
  {
    seen.push_back(iteration);
    return goes_on(iteration);
  }
};

Indexed_mesh tangled(const Mesh_family& family)
{
  Indexed_mesh mesh = family();
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 3);
  HMO::jitter_boundary(mesh.points, mesh.hexahedra, 3, .2);
  return mesh;
}

std::size_t number_of_invalid(const Indexed_mesh& mesh)
{
  std::vector<std::size_t> invalid;
  HMO::invalid_hexahedra(mesh.points, mesh.hexahedra, std::back_inserter(invalid));
  return invalid.size();
}

// No worse than the input and anything that the visitor saw, and what the status says
void expect_best(const Indexed_mesh& input, const Indexed_mesh& mesh, const Recorder& recorder, const Status& status)
{
  std::size_t least = HMO::quality_statistics(input.points, input.hexahedra).number_of_inverted;
  for (const Iteration& iteration : recorder.seen)
    least = (std::min)(least, iteration.number_of_inverted);
  EXPECT_LE(HMO::quality_statistics(mesh.points, mesh.hexahedra).number_of_inverted, least);
  EXPECT_EQ(status.iterations, recorder.seen.size());
  EXPECT_EQ(status.invalid_hexahedra.size(), number_of_invalid(mesh));
  if (number_of_invalid(input) == 0) {
    EXPECT_TRUE(status.valid_mesh());
  }
}

// The visitor ends the run in the given call.
Status optimize_until(std::size_t calls, Method method, Indexed_mesh& mesh, Recorder& recorder)
{
  recorder.goes_on = [&recorder, calls](const Iteration&) { return recorder.seen.size() < calls; };
  return CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra,
                                 params::optimization_method(method).visitor(std::ref(recorder)));
}

class Interruption : public ::testing::TestWithParam<Mesh_family>
{};

INSTANTIATE_TEST_SUITE_P(Families, Interruption,
                         ::testing::Values(mesh_families()[0], mesh_families()[3], mesh_families()[4],
                                           mesh_families()[7]),
                         Family_name());

TEST_P(Interruption, by_the_visitor_at_any_call)
{
  const Indexed_mesh input = tangled(GetParam());
  std::set<HMO::Stage> stopped_in;
  for (Method method : {Method::FULL, Method::RECTIFICATION, Method::MAXIMIZATION})
    for (std::size_t calls = 1;; calls += 1 + calls / 3) {
      SCOPED_TRACE(std::to_string(int(method)) + ", call " + std::to_string(calls));
      Indexed_mesh mesh = input;
      Recorder recorder;
      const Status status = optimize_until(calls, method, mesh, recorder);
      expect_best(input, mesh, recorder, status);
      if (status.return_code != Return_code::STOPPED_BY_VISITOR) {
        EXPECT_LT(recorder.seen.size(), calls);
        break;
      }
      EXPECT_EQ(recorder.seen.size(), calls);
      stopped_in.insert(recorder.seen.back().stage);
    }
  EXPECT_EQ(stopped_in.size(), 3u);
}

// The visitor waits until the time is over: it is not called again.
TEST_P(Interruption, by_the_time_limit_after_any_call)
{
  const Indexed_mesh input = tangled(GetParam());
  const double limit = .05;
  for (Method method : {Method::FULL, Method::MAXIMIZATION})
    for (std::size_t calls : {1, 2, 5, 12}) {
      SCOPED_TRACE(std::to_string(int(method)) + ", call " + std::to_string(calls));
      const auto start = std::chrono::steady_clock::now();
      Recorder recorder;
      recorder.goes_on = [&](const Iteration&) {
        while (recorder.seen.size() >= calls &&
               std::chrono::steady_clock::now() - start < std::chrono::duration<double>(2 * limit)) {
        }
        return true;
      };
      Indexed_mesh mesh = input;
      const Status status = CGAL::optimize_hex_mesh(
        mesh.points, mesh.hexahedra,
        params::optimization_method(method).maximum_running_time(limit).visitor(std::ref(recorder)));
      EXPECT_EQ(status.return_code, Return_code::TIME_LIMIT);
      EXPECT_LE(recorder.seen.size(), calls); // fewer on a machine that is slower
      expect_best(input, mesh, recorder, status);
    }
}

// From a valid state on, it never gets lost again, whenever the optimization ends
TEST_P(Interruption, of_a_valid_mesh_leaves_it_valid)
{
  Indexed_mesh input = GetParam()();
  HMO::scramble_interior(input.points, input.hexahedra, 5, .1);
  ASSERT_EQ(number_of_invalid(input), 0u);
  const double minimum = HMO::quality_statistics(input.points, input.hexahedra).minimum;
  for (Method method : {Method::FULL, Method::RECTIFICATION, Method::MAXIMIZATION})
    for (std::size_t calls : {std::size_t(1), std::size_t(2), std::size_t(4), std::size_t(9), never}) {
      SCOPED_TRACE(std::to_string(int(method)) + ", call " + std::to_string(calls));
      Indexed_mesh mesh = input;
      Recorder recorder;
      const Status status = optimize_until(calls, method, mesh, recorder);
      expect_best(input, mesh, recorder, status);
      EXPECT_GE(HMO::quality_statistics(mesh.points, mesh.hexahedra).minimum, minimum);
    }
}

} // namespace
