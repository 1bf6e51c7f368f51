// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes made from the surface of a ball, with more and more hexahedra: alone up to the optimization, and with it. The counter
// `power` is that of the number of hexahedra with which the processor time has grown since the size before, in the same run.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/make_hex_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

const Surface& ball()
{
  static const Surface surface = [] {
    Surface result;
    CGAL::make_icosahedron(result);
    CGAL::Subdivision_method_3::Loop_subdivision(result, CGAL::parameters::number_of_iterations(4));
    return result;
  }();
  return surface;
}

struct Growth
{
  double hexahedra = 0, seconds = 0;

  // Since the last call.
  double power(double n, double t)
  {
    const double result = seconds > 0 ? std::log(t / seconds) / std::log(n / hexahedra) : 0;
    hexahedra = n;
    seconds = t;
    return result;
  }
};

// make(number) returns how many hexahedra it has made.
template <class Make>
void measure(benchmark::State& state, Growth& growth, const Make& make)
{
  double hexahedra = 0;
  const std::clock_t start = std::clock();
  for (auto _ : state)
    hexahedra = double(make(static_cast<std::size_t>(state.range(0))));
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC / double(state.iterations());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(hexahedra));
  state.counters["hexahedra"] = hexahedra;
  state.counters["power"] = growth.power(hexahedra, seconds);
}

void voxels_and_layers(benchmark::State& state)
{
  static Growth growth;
  const HMO::internal::Reference_input surface =
    HMO::internal::triangle_mesh_to_reference(ball(), CGAL::parameters::default_values());
  measure(state, growth, [&](std::size_t number) {
    HMO::internal::Meshing_parameters parameters;
    parameters.number_of_hexahedra = number;
    return HMO::internal::Hex_mesher(surface, parameters).mesh.hexahedra.size();
  });
}
BENCHMARK(voxels_and_layers)->RangeMultiplier(4)->Range(8000, 512000)->Iterations(1)->Unit(benchmark::kMillisecond);

void whole(benchmark::State& state)
{
  static Growth growth;
  measure(state, growth, [](std::size_t number) {
    std::vector<Point> points;
    std::vector<std::array<std::size_t, 8>> hexahedra;
    CGAL::make_hex_mesh(ball(), points, hexahedra, CGAL::parameters::number_of_hexahedra(number));
    return hexahedra.size();
  });
}
BENCHMARK(whole)->RangeMultiplier(4)->Range(8000, 512000)->Iterations(1)->Unit(benchmark::kMillisecond);

} // namespace
