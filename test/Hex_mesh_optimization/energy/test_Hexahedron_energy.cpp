// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of a hexahedron against finite differences, and its symmetries.

#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_derivatives.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Distance_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Lanes.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Quality_floor.h>
#include <CGAL/Hex_mesh_optimization/internal/untangling/Untangling.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>

#include "../Corner.h"
#include "../hexahedron_rotations.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;
using Lengths = std::array<double, 12>; // targets of the edges
using Floor = std::array<double, 8>;    // of the corners
using Corners = std::array<Vector_3, 8>;

Matrix_3 random_rotation(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
    .normalized()
    .toRotationMatrix();
}

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
  double certainty = 0;

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

  double value(const Hexahedron_energy& energy) const
  {
    return energy.value(frame(), inverse_targets().data(), floor.data(), certainty);
  }

  Hexahedron_derivatives<double> derivatives(const Hexahedron_energy& energy) const
  {
    Hexahedron_derivatives<double> result;
    energy.derivatives(frame(), inverse_targets().data(), floor.data(), result, certainty);
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

// Boxes from slightly to badly distorted; target lengths from their own ones to others altogether; floors below, among
// and above the scaled Jacobians
template <class Test>
void for_random_elements(int trials, const Test& test)
{
  std::mt19937 random(7);
  int valid = 0;
  for (int trial = 0; valid < trials; ++trial) {
    SCOPED_TRACE(trial);
    const double flatness = trial % 3, distortion = .1 + .05 * (trial % 8), freedom = trial % 4 * .4,
                 floor = trial % 5 * .3;
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
    e.certainty = trial % 3 / 2.;
    test(e, random);
    if (::testing::Test::HasFailure())
      return;
  }
}

TEST(Hexahedron_energy, has_the_gradient_of_its_value)
{
  const Hexahedron_energy energy((Hexahedron_energy_parameters()));
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
  const Hexahedron_energy energy((Hexahedron_energy_parameters()));
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
  const Hexahedron_energy energy((Hexahedron_energy_parameters()));
  std::vector<Element> elements;
  for_random_elements(101, [&](const Element& e, std::mt19937&) { elements.push_back(e); });
  ASSERT_EQ(elements.size(), 101u);
  for (std::size_t first = 0; first < elements.size(); first += number_of_lanes) {
    Lanes vectors[12][3] = {}, inverse_targets[12] = {}, floor[8] = {}, certainty = {};
    const auto element = [&](int l) -> const Element& { return elements[(std::min)(first + l, elements.size() - 1)]; };
    for (int l = 0; l < number_of_lanes; ++l) {
      float one[12][3];
      edge_vectors(Positions(element(l).x.begin(), element(l).x.end()), {0, 1, 2, 3, 4, 5, 6, 7}, one);
      for (int k = 0; k < 12; ++k) {
        for (int a = 0; a < 3; ++a)
          set_lane(vectors[k][a], l, one[k][a]);
        set_lane(inverse_targets[k], l, static_cast<float>(element(l).inverse_targets()[k]));
      }
      set_lane(certainty, l, static_cast<float>(element(l).certainty));
      for (int c = 0; c < 8; ++c)
        set_lane(floor[c], l, static_cast<float>(element(l).floor[c]));
    }
    const Hexahedron_frame<Lanes> frame(vectors);
    const Lanes values = energy.value(frame, inverse_targets, floor, certainty);
    Hexahedron_derivatives<Lanes> d;
    const Lanes with_derivatives = energy.derivatives(frame, inverse_targets, floor, d, certainty);
    for (int l = 0; l < number_of_lanes; ++l) {
      const double value = element(l).value(energy);
      EXPECT_NEAR(lane(values, l), value, 1e-4 * value);
      EXPECT_NEAR(lane(with_derivatives, l), value, 1e-4 * value);
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
      const auto gradient = [](const Hexahedron_derivatives<double>& of) {
        return Eigen::Map<const Eigen::Matrix<double, 24, 1>>(&of.gradient[0][0]);
      };
      EXPECT_LT((gradient(found) - gradient(expected)).norm(), 1e-4 * gradient(expected).norm() + 1e-5 * A.norm());
    }
  }
}

// Where the model has the most to do: a corner that is all but flat
TEST(Hexahedron_energy, has_a_model_of_the_hessian_next_to_inversion)
{
  const Hexahedron_energy energy((Hexahedron_energy_parameters()));
  for (double height : {1e-1, 1e-3, 1e-6}) {
    SCOPED_TRACE(height);
    Element e{box(Vector_3(1, 1, 1)), {}, {}, 0};
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
  const Hexahedron_energy energy((Hexahedron_energy_parameters()));
  std::mt19937 random(3);
  int inverted = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    Element e{box(Vector_3(1, 1, 1)), {}, {}, 0};
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

  Element flat{box(Vector_3(1, 1, 1)), {}, {}, 0};
  flat.lengths.fill(1);
  flat.x[0] = Vector_3(.5, .5, 0); // on a line with its neighbors 1 and 3
  EXPECT_EQ(worst_corner(flat.x), 0);
  EXPECT_GT(flat.value(energy), 1e4); // the scaled Jacobian may be a rounding error above 0
  flat.x[1] = flat.x[0];              // an edge without length
  EXPECT_EQ(flat.value(energy), std::numeric_limits<double>::infinity());
}

TEST(Hexahedron_energy, does_not_depend_on_place_and_unit_of_length)
{
  const Hexahedron_energy energy((Hexahedron_energy_parameters()));
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
  const Hexahedron_energy energy((Hexahedron_energy_parameters()));
  const auto rotations = numberings(1);
  ASSERT_EQ(rotations.size(), 24u);
  for_random_elements(20, [&](const Element& e, std::mt19937&) {
    for (const auto& rotation : rotations) {
      Element image;
      image.certainty = e.certainty;
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
  const Hexahedron_energy energy((Hexahedron_energy_parameters()));
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

} // namespace
