// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Grids along the flat parts of a surface: their axes, and their planes.

#include "../Generated_surface.h"

#include <CGAL/Hex_mesh_optimization/internal/meshing/grid_planes.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/solid_voxels.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

Generated_mesh plate(double thickness)
{
  return Generated_mesh([=](auto& p, auto& h) {
    CGAL::Hex_mesh_optimization::make_block(p, h, {{2, 2, 1}}, {{4, 3, thickness}});
  });
}

Matrix_3 axes_of(const Reference_input& surface) { return grid_axes(surface.points, surface.triangles, {}); }

std::array<std::vector<double>, 3> planes_of(const Reference_input& surface, double spacing)
{
  return grid_planes(surface.points, surface.triangles, bounding_box(surface.points, surface.triangles), spacing, {});
}

double distance_to_nearest(const std::vector<double>& planes, double place)
{
  double result = std::abs(planes.front() - place);
  for (double plane : planes)
    result = (std::min)(result, std::abs(plane - place));
  return result;
}

// Two boxes, one on the other, with different thicknesses.
Reference_input steps(double lower, double upper)
{
  Reference_input result = surface_of(plate(lower));
  const Reference_input second = surface_of(Generated_mesh([=](auto& p, auto& h) {
    CGAL::Hex_mesh_optimization::make_block(p, h, {{2, 2, 1}}, {{2, 3, upper}});
  }));
  const int offset = static_cast<int>(result.points.size());
  result.points.insert(result.points.end(), second.points.begin(), second.points.end());
  for (const Triangle_indices& t : second.triangles)
    result.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return result;
}

TEST(grid_axes, are_those_of_a_turned_solid_whatever_the_order_of_its_sides)
{
  const Reference_input straight = surface_of(plate(.5));
  const Reference_input turned = surface_of(plate(.5), .7);
  EXPECT_EQ(axes_of(straight), Matrix_3::Identity());
  // each axis of the solid is one of the grid, up to the sign
  const Matrix_3 rotation = Eigen::AngleAxisd(.7, Vector_3(1, 2, 3).normalized()).toRotationMatrix();
  const Matrix_3 relative = (rotation.transpose() * axes_of(turned)).cwiseAbs();
  for (int d = 0; d < 3; ++d)
    EXPECT_NEAR(relative.col(d).maxCoeff(), 1, 1e-12);
  EXPECT_NEAR(axes_of(turned).determinant(), 1, 1e-12);
}

TEST(grid_axes, stay_where_no_others_suit_more_of_the_surface)
{
  const Reference_input ball =
    surface_of(Generated_mesh([](auto& p, auto& h) { CGAL::Hex_mesh_optimization::make_ball(p, h, 8); }), .7);
  EXPECT_EQ(axes_of(ball), Matrix_3::Identity());
}

TEST(grid_planes, lie_in_flat_parts_and_divide_what_is_between_evenly)
{
  const auto planes = planes_of(steps(1, 1.75), .5);
  EXPECT_NEAR(distance_to_nearest(planes[2], 1), 0, 1e-12);
  EXPECT_EQ(planes[2], (std::vector<double>{0, .5, 1, 1.375, 1.75}));
  EXPECT_EQ(planes[0].front(), 0);
  EXPECT_EQ(planes[0].back(), 4);
  EXPECT_NEAR(distance_to_nearest(planes[0], 2), 0, 1e-12);
}

// Between two flat parts that are about a cell apart there is room for a step.
TEST(grid_planes, divide_a_strip_between_flat_parts)
{
  const auto at = [](double upper) { return planes_of(steps(1, upper), .5)[2]; };
  EXPECT_EQ(at(1.5), (std::vector<double>{0, .5, 1, 1.25, 1.5}));
  EXPECT_EQ(at(1.625), (std::vector<double>{0, .5, 1, 1.3125, 1.625}));
  EXPECT_EQ(at(1.375), (std::vector<double>{0, .5, 1, 1.375})) << "narrow";
}

TEST(grid_planes, pass_over_what_is_small_or_close_to_another)
{
  const auto planes = planes_of(steps(1.7, 1.75), .5); // a step of a tenth of a cell
  EXPECT_GT(distance_to_nearest(planes[2], 1.7), .01);
  EXPECT_EQ(planes[2].back(), 1.75);
  const auto coarse = planes_of(steps(1, 3), 3); // a flat part of less than two cells
  EXPECT_EQ(coarse[2], (std::vector<double>{0, 3}));
}

} // namespace
