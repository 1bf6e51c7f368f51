// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What an optimization costs, in sweeps: one sweep finds the scaled Jacobian of every corner of the mesh and adds up
// its gradients at the vertices, which is the least that a method of first order does in an iteration. And the kernels.

#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_energy.h>
#include <CGAL/optimize_hex_mesh.h>

#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;
using Point = CGAL::Simple_cartesian<double>::Point_3;

struct Mesh
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;

  explicit Mesh(std::size_t n)
  {
    HMO::make_ball(points, hexahedra, n);
    HMO::scramble_interior(points, hexahedra, 1, .2);
  }

  Hexahedral_complex complex() const
  {
    std::vector<Hexahedron> result;
    for (const auto& h : hexahedra) {
      result.emplace_back();
      std::copy(h.begin(), h.end(), result.back().begin());
    }
    return Hexahedral_complex(points.size(), std::move(result));
  }

  Positions positions() const
  {
    Positions result;
    for (const Point& p : points)
      result.emplace_back(p.x(), p.y(), p.z());
    return result;
  }
};

// Returns the sum of the scaled Jacobians.
double sweep(const Hexahedral_complex& complex, const Hexahedron_batches& batches, const Positions& points,
             Positions& gradient)
{
  double sum = 0;
  for (std::size_t batch = 0; batch < batches.size(); ++batch) {
    const Hexahedron_frame<Lanes> frame = batches.frame(batch, points);
    Lanes g[8][3] = {}, total{};
    for (int c = 0; c < 8; ++c) {
      const Corner_frame<Lanes> corner(frame, c);
      total += corner.scaled_jacobian;
      for (int i = 0; i < 3; ++i) {
        const Lanes scale = frame.inverse_length[corner_edges[c][i] / 2];
        for (int a = 0; a < 3; ++a) {
          const Lanes slope = scale * (corner.cross[i][a] - corner.scaled_jacobian * corner.unit[i][a]);
          g[corner_neighbors[c][i]][a] += slope;
          g[c][a] -= slope;
        }
      }
    }
    for (int l = 0; l < batches.number_of_hexahedra(batch); ++l) {
      const Hexahedron& h = complex.hexahedra[batches.first_hexahedron(batch) + l];
      for (int i = 0; i < 8; ++i)
        for (int a = 0; a < 3; ++a)
          gradient[h[i]][a] += lane(g[i][a], l);
      sum += lane(total, l);
    }
  }
  return sum;
}

void sweeps(benchmark::State& state)
{
  const Mesh mesh(static_cast<std::size_t>(state.range(0)));
  const Hexahedral_complex complex = mesh.complex();
  const Hexahedron_batches batches(complex);
  const Positions points = mesh.positions();
  Positions gradient(points.size(), Vector_3::Zero());
  for (auto _ : state)
    benchmark::DoNotOptimize(sweep(complex, batches, points, gradient));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.hexahedra.size()));
}
BENCHMARK(sweeps)->Arg(8)->Arg(22)->Unit(benchmark::kMillisecond);

// Gradient and Hessian of the energy of all hexahedra, without adding them up
void energy_derivatives(benchmark::State& state)
{
  const Mesh mesh(static_cast<std::size_t>(state.range(0)));
  const Hexahedral_complex complex = mesh.complex();
  const Hexahedron_batches batches(complex);
  const Positions points = mesh.positions();
  const Hexahedron_energy energy((Hexahedron_energy_parameters()));
  Lanes inverse_targets[12], floor[8] = {};
  std::fill_n(inverse_targets, 12, Lanes{} + 1.f);
  for (auto _ : state)
    for (std::size_t batch = 0; batch < batches.size(); ++batch) {
      Hexahedron_derivatives<Lanes> d;
      energy.derivatives(batches.frame(batch, points), inverse_targets, floor, d);
      benchmark::DoNotOptimize(d);
    }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.hexahedra.size()));
}
BENCHMARK(energy_derivatives)->Arg(8)->Arg(22)->Unit(benchmark::kMillisecond);

// A whole optimization, in one thread; the counter is its time over that of a sweep, the fastest of many in the same
// process
void optimization(benchmark::State& state)
{
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const Mesh given(static_cast<std::size_t>(state.range(0)));
  const Hexahedral_complex complex = given.complex();
  const Hexahedron_batches batches(complex);
  const Positions points = given.positions();
  Positions gradient(points.size(), Vector_3::Zero());
  double fastest = std::numeric_limits<double>::infinity(), total = 0;
  for (auto _ : state) {
    for (int i = 0; i < 50; ++i) {
      const Clock::time_point start = Clock::now();
      benchmark::DoNotOptimize(sweep(complex, batches, points, gradient));
      fastest = (std::min)(fastest, seconds_since(start));
    }
    Mesh mesh = given;
    const Clock::time_point start = Clock::now();
    const HMO::Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra);
    const double elapsed = seconds_since(start);
    state.SetIterationTime(elapsed);
    total += elapsed;
    state.counters["iterations"] = static_cast<double>(status.iterations);
  }
  state.counters["sweeps"] = total / static_cast<double>(state.iterations()) / fastest;
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(given.hexahedra.size()));
}
BENCHMARK(optimization)->Arg(8)->Arg(22)->Unit(benchmark::kSecond)->UseManualTime();

} // namespace
