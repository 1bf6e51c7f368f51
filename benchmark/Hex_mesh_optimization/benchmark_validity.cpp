// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The throughput of the certificate, as items (hexahedra) a second: where the first coefficients decide, where
// the cube is subdivided, and where only exact numbers tell.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/validity.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

constexpr int unit_square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

struct Mesh
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
};

Mesh ball(const benchmark::State& state)
{
  Mesh mesh;
  HMO::make_ball(mesh.points, mesh.hexahedra, static_cast<std::size_t>(state.range(0)));
  return mesh;
}

void certify(benchmark::State& state, const Mesh& mesh)
{
  std::vector<std::size_t> invalid;
  for (auto _ : state) {
    invalid.clear();
    HMO::invalid_hexahedra(mesh.points, mesh.hexahedra, std::back_inserter(invalid));
    benchmark::DoNotOptimize(invalid.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.hexahedra.size()));
  state.counters["invalid"] = static_cast<double>(invalid.size()) / static_cast<double>(mesh.hexahedra.size());
}

void certify(benchmark::State& state, const std::array<Point, 8>& hexahedron)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(HMO::hexahedron_validity(hexahedron));
  state.SetItemsProcessed(state.iterations());
  state.counters["invalid"] = HMO::is_valid_hexahedron(hexahedron) ? 0 : 1;
}

void certificate_of_a_valid_mesh(benchmark::State& state) { certify(state, ball(state)); }
BENCHMARK(certificate_of_a_valid_mesh)->Arg(8)->Arg(32)->Unit(benchmark::kMillisecond);

void certificate_of_a_tangled_mesh(benchmark::State& state)
{
  Mesh mesh = ball(state);
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 1);
  certify(state, mesh);
}
BENCHMARK(certificate_of_a_tangled_mesh)->Arg(8)->Arg(32)->Unit(benchmark::kMillisecond);

// A cube whose top is turned: all corners are positive, but the coefficients between them are not.
void certificate_by_subdivision(benchmark::State& state)
{
  const double angle = static_cast<double>(state.range(0)) / 100;
  std::array<Point, 8> p;
  for (int i = 0; i < 8; ++i) {
    const double x = unit_square[i % 4][0] - .5, y = unit_square[i % 4][1] - .5, a = i < 4 ? 0 : angle;
    p[i] = Point(std::cos(a) * x - std::sin(a) * y, std::sin(a) * x + std::cos(a) * y, i < 4 ? 0 : 1);
  }
  certify(state, p);
}
BENCHMARK(certificate_by_subdivision)->Arg(100)->Arg(160)->Arg(175);

// The top is in the sheared plane of the bottom, up to rounding.
void certificate_by_exact_numbers(benchmark::State& state)
{
  std::array<Point, 8> p;
  for (int i = 0; i < 8; ++i) {
    const double x = unit_square[i % 4][0] + (i < 4 ? 0 : .3), y = unit_square[i % 4][1] + (i < 4 ? 0 : .7);
    p[i] = Point(x, y, x / 3 + y / 7);
  }
  certify(state, p);
}
BENCHMARK(certificate_by_exact_numbers);

} // namespace
