// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The time of one sweep over a mesh, as items (hexahedra) a second.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/quality.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Mesh
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
};

Mesh ball(const benchmark::State& state)
{
  Mesh mesh;
  CGAL::Hex_mesh_optimization::make_ball(mesh.points, mesh.hexahedra, static_cast<std::size_t>(state.range(0)));
  return mesh;
}

void count_hexahedra(benchmark::State& state, const Mesh& mesh)
{
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.hexahedra.size()));
}

void scaled_jacobians(benchmark::State& state)
{
  const Mesh mesh = ball(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(CGAL::Hex_mesh_optimization::scaled_jacobians(mesh.points, mesh.hexahedra));
  count_hexahedra(state, mesh);
}
BENCHMARK(scaled_jacobians)->Arg(8)->Arg(32)->Unit(benchmark::kMillisecond);

void quality_statistics(benchmark::State& state)
{
  const Mesh mesh = ball(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(CGAL::Hex_mesh_optimization::quality_statistics(mesh.points, mesh.hexahedra));
  count_hexahedra(state, mesh);
}
BENCHMARK(quality_statistics)->Arg(8)->Arg(32)->Unit(benchmark::kMillisecond);

// Tangled hexahedra are the hard ones for the certificate of validity
void quality_statistics_of_a_tangled_mesh(benchmark::State& state)
{
  Mesh mesh = ball(state);
  CGAL::Hex_mesh_optimization::scramble_interior(mesh.points, mesh.hexahedra, 1, .3);
  for (auto _ : state)
    benchmark::DoNotOptimize(CGAL::Hex_mesh_optimization::quality_statistics(mesh.points, mesh.hexahedra));
  count_hexahedra(state, mesh);
}
BENCHMARK(quality_statistics_of_a_tangled_mesh)->Arg(8)->Arg(32)->Unit(benchmark::kMillisecond);

} // namespace
