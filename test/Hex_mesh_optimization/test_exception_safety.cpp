// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever throws, and whenever it does, the mesh of the caller is as it was, bit by bit: a visitor in any of
// its calls, a property map, or memory that is used up at any allocation.

#include <CGAL/optimize_hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/hexahedra_to_linear_cell_complex.h>

#include "mesh_families.h"

#include <CGAL/Cartesian.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Linear_cell_complex_for_generalized_map.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <new>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

// --- The memory of this program ------------------------------------------------------

namespace {

constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
std::size_t allocations_left = never; // until one fails
std::size_t number_of_allocations = 0;

void* allocate(std::size_t size)
{
  ++number_of_allocations;
  if (allocations_left != never && allocations_left-- == 0) {
    allocations_left = never; // memory is there again while the exception travels
    throw std::bad_alloc();
  }
  if (void* p = std::malloc(size == 0 ? 1 : size))
    return p;
  throw std::bad_alloc();
}

} // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace params = CGAL::parameters;
using Surface_mesh = CGAL::Surface_mesh<Indexed_mesh::Point>;

// --- The meshes of the caller: index form and linear cell complexes ------------------

// A point that allocates memory, so that writing the result back can fail as well
using Allocating_kernel = CGAL::Cartesian<double>;

Indexed_mesh tangled_block()
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{2, 2, 2}}, {{2, 2, 2}});
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 1);
  HMO::jitter_boundary(mesh.points, mesh.hexahedra, 1, .5);
  return mesh;
}

const Surface_mesh& surface()
{
  static const Surface_mesh result = [] {
    Indexed_mesh mesh;
    HMO::make_block(mesh.points, mesh.hexahedra, {{2, 2, 2}}, {{2, 2, 2}});
    Surface_mesh s;
    using Vertex = Surface_mesh::Vertex_index;
    for_boundary(
      mesh, [&](const Indexed_mesh::Point& p) { return s.add_vertex(p); },
      [&](Vertex a, Vertex b, Vertex c) { s.add_face(a, b, c); });
    return s;
  }();
  return result;
}

template <class Kernel>
struct Ranges
{
  std::vector<typename Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;

  Ranges()
  {
    const Indexed_mesh mesh = tangled_block();
    for (const auto& p : mesh.points)
      points.emplace_back(p.x(), p.y(), p.z());
    hexahedra = mesh.hexahedra;
  }

  template <class NamedParameters>
  HMO::Status optimize(bool with_reference, const NamedParameters& np)
  {
    return with_reference ? CGAL::optimize_hex_mesh(points, hexahedra, surface(), np)
                          : CGAL::optimize_hex_mesh(points, hexahedra, np);
  }

  std::vector<double> coordinates() const
  {
    std::vector<double> result;
    for (const auto& p : points)
      for (int d = 0; d < 3; ++d)
        result.push_back(p[d]);
    return result;
  }

  std::vector<std::size_t> connectivity() const
  {
    std::vector<std::size_t> result;
    for (const auto& h : hexahedra)
      result.insert(result.end(), h.begin(), h.end());
    return result;
  }
};

template <class LCC>
struct Complex
{
  LCC lcc;

  Complex()
  {
    const Ranges<typename LCC::Traits::Kernel> mesh;
    HMO::hexahedra_to_linear_cell_complex(mesh.points, mesh.hexahedra, lcc);
  }

  template <class NamedParameters>
  HMO::Status optimize(bool with_reference, const NamedParameters& np)
  {
    return with_reference ? CGAL::optimize_hex_mesh(lcc, surface(), np) : CGAL::optimize_hex_mesh(lcc, np);
  }

  std::vector<double> coordinates() const
  {
    std::vector<double> result;
    for (auto it = lcc.vertex_attributes().begin(); it != lcc.vertex_attributes().end(); ++it)
      for (int d = 0; d < 3; ++d)
        result.push_back(it->point()[d]);
    return result;
  }

  std::vector<std::size_t> connectivity() const
  {
    std::vector<typename LCC::Point> points;
    std::vector<std::array<std::size_t, 8>> hexahedra;
    HMO::linear_cell_complex_to_hexahedra(lcc, points, hexahedra);
    std::vector<std::size_t> result(1, lcc.number_of_used_marks()); // a mark that is lost is lost for good
    for (const auto& h : hexahedra)
      result.insert(result.end(), h.begin(), h.end());
    return result;
  }
};

using Generalized_map = CGAL::Linear_cell_complex_for_generalized_map<3>;
using Combinatorial_map =
  CGAL::Linear_cell_complex_for_combinatorial_map<3, 3, CGAL::Linear_cell_complex_traits<3, Allocating_kernel>>;

using Meshes = ::testing::Types<Ranges<Allocating_kernel>, Complex<Generalized_map>, Complex<Combinatorial_map>>;

bool same_bits(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

template <class Mesh>
class Exception_safety : public ::testing::Test
{};
TYPED_TEST_SUITE(Exception_safety, Meshes);

// Optimizes meshes until one comes through, each with the next `interruption`, and expects of all others that they
// are as they were. Returns how many were interrupted.
template <class Mesh, class Exception, class Interrupt, class Next>
std::size_t expect_unchanged(bool with_reference, const Interrupt& interrupt, const Next& next)
{
  Mesh mesh;
  const std::vector<double> before = mesh.coordinates();
  const std::vector<std::size_t> connectivity = mesh.connectivity();
  std::size_t interrupted = 0;
  for (std::size_t i = 0;; i = next(i)) {
    SCOPED_TRACE(i);
    try {
      interrupt(mesh, with_reference, i);
      break;
    }
    catch (const Exception&) {
      ++interrupted;
    }
    EXPECT_TRUE(same_bits(mesh.coordinates(), before));
    EXPECT_EQ(mesh.connectivity(), connectivity);
  }
  EXPECT_FALSE(same_bits(mesh.coordinates(), before)) << "the call that is not interrupted moves vertices";
  EXPECT_EQ(mesh.connectivity(), connectivity);
  return interrupted;
}

// --- The caller's own functions -----------------------------------------------------------

struct Thrower
{
  std::size_t calls_left;
  std::set<HMO::Stage>* thrown_in;

  bool on_iteration(const HMO::Iteration& iteration)
  {
    if (calls_left-- > 0)
      return true;
    thrown_in->insert(iteration.stage);
    throw std::domain_error("thrown by the visitor");
  }
};

TYPED_TEST(Exception_safety, of_a_visitor_that_throws_in_any_call)
{
  std::set<HMO::Stage> thrown_in;
  std::size_t interrupted = 0;
  for (HMO::Method method : {HMO::Method::FULL, HMO::Method::RECTIFICATION, HMO::Method::MAXIMIZATION})
    for (bool with_reference : {false, true})
      interrupted += expect_unchanged<TypeParam, std::domain_error>(
        with_reference,
        [&](TypeParam& mesh, bool reference, std::size_t call) {
          mesh.optimize(reference, params::optimization_method(method).visitor(Thrower{call, &thrown_in}));
        },
        [](std::size_t call) { return call + 1 + call / 3; });
  EXPECT_EQ(thrown_in.size(), 3u) << "every stage was interrupted";
  EXPECT_GT(interrupted, 30u);
}

template <class Key, class Value>
struct Throwing_map
{
  using key_type = Key;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;
  std::size_t* calls_left;
  Value value;

  friend Value get(const Throwing_map& map, const Key&)
  {
    if ((*map.calls_left)-- == 0)
      throw std::domain_error("thrown by the map");
    return map.value;
  }
};

TEST(Exception_safety_of_maps, that_throw)
{
  using Mesh = Ranges<Indexed_mesh::Kernel>;
  const auto next = [](std::size_t call) { return 2 * call + 1; };
  const auto brief = params::optimization_method(HMO::Method::RECTIFICATION);
  EXPECT_GT(
    (expect_unchanged<Mesh, std::domain_error>(
      true,
      [&](Mesh& mesh, bool reference, std::size_t call) {
        mesh.optimize(reference, brief.vertex_is_constrained_map(Throwing_map<std::size_t, bool>{&call, false}));
      },
      next)),
    4u);
  EXPECT_GT((expect_unchanged<Mesh, std::domain_error>(
              true,
              [&](Mesh& mesh, bool reference, std::size_t call) {
                mesh.optimize(reference, brief.target_edge_length_map(
                                           Throwing_map<std::pair<std::size_t, std::size_t>, double>{&call, 1}));
              },
              next)),
            4u);
  EXPECT_GT((expect_unchanged<Mesh, std::domain_error>(
              true,
              [&](Mesh& mesh, bool reference, std::size_t call) {
                ASSERT_TRUE(reference);
                CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface(), brief,
                                        params::edge_is_constrained_map(
                                          Throwing_map<Surface_mesh::Edge_index, bool>{&call, false}));
              },
              next)),
            4u);
}

// --- Memory that is used up ---------------------------------------------------------

// Lets one allocation after another fail: each of the first and the last, where the input is taken over and the result
// is written back, and `samples` of those between.
template <class Mesh, class NamedParameters>
void expect_unchanged_without_memory(bool with_reference, const NamedParameters& np, std::size_t dense,
                                     std::size_t samples)
{
  surface();
  Mesh mesh;
  const std::size_t before = number_of_allocations;
  mesh.optimize(with_reference, np);
  const std::size_t total = number_of_allocations - before, stride = total / samples;
  ASSERT_GT(stride, dense);
  const std::size_t interrupted = expect_unchanged<Mesh, std::bad_alloc>(
    with_reference,
    [&](Mesh& other, bool reference, std::size_t allocation) {
      allocations_left = allocation;
      try {
        other.optimize(reference, np);
      }
      catch (...) {
        allocations_left = never;
        throw;
      }
      allocations_left = never;
    },
    [&](std::size_t n) { return n < dense || n + dense + stride > total ? n + 1 : n + stride; });
  EXPECT_GE(interrupted, samples + dense);
  ::testing::Test::RecordProperty(with_reference ? "failures_with_reference" : "failures",
                                  static_cast<int>(interrupted));
}

TYPED_TEST(Exception_safety, of_an_allocation_that_fails)
{
  const auto brief = params::optimization_method(HMO::Method::RECTIFICATION)
                       .number_of_iterations(1)
                       .number_of_restarts(0)
                       .maximize_minimum_quality(false);
  for (bool with_reference : {false, true})
    expect_unchanged_without_memory<TypeParam>(with_reference, brief, 100, 10);
}

TEST(Exception_safety_of_all_stages, of_an_allocation_that_fails)
{
  for (HMO::Method method : {HMO::Method::FULL, HMO::Method::MAXIMIZATION})
    expect_unchanged_without_memory<Ranges<Indexed_mesh::Kernel>>(true, params::optimization_method(method), 0, 40);
}

} // namespace
