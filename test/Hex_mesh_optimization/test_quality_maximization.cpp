// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The energies of quality maximization against finite differences and their
// symmetries, what corners are penalized below, and what a run never spoils.

#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_derivatives.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Distance_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Lanes.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Quality_floor.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Quality_maximization.h>
#include <CGAL/Hex_mesh_optimization/internal/untangling/Untangling.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/hold_back.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>

#include "Corner.h"
#include "hexahedron_rotations.h"
#include "mesh_families.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;
using Lengths = std::array<double, 12>; // targets of the edges
using Floor = std::array<double, 8>;    // of the corners
using Corners = std::array<Vector_3, 8>;

double uniform(std::mt19937& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

Vector_3 random_vector(std::mt19937& random, double size)
{
  return Vector_3(uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size));
}

Matrix_3 random_rotation(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized().toRotationMatrix();
}

// --- Energy of a hexahedron ----------------------------------------------------------

Corners box(const Vector_3& size)
{
  Corners x;
  for (int i = 0; i < 8; ++i)
    x[i] = Vector_3(unit_corners[i][0], unit_corners[i][1], unit_corners[i][2]).cwiseProduct(size);
  return x;
}

Lengths lengths_of(const Corners& x)
{
  Lengths lengths;
  for (int k = 0; k < 12; ++k)
    lengths[k] = (x[hexahedron_edges[k][1]] - x[hexahedron_edges[k][0]]).norm();
  return lengths;
}

double worst_corner(const Corners& x)
{
  double worst = 1;
  for (int i = 0; i < 8; ++i)
    worst = (std::min)(worst, corner_at(x.data(), i).scaled_jacobian);
  return worst;
}

// A hexahedron with its arguments to the energy
struct Element
{
  Corners x;
  Lengths lengths;
  Floor floor;

  Hexahedron_frame<double> frame() const
  {
    double vectors[12][3];
    edge_vectors(Positions(x.begin(), x.end()), {0, 1, 2, 3, 4, 5, 6, 7}, vectors);
    return Hexahedron_frame<double>(vectors);
  }

  Lengths inverse_targets() const
  {
    Lengths result;
    for (int k = 0; k < 12; ++k)
      result[k] = 1 / lengths[k];
    return result;
  }

  double value(const Hexahedron_energy& energy) const { return energy.value(frame(), inverse_targets().data(), floor.data()); }

  Hexahedron_derivatives<double> derivatives(const Hexahedron_energy& energy) const
  {
    Hexahedron_derivatives<double> result;
    energy.derivatives(frame(), inverse_targets().data(), floor.data(), result);
    return result;
  }

  Corners gradient(const Hexahedron_energy& energy) const
  {
    const Hexahedron_derivatives<double> d = derivatives(energy);
    Corners g;
    for (int i = 0; i < 8; ++i)
      g[i] = Vector_3(d.gradient[i][0], d.gradient[i][1], d.gradient[i][2]);
    return g;
  }

  Eigen::Matrix<double, 24, 24> hessian(const Hexahedron_energy& energy) const { return dense(derivatives(energy)); }

  static Eigen::Matrix<double, 24, 24> dense(const Hexahedron_derivatives<double>& d)
  {
    Eigen::Matrix<double, 24, 24> A = Eigen::Matrix<double, 24, 24>::Zero();
    for (int i = 0; i < 8; ++i) {
      int n = 0;
      for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b, ++n)
          A(3 * i + a, 3 * i + b) = A(3 * i + b, 3 * i + a) = d.diagonal[i][n];
    }
    for (int k = 0; k < Hexahedron_couplings::number; ++k)
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
          const int row = 3 * hexahedron_couplings.first[k] + a, column = 3 * hexahedron_couplings.second[k] + b;
          A(row, column) = A(column, row) = d.coupling[k][3 * a + b];
        }
    return A;
  }
};

// Boxes from slightly to badly distorted; target lengths from their own ones to others altogether; floors below, among and
// above the scaled Jacobians
template <class Test>
void for_random_elements(int trials, const Test& test)
{
  std::mt19937 random(7);
  int valid = 0;
  for (int trial = 0; valid < trials; ++trial) {
    SCOPED_TRACE(trial);
    const double flatness = trial % 3, distortion = .1 + .05 * (trial % 8), freedom = trial % 4 * .4, floor = trial % 5 * .3;
    Element e;
    e.x = box(Vector_3(1, std::pow(2., flatness), std::pow(.5, flatness)));
    e.lengths = lengths_of(e.x);
    for (Vector_3& p : e.x)
      p += random_vector(random, distortion * std::pow(.5, flatness));
    if (worst_corner(e.x) < .05)
      continue;
    ++valid;
    for (double& l : e.lengths)
      l *= std::exp(uniform(random, -freedom, freedom));
    for (double& f : e.floor)
      f = uniform(random, .5, 1) * floor;
    test(e, random);
    if (::testing::Test::HasFailure())
      return;
  }
}

TEST(Hexahedron_energy, has_the_gradient_of_its_value)
{
  const Hexahedron_energy energy((Maximization_parameters()));
  for_random_elements(400, [&](const Element& e, std::mt19937&) {
    const Corners g = e.gradient(energy);
    double square = 0, error = 0;
    for (int i = 0; i < 8; ++i)
      for (int d = 0; d < 3; ++d) {
        const double h = 1e-6;
        Element plus = e, minus = e;
        plus.x[i][d] += h;
        minus.x[i][d] -= h;
        const double difference = (plus.value(energy) - minus.value(energy)) / (2 * h);
        square += difference * difference;
        error += (g[i][d] - difference) * (g[i][d] - difference);
      }
    EXPECT_GT(square, 0);
    EXPECT_LT(std::sqrt(error), 1e-5 * std::sqrt(square));
  });
}

TEST(Hexahedron_energy, has_a_model_of_the_hessian_without_negative_curvature)
{
  const Hexahedron_energy energy((Maximization_parameters()));
  for_random_elements(400, [&](const Element& e, std::mt19937&) {
    const Eigen::Matrix<double, 24, 24> A = e.hessian(energy);
    ASSERT_TRUE(A.allFinite());
    const double largest = A.cwiseAbs().maxCoeff();
    EXPECT_LE((A - A.transpose()).cwiseAbs().maxCoeff(), 1e-12 * largest);
    const auto values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 24, 24>>(A).eigenvalues();
    EXPECT_GT(values.maxCoeff(), 0);
    EXPECT_GE(values.minCoeff(), -1e-9 * values.maxCoeff());
    for (int d = 0; d < 3; ++d) { // nothing is felt of a translation
      Eigen::Matrix<double, 24, 1> t = Eigen::Matrix<double, 24, 1>::Zero();
      for (int i = 0; i < 8; ++i)
        t[3 * i + d] = 1;
      EXPECT_LE((A * t).norm(), 1e-9 * values.maxCoeff());
    }
  });
}

// What the optimization computes with, several hexahedra at once in single precision
TEST(Hexahedron_energy, is_the_same_for_several_hexahedra_at_once)
{
  const Hexahedron_energy energy((Maximization_parameters()));
  std::vector<Element> elements;
  for_random_elements(101, [&](const Element& e, std::mt19937&) { elements.push_back(e); });
  ASSERT_EQ(elements.size(), 101u);
  for (std::size_t first = 0; first < elements.size(); first += number_of_lanes) {
    Lanes vectors[12][3] = {}, inverse_targets[12] = {}, floor[8] = {};
    const auto element = [&](int l) -> const Element& { return elements[(std::min)(first + l, elements.size() - 1)]; };
    for (int l = 0; l < number_of_lanes; ++l) {
      float one[12][3];
      edge_vectors(Positions(element(l).x.begin(), element(l).x.end()), {0, 1, 2, 3, 4, 5, 6, 7}, one);
      for (int k = 0; k < 12; ++k) {
        for (int a = 0; a < 3; ++a)
          set_lane(vectors[k][a], l, one[k][a]);
        set_lane(inverse_targets[k], l, static_cast<float>(element(l).inverse_targets()[k]));
      }
      for (int c = 0; c < 8; ++c)
        set_lane(floor[c], l, static_cast<float>(element(l).floor[c]));
    }
    const Hexahedron_frame<Lanes> frame(vectors);
    const Lanes values = energy.value(frame, inverse_targets, floor);
    Hexahedron_derivatives<Lanes> d;
    energy.derivatives(frame, inverse_targets, floor, d);
    for (int l = 0; l < number_of_lanes; ++l) {
      const double value = element(l).value(energy);
      EXPECT_NEAR(lane(values, l), value, 1e-4 * value);
      const Hexahedron_derivatives<double> expected = element(l).derivatives(energy);
      Hexahedron_derivatives<double> found;
      for (int i = 0; i < 8; ++i) {
        for (int a = 0; a < 3; ++a)
          found.gradient[i][a] = lane(d.gradient[i][a], l);
        for (int n = 0; n < 6; ++n)
          found.diagonal[i][n] = lane(d.diagonal[i][n], l);
      }
      for (int k = 0; k < Hexahedron_couplings::number; ++k)
        for (int n = 0; n < 9; ++n)
          found.coupling[k][n] = lane(d.coupling[k][n], l);
      const Eigen::Matrix<double, 24, 24> A = Element::dense(expected), B = Element::dense(found);
      EXPECT_LT((A - B).norm(), 1e-4 * A.norm());
      const auto gradient = [](const Hexahedron_derivatives<double>& of) { return Eigen::Map<const Eigen::Matrix<double, 24, 1>>(&of.gradient[0][0]); };
      EXPECT_LT((gradient(found) - gradient(expected)).norm(), 1e-4 * gradient(expected).norm() + 1e-5 * A.norm());
    }
  }
}

// Where the model has the most to do: a corner that is all but flat
TEST(Hexahedron_energy, has_a_model_of_the_hessian_next_to_inversion)
{
  const Hexahedron_energy energy((Maximization_parameters()));
  for (double height : {1e-1, 1e-3, 1e-6}) {
    SCOPED_TRACE(height);
    Element e{box(Vector_3(1, 1, 1)), {}, {}};
    e.x[0] = Vector_3::Constant((1 - height) / 3); // above the plane of its neighbors
    e.lengths = lengths_of(e.x);
    e.floor.fill(.5);
    ASSERT_GT(worst_corner(e.x), 0);
    ASSERT_LT(worst_corner(e.x), 3 * height);
    const Eigen::Matrix<double, 24, 24> A = e.hessian(energy);
    ASSERT_TRUE(A.allFinite());
    const auto values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 24, 24>>(A).eigenvalues();
    EXPECT_GE(values.minCoeff(), -1e-9 * values.maxCoeff());
  }
}

TEST(Hexahedron_energy, is_infinite_where_a_corner_is_inverted)
{
  const Hexahedron_energy energy((Maximization_parameters()));
  std::mt19937 random(3);
  int inverted = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    Element e{box(Vector_3(1, 1, 1)), {}, {}};
    e.lengths.fill(1);
    for (Vector_3& p : e.x)
      p += random_vector(random, .5);
    const bool is_inverted = worst_corner(e.x) <= 0;
    inverted += is_inverted;
    EXPECT_EQ(e.value(energy) == std::numeric_limits<double>::infinity(), is_inverted);
    EXPECT_EQ(std::isfinite(e.value(energy)), !is_inverted);
  }
  EXPECT_GT(inverted, 100);
  EXPECT_LT(inverted, 900);

  Element flat{box(Vector_3(1, 1, 1)), {}, {}};
  flat.lengths.fill(1);
  flat.x[0] = Vector_3(.5, .5, 0); // on a line with its neighbors 1 and 3
  EXPECT_EQ(worst_corner(flat.x), 0);
  EXPECT_GT(flat.value(energy), 1e4); // the scaled Jacobian may be a rounding error above 0
  flat.x[1] = flat.x[0]; // an edge without length
  EXPECT_EQ(flat.value(energy), std::numeric_limits<double>::infinity());
}

TEST(Hexahedron_energy, does_not_depend_on_place_and_unit_of_length)
{
  const Hexahedron_energy energy((Maximization_parameters()));
  for_random_elements(200, [&](const Element& e, std::mt19937& random) {
    const double scale = std::exp(uniform(random, -5, 5));
    const Matrix_3 rotation = random_rotation(random);
    const Vector_3 translation = random_vector(random, 10 * scale);
    Element image = e;
    for (Vector_3& p : image.x)
      p = scale * rotation * p + translation;
    for (double& l : image.lengths)
      l *= scale;
    EXPECT_NEAR(image.value(energy), e.value(energy), 1e-9 * std::abs(e.value(energy)));
    const Corners g = e.gradient(energy), of_image = image.gradient(energy);
    double largest = 0;
    for (const Vector_3& v : g)
      largest = (std::max)(largest, v.norm());
    for (int i = 0; i < 8; ++i)
      EXPECT_LT((scale * of_image[i] - rotation * g[i]).norm(), 1e-8 * largest);
  });
}

TEST(Hexahedron_energy, does_not_depend_on_the_numbering)
{
  const Hexahedron_energy energy((Maximization_parameters()));
  const auto rotations = numberings(1);
  ASSERT_EQ(rotations.size(), 24u);
  for_random_elements(20, [&](const Element& e, std::mt19937&) {
    for (const auto& rotation : rotations) {
      Element image;
      for (int i = 0; i < 8; ++i) {
        image.x[i] = e.x[rotation[i]];
        image.floor[i] = e.floor[rotation[i]];
      }
      for (int k = 0; k < 12; ++k)
        for (int l = 0; l < 12; ++l)
          if (std::minmax(rotation[hexahedron_edges[k][0]], rotation[hexahedron_edges[k][1]]) ==
              std::minmax(hexahedron_edges[l][0], hexahedron_edges[l][1]))
            image.lengths[k] = e.lengths[l];
      EXPECT_NEAR(image.value(energy), e.value(energy), 1e-12 * std::abs(e.value(energy)));
    }
  });
}

// Whatever its corners are penalized below
TEST(Hexahedron_energy, is_stationary_at_a_box_of_the_target_lengths)
{
  const Hexahedron_energy energy((Maximization_parameters()));
  std::mt19937 random(1);
  for (const Vector_3& size : {Vector_3(1, 1, 1), Vector_3(1, 2, 3), Vector_3(.1, 1, 10)})
    for (double floor : {0., .7, 1.5}) {
      Element e{box(size), lengths_of(box(size)), {}};
      e.floor.fill(floor);
      for (const Vector_3& g : e.gradient(energy))
        EXPECT_LT(g.norm(), 1e-9 * (1 + 1000 * floor));
      for (int trial = 0; trial < 50; ++trial) { // it is a minimum
        Element other = e;
        for (Vector_3& p : other.x)
          p += random_vector(random, .05 * size.minCoeff());
        EXPECT_GT(other.value(energy), e.value(energy));
      }
    }
}

// --- Energy of a distance --------------------------------------------------------------

const Distance_energy distance_energies[] = {{1.65, .03, .2, .19}, {8, .03, .2, .6}, {1, 1, 0, 1}, {1e-3, .1, 5, .01}};

TEST(Distance_energy, has_the_slope_of_its_value)
{
  for (const Distance_energy& energy : distance_energies)
    for (double d = .01 * energy.linear_distance; d < 100; d *= 1.37) { // below, rounding of the value dominates
      const double h = 1e-4 * d, difference = (energy.value(d + h) - energy.value(d - h)) / (2 * h);
      EXPECT_NEAR(energy.derivatives(d).slope, difference / d, 1e-6 * difference / d) << d;
    }
}

TEST(Distance_energy, is_least_and_smooth_at_zero)
{
  for (const Distance_energy& energy : distance_energies) {
    EXPECT_EQ(energy.value(0), 0);
    EXPECT_NEAR(energy.derivatives(0).slope, energy.linear_weight / energy.linear_distance, 1e-12 * energy.derivatives(0).slope);
    EXPECT_NEAR(energy.derivatives(1e-9).slope, energy.derivatives(0).slope, 1e-9 * energy.derivatives(0).slope);
  }
}

TEST(Distance_energy, goes_smoothly_over_to_its_tangent)
{
  for (const Distance_energy& energy : distance_energies) {
    const double d = 2 * energy.steep_distance, h = 1e-9;
    EXPECT_NEAR(energy.value((1 - h) * d), energy.value((1 + h) * d), 1e-7 * energy.value(d));
    EXPECT_NEAR(energy.derivatives((1 - h) * d).slope, energy.derivatives((1 + h) * d).slope, 1e-7 * energy.derivatives(d).slope);
  }
}

TEST(Distance_energy, grows_and_is_not_underestimated_by_its_model)
{
  for (const Distance_energy& energy : distance_energies) {
    double before = 0;
    for (double d = 1e-4; d < 100; d *= 1.13) {
      const Distance_energy::Derivatives now = energy.derivatives(d);
      EXPECT_GT(energy.value(d), before);
      before = energy.value(d);
      EXPECT_GT(now.slope, 0);
      EXPECT_GE(now.growth, 0);
      const double h = 1e-4 * d;
      const double second = (energy.derivatives(d + h).slope * (d + h) - energy.derivatives(d - h).slope * (d - h)) / (2 * h);
      EXPECT_GE(now.slope + now.growth * d * d, second * (1 - 1e-5)) << d;
    }
  }
}

TEST(Distance_energy, is_linear_far_away)
{
  for (const Distance_energy& energy : distance_energies) {
    const double rate = energy.linear_weight + 192 * energy.steep_weight / energy.steep_distance; // 192 is ψ'(2)
    for (double d : {1e4, 1e6}) {
      EXPECT_NEAR((energy.value(2 * d) - energy.value(d)) / d, rate, 1e-6 * rate);
      EXPECT_NEAR(energy.derivatives(d).slope * d, rate, 1e-6 * rate);
      EXPECT_EQ(energy.derivatives(d).growth, 0);
    }
  }
}

// --- The matrix ----------------------------------------------------------------------------

// Vertices in any order, so that blocks stand on either side of the diagonal
Hexahedral_complex shuffled_complex(const Indexed_mesh& mesh, std::mt19937& random)
{
  std::vector<int> number(mesh.points.size());
  for (std::size_t v = 0; v < number.size(); ++v)
    number[v] = static_cast<int>(v);
  std::shuffle(number.begin(), number.end(), random);
  std::vector<Hexahedron> hexahedra;
  for (const auto& h : mesh.hexahedra) {
    hexahedra.emplace_back();
    for (int i = 0; i < 8; ++i)
      hexahedra.back()[i] = number[h[i]];
  }
  return Hexahedral_complex(number.size(), hexahedra);
}

// Positive definite; opposite corners of a hexahedron are not coupled
Eigen::Matrix<double, 24, 24> random_matrix(std::mt19937& random)
{
  Eigen::Matrix<double, 24, 24> A = Eigen::Matrix<double, 24, 24>::Identity();
  for (const auto& face : hexahedron_faces) {
    const Eigen::Matrix<double, 12, 12> R = Eigen::Matrix<double, 12, 12>::NullaryExpr([&] { return uniform(random, -1, 1); });
    const Eigen::Matrix<double, 12, 12> S = R.transpose() * R;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        A.block<3, 3>(3 * face[i], 3 * face[j]) += S.block<3, 3>(3 * i, 3 * j);
  }
  return A;
}

TEST(Hexahedron_assembly, adds_a_hexahedron_as_the_matrix_adds_its_blocks)
{
  std::mt19937 random(5);
  for (const Mesh_family& family : mesh_families()) {
    SCOPED_TRACE(family.name);
    const Hexahedral_complex complex = shuffled_complex(family(), random);
    const int n = static_cast<int>(complex.number_of_vertices());
    Block_matrix whole(vertex_couplings(complex)), one_by_one(vertex_couplings(complex));
    const Hexahedron_assembly assembly(complex, whole);
    Positions gradient(n, Vector_3::Zero()), expected_gradient = gradient;
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    for (Block_matrix* matrix : {&whole, &one_by_one})
      matrix->set_zero();
    for (std::size_t h = 0; h < complex.hexahedra.size(); ++h) {
      const Eigen::Matrix<double, 24, 24> A = random_matrix(random);
      Hexahedron_derivatives<double> derivatives;
      derivatives.set_zero();
      for (int i = 0; i < 8; ++i)
        for (int j = i; j < 8; ++j) {
          const Matrix_3 B = A.block<3, 3>(3 * i, 3 * j);
          const int v = complex.hexahedra[h][i], u = complex.hexahedra[h][j], k = hexahedron_couplings.of[i][j];
          if (i != j && k < 0) {
            EXPECT_TRUE(B.isZero());
            continue;
          }
          int entry = 0;
          for (int a = 0; a < 3; ++a)
            for (int b = i == j ? a : 0; b < 3; ++b)
              (i == j ? derivatives.diagonal[i] : derivatives.coupling[k])[entry++] = B(a, b);
          one_by_one.add(v, u, B);
          dense.block<3, 3>(3 * v, 3 * u) += B;
          if (i != j)
            dense.block<3, 3>(3 * u, 3 * v) += B.transpose();
        }
      for (int i = 0; i < 8; ++i)
        for (int a = 0; a < 3; ++a)
          expected_gradient[complex.hexahedra[h][i]][a] += derivatives.gradient[i][a] = uniform(random, -1, 1);
      assembly.add(h, derivatives, 0, gradient, whole);
    }
    EXPECT_EQ(gradient, expected_gradient);
    std::vector<char> is_fixed(n);
    for (int v = 0; v < n; ++v)
      is_fixed[v] = v % 7 == 3;
    Positions b, x, y;
    for (int v = 0; v < n; ++v)
      b.push_back(random_vector(random, 1));
    whole.solve(b, is_fixed, 1e-6, 10000, x);
    one_by_one.solve(b, is_fixed, 1e-6, 10000, y);
    EXPECT_EQ(whole.diagonal, one_by_one.diagonal);
    EXPECT_EQ(x, y);

    // and it is the matrix that was meant
    Eigen::VectorXd solution(3 * n);
    for (int v = 0; v < n; ++v)
      solution.segment<3>(3 * v) = x[v];
    const Eigen::VectorXd product = dense * solution;
    for (int v = 0; v < n; ++v)
      if (is_fixed[v]) {
        EXPECT_EQ(x[v], Vector_3(Vector_3::Zero()));
      }
      else {
        EXPECT_LT((product.segment<3>(3 * v) - b[v]).norm(), 1e-3);
      }
  }
}

// As many rows as take several sweeps at once.
TEST(Block_matrix, solves_large_systems_the_same_whatever_the_number_of_threads)
{
  std::mt19937 random(8);
  Indexed_mesh block;
  HMO::make_block(block.points, block.hexahedra, {{14, 13, 12}}, {{1, 1, 1}});
  const Hexahedral_complex complex = block.complex();
  const int n = static_cast<int>(complex.number_of_vertices());
  Block_matrix matrix(vertex_couplings(complex));
  matrix.set_zero();
  for (const Hexahedron& h : complex.hexahedra)
    for (int k = 0; k < 12; ++k) {
      const int v = h[hexahedron_edges[k][0]], u = h[hexahedron_edges[k][1]];
      matrix.add(v, v, Matrix_3::Identity());
      matrix.add(u, u, Matrix_3::Identity());
      matrix.add(v, u, -Matrix_3::Identity());
    }
  std::vector<char> is_fixed(n, false);
  is_fixed[0] = true; // else all could move by the same vector
  Positions x, b(n, Vector_3::Zero()), solution, in_parallel;
  for (int v = 0; v < n; ++v)
    x.push_back(is_fixed[v] ? Vector_3(Vector_3::Zero()) : random_vector(random, 1));
  for (const Hexahedron& h : complex.hexahedra)
    for (int k = 0; k < 12; ++k) {
      const int v = h[hexahedron_edges[k][0]], u = h[hexahedron_edges[k][1]];
      b[v] += x[v] - x[u];
      b[u] += x[u] - x[v];
    }
  int iterations = 0;
  run_concurrently(false, [&] { iterations = matrix.solve(b, is_fixed, 1e-6, 1000, solution); });
  run_concurrently(true, [&] { matrix.solve(b, is_fixed, 1e-6, 1000, in_parallel); });
  EXPECT_LT(iterations, 60); // rather than in proportion to the number of rows
  EXPECT_EQ(solution, in_parallel);
  for (int v = 0; v < n; ++v)
    EXPECT_LT((solution[v] - x[v]).norm(), 1e-3);
}

// --- The floor -------------------------------------------------------------------------------

Positions positions(const Indexed_mesh& mesh)
{
  Positions points;
  for (const auto& p : mesh.points)
    points.emplace_back(p.x(), p.y(), p.z());
  return points;
}

TEST(Quality_floor, never_falls_while_it_rises)
{
  const Maximization_parameters parameters;
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Hexahedron_batches batches(complex);
  Quality_floor floor(batches, parameters);
  std::mt19937 random(2);
  double before = 0, best = -1;
  for (int i = 0; i < 100; ++i) {
    Positions points = positions(mesh);
    for (Vector_3& p : points)
      p += random_vector(random, uniform(random, .2, .5) * (1 - i / 100.));
    const Mesh_quality quality(complex, points);
    best = (std::max)(best, quality.minimum);
    floor.rise(quality);
    const double now = floor.floors().get(0, 0);
    EXPECT_GE(now, before);
    EXPECT_GE(now, 0);
    EXPECT_LE(now, parameters.floor_limit + 1e-6);
    EXPECT_LE(now, (std::max)(0., best + parameters.floor_step) + 1e-6);
    for (std::size_t h = 0; h < complex.hexahedra.size(); ++h)
      for (int c = 0; c < 8; ++c)
        EXPECT_EQ(floor.floors().get(h, c), now);
    before = now;
  }
  EXPECT_FLOAT_EQ(before, parameters.floor_limit);
}

// Where the connectivity makes many hexahedra poor
TEST(Quality_floor, rises_no_higher_than_a_part_of_the_hexahedra)
{
  const Maximization_parameters parameters;
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Hexahedron_batches batches(complex);
  Quality_floor floor(batches, parameters);
  Mesh_quality quality(complex, positions(mesh));
  const std::size_t poor = static_cast<std::size_t>(parameters.floor_fraction * complex.hexahedra.size()) + 1;
  for (std::size_t h = 0; h < poor; ++h)
    quality.scaled_jacobians[h] = .5;
  quality.minimum = .45;
  floor.rise(quality);
  EXPECT_FLOAT_EQ(floor.floors().get(0, 0), .5);
  quality.scaled_jacobians[0] = 1;
  floor.rise(quality);
  EXPECT_FLOAT_EQ(floor.floors().get(0, 0), .45 + parameters.floor_step);
}

// As long as a corner stays below, its floor rises, up to a limit; once it does not, its floor comes down again
TEST(Quality_floor, lifts_only_corners_below_what_it_holds)
{
  const Maximization_parameters parameters;
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Positions good = positions(mesh);
  Positions poor = good;
  const auto interior = std::find(complex.is_on_boundary.begin(), complex.is_on_boundary.end(), false);
  poor[interior - complex.is_on_boundary.begin()] += Vector_3(.4, .4, .3);

  const Hexahedron_batches batches(complex);
  Quality_floor floor(batches, parameters);
  floor.rise(Mesh_quality(complex, good));
  std::vector<Floor> before(complex.hexahedra.size(), Floor{});
  const auto hold = [&](const Positions& points) { // returns how many corners are lifted
    floor.hold(Mesh_quality(complex, points), points);
    int lifted = 0;
    for (std::size_t h = 0; h < complex.hexahedra.size(); ++h) {
      const auto corners = hexahedron_corners(points, complex.hexahedra[h]);
      for (int c = 0; c < 8; ++c) {
        double lift = floor.floors().get(h, c) - (floor.held() + parameters.hold_margin);
        if (std::abs(lift) < 1e-6) // floors are in single precision
          lift = 0;
        if (corner_at(corners.data(), c).scaled_jacobian < floor.held()) {
          EXPECT_GT(lift, 0);
          EXPECT_TRUE(lift > before[h][c] || lift > parameters.largest_lift - 1e-6) << lift;
        }
        else {
          EXPECT_GE(lift, 0);
          EXPECT_TRUE(lift < before[h][c] || lift == 0) << lift;
        }
        EXPECT_LE(lift, parameters.largest_lift + 1e-6);
        lifted += lift > 0;
        before[h][c] = lift;
      }
    }
    return lifted;
  };
  EXPECT_EQ(hold(good), 0); // where nothing had to be lifted while it rose
  const int lifted = hold(poor);
  EXPECT_GT(lifted, 0);
  EXPECT_LT(lifted, 8 * 8) << "of the corners around one vertex";
  for (int round = 0; round < 40; ++round)
    EXPECT_EQ(hold(poor), lifted);
  for (int round = 0; round < 400; ++round) // a floor comes down by a part of what the corner has above the one that is held
    EXPECT_LE(hold(good), lifted);
  EXPECT_EQ(hold(good), 0);
}

// Forces that held the worst corners up do not vanish at once
TEST(Quality_floor, fades_from_where_it_had_risen)
{
  const Maximization_parameters parameters;
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  std::mt19937 random(7);
  Positions points = positions(mesh);
  for (Vector_3& p : points)
    p += random_vector(random, .1);
  const Mesh_quality quality(complex, points);
  ASSERT_GT(quality.minimum, 0);
  const Hexahedron_batches batches(complex);
  Quality_floor floor(batches, parameters);
  floor.rise(quality);
  const double risen = floor.floors().get(0, 0);
  floor.hold(quality, points);
  ASSERT_GT(risen, floor.held() + parameters.hold_margin);
  for (std::size_t h = 0; h < complex.hexahedra.size(); ++h) {
    const auto corners = hexahedron_corners(points, complex.hexahedra[h]);
    for (int c = 0; c < 8; ++c) {
      const double above = corner_at(corners.data(), c).scaled_jacobian - floor.held();
      EXPECT_NEAR(floor.floors().get(h, c), (std::max)(floor.held() + parameters.hold_margin, risen - parameters.lift_rate * above), 1e-6);
    }
  }
}

TEST(Quality_floor, holds_no_more_than_was_reached)
{
  const Maximization_parameters parameters;
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  std::mt19937 random(4);
  for (int trial = 0; trial < 50; ++trial) {
    Positions points = positions(mesh);
    for (Vector_3& p : points)
      p += random_vector(random, .004 * trial);
    const Mesh_quality quality(complex, points);
    const Hexahedron_batches batches(complex);
    Quality_floor floor(batches, parameters);
    floor.hold(quality, points);
    EXPECT_LE(floor.held(), (std::max)(0., quality.minimum));
    for (std::size_t h = 0; h < complex.hexahedra.size(); ++h)
      for (int c = 0; c < 8; ++c)
        EXPECT_NEAR(floor.floors().get(h, c), floor.held() + parameters.hold_margin, 1e-6) << "nothing is below what is held";
  }
}

// --- Steps -----------------------------------------------------------------------------------------

Batched_values<1> same_for_all(const Hexahedral_complex& complex, double value)
{
  Batched_values<1> result(complex.hexahedra.size());
  for (std::size_t h = 0; h < complex.hexahedra.size(); ++h)
    result.set(h, 0, value);
  return result;
}

// Only vertices of hexahedra that would get too poor are held back, and these until none is
TEST(Held_back_step, is_shortened_only_where_corners_would_get_too_poor)
{
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Positions points = positions(mesh);
  const Batched_values<1> least = same_for_all(complex, .6);
  std::mt19937 random(3);
  Positions step(points.size());
  for (Vector_3& d : step)
    d = random_vector(random, .02);
  const int moved = complex.hexahedra[0][0];
  step[moved] = Vector_3(1, .8, .9);
  const Positions given = step;
  const int rounds = 20;
  hold_back(complex, Hexahedron_batches(complex), points, least, rounds, step);

  std::vector<char> is_near(points.size(), false);
  for (int h : complex.vertex_hexahedra[moved])
    for (int v : complex.hexahedra[h])
      is_near[v] = true;
  Positions reached = points;
  for (std::size_t v = 0; v < points.size(); ++v) {
    reached[v] += step[v];
    if (!is_near[v]) {
      EXPECT_EQ(step[v], given[v]) << v;
    }
  }
  EXPECT_GE(Mesh_quality(complex, reached).minimum, .6);
  const double part = step[moved].norm() / given[moved].norm();
  EXPECT_LT(part, 1);
  EXPECT_GT(part, 0);
  EXPECT_NEAR(std::log2(part), std::round(std::log2(part)), 1e-12) << "halved, and halved again";
  // once less would not have done
  Positions longer = points;
  for (std::size_t v = 0; v < points.size(); ++v)
    longer[v] += is_near[v] ? Vector_3(2 * step[v]) : step[v];
  EXPECT_LT(Mesh_quality(complex, longer).minimum, .6);
}

TEST(Held_back_step, ends_after_the_rounds)
{
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Batched_values<1> unreachable = same_for_all(complex, 2);
  Positions step(mesh.points.size(), Vector_3(1, 2, 3));
  hold_back(complex, Hexahedron_batches(complex), positions(mesh), unreachable, 3, step);
  for (const Vector_3& d : step)
    EXPECT_EQ(d, Vector_3(1, 2, 3) / 8);
}

// --- A mesh with all that a run needs ------------------------------------------------------------

struct Setting
{
  Hexahedral_complex complex;
  Positions points; // in units of the mean boundary edge
  std::unique_ptr<Reference_surface> surface;
  Boundary_attachment attachment;
  Edge_relations relations;
  std::vector<double> lengths;
  std::vector<char> is_fixed;
  Maximization_parameters parameters;

  explicit Setting(const Indexed_mesh& mesh)
    : complex(mesh.complex())
    , points(normalized(complex, positions(mesh)))
    , surface(own_reference(complex, points))
    , attachment(attach_to_own_boundary(complex, *surface))
    , relations(complex)
    , lengths(edge_lengths(complex, points))
    , is_fixed(points.size(), false)
  {}

  void fix(std::size_t v)
  {
    is_fixed[v] = true;
    attachment.kind[v] = Vertex_kind::FIXED;
  }

  void scramble(std::mt19937& random, double amplitude, bool and_boundary)
  {
    for (std::size_t v = 0; v < points.size(); ++v)
      if (and_boundary || !complex.is_on_boundary[v])
        points[v] += random_vector(random, amplitude);
  }

  Surface_attachment surface_attachment() const
  {
    return Surface_attachment(complex, *surface, attachment, lengths, false, parameters);
  }

  void run(Run_control& control, double target_quality = std::numeric_limits<double>::infinity())
  {
    Surface_attachment surface_attachment = this->surface_attachment();
    Quality_maximization(complex, surface_attachment, lengths, &relations, is_fixed, parameters)
      .run(points, control, target_quality);
  }

private:
  static Positions normalized(const Hexahedral_complex& complex, Positions points)
  {
    const double unit = mean_boundary_edge_length(complex, points);
    for (Vector_3& p : points)
      p /= unit;
    return points;
  }

  static std::unique_ptr<Reference_surface> own_reference(const Hexahedral_complex& complex, const Positions& points)
  {
    return boundary_as_reference(complex, points, Feature_parameters());
  }
};

class Maximization : public ::testing::TestWithParam<Mesh_family> {};

std::string family_name(const ::testing::TestParamInfo<Mesh_family>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Families, Maximization, ::testing::ValuesIn(mesh_families()), family_name);

// --- Attachment of the boundary ------------------------------------------------------------------

// Targets stay where they were found
TEST_P(Maximization, attachment_has_the_gradient_of_its_energy)
{
  std::mt19937 random(6);
  for (double bound : {std::numeric_limits<double>::infinity(), .05}) {
    Setting s(GetParam()());
    s.parameters.maximum_deviation = bound;
    Surface_attachment attachment = s.surface_attachment();
    attachment.tightness = .3;
    s.scramble(random, .1, true);
    for (int round = 0; round < 2; ++round) {
      attachment.update(s.points);
      s.scramble(random, .02, true);
    }
    Positions gradient(s.points.size(), Vector_3::Zero());
    Block_matrix matrix(vertex_couplings(s.complex));
    matrix.set_zero();
    attachment.add_derivatives(s.points, gradient, matrix);
    double largest = 0;
    for (const Vector_3& g : gradient)
      largest = (std::max)(largest, g.norm());
    EXPECT_GT(largest, 0);
    for (std::size_t v = 0; v < s.points.size(); ++v) {
      if (!s.complex.is_on_boundary[v]) {
        EXPECT_EQ(gradient[v], Vector_3(Vector_3::Zero()));
      }
      EXPECT_GE(Eigen::SelfAdjointEigenSolver<Matrix_3>(matrix.diagonal[v]).eigenvalues().minCoeff(),
                -1e-9 * matrix.diagonal[v].norm());
    }
    for (int trial = 0; trial < 20; ++trial) { // along random directions
      const double h = 1e-6;
      Positions plus = s.points, minus = s.points;
      double slope = 0, size = 0;
      for (std::size_t v = 0; v < s.points.size(); ++v) {
        const Vector_3 d = random_vector(random, 1);
        plus[v] += h * d;
        minus[v] -= h * d;
        slope += gradient[v].dot(d);
        size += gradient[v].norm() * d.norm();
      }
      EXPECT_NEAR((attachment.energy(plus) - attachment.energy(minus)) / (2 * h), slope, 1e-6 * size);
    }
  }
}

TEST_P(Maximization, attachment_is_at_rest_on_the_reference)
{
  const Setting s(GetParam()());
  Surface_attachment attachment = s.surface_attachment();
  attachment.update(s.points);
  EXPECT_LT(attachment.largest_distance(s.points), .1); // not 0: the center of a quad may lie off both its triangles
  const double at_rest = attachment.energy(s.points);
  Positions moved = s.points;
  for (Vector_3& p : moved)
    p += Vector_3(.5, .5, .5);
  attachment.update(moved);
  EXPECT_GT(attachment.energy(moved), 100 * at_rest);
  EXPECT_GT(attachment.largest_distance(moved), .3);
}

// --- A whole run -------------------------------------------------------------------------------------

// Calls test with valid states of the mesh whose vertices were moved at random, those of the boundary a little in every
// second one
template <class Test>
void for_scrambled(const Mesh_family& family, const Test& test)
{
  std::mt19937 random(8);
  int valid = 0;
  for (int trial = 0; trial < 100 && valid < 4; ++trial) {
    SCOPED_TRACE(trial);
    Setting s(family());
    const double amplitude = .3 / (1 + .1 * trial);
    s.scramble(random, amplitude, false);
    if (trial % 2)
      s.scramble(random, .2 * amplitude, true);
    if (Mesh_quality(s.complex, s.points).invalid > 0)
      continue;
    ++valid;
    test(s);
  }
  EXPECT_EQ(valid, 4);
}

// The most iterations that the second phase takes to be fully tight
std::size_t tightening_iterations(const Maximization_parameters& p)
{
  return static_cast<std::size_t>(std::ceil(-std::log(p.start_tightness) / std::log(p.tightening))) * (p.waiting_patience + 1);
}

TEST_P(Maximization, keeps_a_valid_mesh_valid_and_its_minimum)
{
  for_scrambled(GetParam(), [](Setting& s) {
    const Mesh_quality before(s.complex, s.points);
    Run_control control;
    s.run(control);
    const Mesh_quality after(s.complex, s.points);
    EXPECT_EQ(after.invalid, 0u);
    EXPECT_GE(after.minimum, before.minimum);
    EXPECT_GT(after.average, before.average);
    EXPECT_GT(control.iterations, 0u);
    EXPECT_LE(control.iterations, s.parameters.climbing_iterations + s.parameters.longest_settling_iterations + tightening_iterations(s.parameters));
  });
}

TEST(Untangling, moves_what_is_near_inverted_corners_and_nothing_else)
{
  Indexed_mesh block;
  HMO::make_block(block.points, block.hexahedra, {{16, 5, 5}}, {{16, 5, 5}});
  Setting s(block);
  std::size_t displaced = 0; // the first interior vertex is near one end
  while (s.complex.is_on_boundary[displaced])
    ++displaced;
  s.points[displaced] += Vector_3(2.3, .7, .4);
  const Positions given = s.points;
  ASSERT_GT(Mesh_quality(s.complex, given).inverted, 0u);
  s.parameters.untangling_rings = 3;
  Surface_attachment attachment = s.surface_attachment();
  Run_control control;
  Untangling(s.complex, attachment, s.lengths, s.is_fixed, s.parameters).run(s.points, control);
  EXPECT_GE(Mesh_quality(s.complex, s.points).minimum, s.parameters.untangled);
  EXPECT_NE(s.points[displaced], given[displaced]);
  std::size_t far = 0;
  for (std::size_t v = 0; v < given.size(); ++v)
    if (std::abs(block.points[v].x() - block.points[displaced].x()) > 9) { // inverted ones may wander a little
      ++far;
      EXPECT_EQ(s.points[v], given[v]) << v;
    }
  EXPECT_GT(far, 30u);
}

TEST_P(Maximization, leaves_fixed_vertices_alone)
{
  for_scrambled(GetParam(), [](Setting& s) {
    for (std::size_t v = 0; v < s.points.size(); v += 3)
      s.fix(v);
    const Positions given = s.points;
    const Mesh_quality before(s.complex, given);
    Run_control control;
    s.run(control);
    for (std::size_t v = 0; v < given.size(); ++v)
      if (s.is_fixed[v]) {
        EXPECT_EQ(s.points[v], given[v]) << v;
      }
    EXPECT_NE(s.points, given);
    const Mesh_quality after(s.complex, s.points);
    EXPECT_EQ(after.invalid, 0u);
    EXPECT_GE(after.minimum, before.minimum);
  });
}

TEST_P(Maximization, leaves_a_fixed_boundary_alone)
{
  for_scrambled(GetParam(), [](Setting& s) {
    for (std::size_t v = 0; v < s.points.size(); ++v)
      if (s.complex.is_on_boundary[v])
        s.fix(v);
    const Positions given = s.points;
    Run_control control;
    s.run(control);
    for (std::size_t v = 0; v < given.size(); ++v)
      if (s.complex.is_on_boundary[v]) {
        EXPECT_EQ(s.points[v], given[v]) << v;
      }
    EXPECT_EQ(Mesh_quality(s.complex, s.points).invalid, 0u);
    EXPECT_GE(Mesh_quality(s.complex, s.points).minimum, Mesh_quality(s.complex, given).minimum);
  });
}

// It is no untangling
TEST_P(Maximization, does_nothing_to_a_mesh_with_an_inverted_corner)
{
  Setting s(GetParam()());
  const Hexahedron& h = s.complex.hexahedra[s.complex.hexahedra.size() / 2];
  std::swap(s.points[h[0]], s.points[h[6]]);
  ASSERT_GT(Mesh_quality(s.complex, s.points).inverted, 0u);
  const Positions given = s.points;
  Run_control control;
  s.run(control);
  EXPECT_EQ(s.points, given);
  EXPECT_EQ(control.iterations, 0u);
}

// The energy reported is finite and the state left is one that was met, whenever the run is stopped
TEST_P(Maximization, leaves_a_valid_mesh_when_it_is_stopped)
{
  for_scrambled(GetParam(), [](Setting& s) {
    const Positions given = s.points;
    for (std::size_t last : {1, 2, 5, 20}) {
      s.points = given;
      std::size_t seen = 0;
      Run_control control(std::numeric_limits<double>::infinity(), [&](const HMO::Iteration& iteration) {
        EXPECT_TRUE(std::isfinite(iteration.energy));
        EXPECT_EQ(iteration.number_of_inverted, 0u);
        return ++seen < last;
      });
      s.run(control);
      EXPECT_LE(seen, last);
      EXPECT_EQ(Mesh_quality(s.complex, s.points).invalid, 0u);
    }
  });
}

} // namespace
