// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts of a surface that stay apart: their regions, the surfaces between them, and hexahedra with labels.

#include "../Random_parts.h"

#include <CGAL/Hex_mesh_optimization/internal/meshing/Region_mesher.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Region_surfaces.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/surface_components.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/volume.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace {

constexpr int no_region = Reference_input::no_label;

// Parts, with the label of each triangle.
struct Assembly
{
  Reference_input surface;
  std::vector<int> labels;

  Assembly& add(const Reference_input& part, int label)
  {
    append(surface, part);
    labels.resize(surface.triangles.size(), label);
    return *this;
  }
};

Reference_input ball_surface(const Vector_3& center, double radius)
{
  Reference_input result =
    surface_of(Generated_mesh([](auto& p, auto& h) { CGAL::Hex_mesh_optimization::make_ball(p, h, 6); }), .3);
  for (Vector_3& p : result.points)
    p = radius * p + center;
  return result;
}

Region_surfaces regions(const Assembly& a) { return Region_surfaces(a.surface, a.labels, 1000, 0); }

double area_between(const Region_surfaces& r, int a, int b)
{
  std::vector<Triangle_indices> between;
  for (std::size_t t = 0; t < r.surface.triangles.size(); ++t)
    if (r.surface.labels[t] == std::array{a, b})
      between.push_back(r.surface.triangles[t]);
  return surface_area(r.surface.points, between);
}

TEST(Region_surfaces, of_touching_boxes_have_an_interface_where_they_touch)
{
  const Region_surfaces r = regions(
    Assembly().add(box_surface({0, 0, 0}, {1, 1, 1}), 3).add(box_surface({1, .25, .25}, {2, .75, .75}), 7));
  EXPECT_NEAR(area_between(r, 3, 7), .25, 1e-12);
  EXPECT_NEAR(area_between(r, 3, no_region), 5.75, 1e-12);
  EXPECT_NEAR(area_between(r, 7, no_region), 2.25, 1e-12);
  EXPECT_NEAR(r.report.volume, 1.25, 1e-12);
  EXPECT_EQ(r.report.number_of_bodies, 1u);
}

TEST(Region_surfaces, of_overlapping_parts_are_those_of_the_higher_label)
{
  for (bool exchanged : {false, true}) {
    const Region_surfaces r = regions(Assembly()
                                        .add(box_surface({0, 0, 0}, {1, 1, 1}), exchanged ? 2 : 1)
                                        .add(box_surface({.5, .5, .5}, {1.5, 1.5, 1.5}), exchanged ? 1 : 2));
    ASSERT_EQ(r.materials.size(), 2u);
    EXPECT_NEAR(r.materials[0].volume, .875, 1e-12);
    EXPECT_NEAR(r.materials[1].volume, 1, 1e-12);
    EXPECT_NEAR(area_between(r, 1, 2), .75, 1e-12);
  }
}

TEST(Region_surfaces, know_bodies_and_topology_of_what_is_left_of_parts)
{
  // a bar is cut in two by another one across it, and a box has a ball in it
  const Region_surfaces r = regions(Assembly()
                                      .add(box_surface({0, 0, 0}, {3, 1, 1}), 1)
                                      .add(box_surface({1, -1, -1}, {2, 2, 2}), 2)
                                      .add(ball_surface({1.5, .5, .5}, .3), 3));
  ASSERT_EQ(r.materials.size(), 3u);
  EXPECT_EQ(r.materials[0].number_of_bodies, 2u);
  EXPECT_EQ(r.materials[1].number_of_bodies, 1u);
  EXPECT_EQ(r.materials[1].euler_characteristic, 4); // with the cavity
  EXPECT_EQ(r.materials[2].euler_characteristic, 2);
  EXPECT_EQ(r.report.number_of_bodies, 1u);
}

// A pin in a hole, of other numbers of sides: slivers of gaps, or of overlaps, are closed.
TEST(Region_surfaces, of_parts_with_a_curved_surface_in_common_have_one)
{
  const auto pipe = [](int n, double inner, double outer, double low, double high) {
    Reference_input result;
    for (double z : {low, high})
      for (double radius : {inner, outer})
        for (int i = 0; i < n; ++i)
          result.points.emplace_back(radius * std::cos(2 * CGAL_PI * i / n), radius * std::sin(2 * CGAL_PI * i / n), z);
    const auto quad = [&](int a, int b, int c, int d) {
      result.triangles.push_back({a, b, c});
      result.triangles.push_back({a, c, d});
    };
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n;
      quad(n + i, n + j, 3 * n + j, 3 * n + i);
      quad(j, i, 2 * n + i, 2 * n + j);
      quad(2 * n + i, 3 * n + i, 3 * n + j, 2 * n + j);
      quad(n + i, i, j, n + j);
    }
    return result;
  };
  for (bool exchanged : {false, true}) {
    const Region_surfaces r = regions(
      Assembly().add(pipe(37, .2, .5, -.3, 1.3), exchanged ? 2 : 1).add(pipe(48, .5, 1, 0, 1), exchanged ? 1 : 2));
    EXPECT_EQ(r.report.number_of_bodies, 1u);
    EXPECT_EQ(r.report.euler_characteristic, 0);
    EXPECT_NEAR(area_between(r, 1, 2), CGAL_PI, .02 * CGAL_PI);
    EXPECT_GT(r.report.number_of_aligned_vertices, 0u);
  }
}

TEST(Region_surfaces, are_closed_around_each_region)
{
  const Region_surfaces r = regions(Assembly()
                                      .add(box_surface({-1, -1, -1}, {1, 1, 1}), 0)
                                      .add(ball_surface({0, 0, 1}, .7), 1)
                                      .add(ball_surface({.3, .2, .9}, .5), -2));
  for (int label : {-2, 0, 1}) {
    std::map<std::array<int, 2>, int> balance;
    for (const Triangle_indices& t : triangles_around(r.surface, label))
      for (int k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        balance[{(std::min)(a, b), (std::max)(a, b)}] += a < b ? 1 : -1;
      }
    for (const auto& [edge, sum] : balance)
      EXPECT_EQ(sum, 0);
  }
}

TEST(Region_surfaces, of_a_part_within_a_later_one_are_none)
{
  const Region_surfaces r = regions(
    Assembly().add(ball_surface({0, 0, 0}, .5), 1).add(box_surface({-1, -1, -1}, {1, 1, 1}), 2));
  EXPECT_NEAR(r.materials[0].volume, 0, 1e-12);
  EXPECT_NEAR(r.materials[1].volume, 8, 1e-12);
}

TEST(Region_surfaces, name_the_part_that_bounds_no_volume)
{
  Assembly open = Assembly().add(box_surface({0, 0, 0}, {1, 1, 1}), 1).add(box_surface({2, 0, 0}, {3, 1, 1}), 2);
  open.surface.triangles.pop_back();
  open.surface.triangles.pop_back();
  open.labels.resize(open.surface.triangles.size());
  try {
    regions(open);
    FAIL();
  }
  catch (const CGAL::Hex_mesh_optimization::Input_error& error) {
    EXPECT_EQ(std::string(error.what()).rfind("part 2: ", 0), 0u) << error.what();
  }
}

TEST(surface_components, are_closed_parts_even_where_they_share_vertices_or_faces)
{
  // two boxes of one set of points, with a common side
  Reference_input two = box_surface({0, 0, 0}, {1, 1, 1});
  const Reference_input other = box_surface({1, 0, 0}, {2, 1, 1});
  std::map<std::array<double, 3>, int> at;
  for (std::size_t v = 0; v < two.points.size(); ++v)
    at[{two.points[v][0], two.points[v][1], two.points[v][2]}] = static_cast<int>(v);
  for (const Triangle_indices& t : other.triangles) {
    Triangle_indices triangle;
    for (int k = 0; k < 3; ++k) {
      const Vector_3& p = other.points[t[k]];
      const auto inserted = at.emplace(std::array<double, 3>{p[0], p[1], p[2]}, static_cast<int>(two.points.size()));
      if (inserted.second)
        two.points.push_back(p);
      triangle[k] = inserted.first->second;
    }
    two.triangles.push_back(triangle);
  }
  const std::vector<int> labels = surface_components(two.points, two.triangles);
  ASSERT_EQ(labels.size(), 24u);
  for (std::size_t t = 0; t < 24; ++t)
    EXPECT_EQ(labels[t], t < 12 ? 1 : 2);
}

TEST(surface_components, have_their_cavities)
{
  Assembly hollow = Assembly().add(box_surface({0, 0, 0}, {3, 3, 3}), 0).add(box_surface({1, 1, 1}, {2, 2, 2}), 0);
  for (std::size_t t = 12; t < 24; ++t)
    std::swap(hollow.surface.triangles[t][1], hollow.surface.triangles[t][2]);
  hollow.add(box_surface({5, 0, 0}, {6, 1, 1}), 0);
  const std::vector<int> labels = surface_components(hollow.surface.points, hollow.surface.triangles);
  for (std::size_t t = 0; t < 36; ++t)
    EXPECT_EQ(labels[t], t < 24 ? 1 : 2);
}

Meshing_parameters about(std::size_t number)
{
  Meshing_parameters parameters;
  parameters.number_of_hexahedra = number;
  return parameters;
}

double volume_of(const Hexahedra& mesh, std::size_t h)
{
  Vector_3 corners[8];
  for (int c = 0; c < 8; ++c)
    corners[c] = mesh.points[mesh.hexahedra[h][c]];
  return volume(corners);
}

// Volumes of the hexahedra of each label.
std::map<int, double> volumes(const Region_mesher& mesher)
{
  std::map<int, double> result;
  for (std::size_t h = 0; h < mesher.mesh.hexahedra.size(); ++h)
    result[mesher.region[h]] += volume_of(mesher.mesh, h);
  return result;
}

TEST(Region_mesher, has_regions_of_the_right_volume_and_about_the_number)
{
  const std::vector<Assembly> assemblies = {
    Assembly().add(box_surface({0, 0, 0}, {1, 1, 1}), 1).add(box_surface({1, 0, 0}, {2, 1, 1}), 2),
    Assembly().add(box_surface({0, 0, 0}, {1, 1, 1}), 1).add(box_surface({.3, .3, .3}, {.7, .7, .7}), 2),
    Assembly().add(ball_surface({0, 0, 0}, 1), 1).add(ball_surface({1, .2, .1}, .8), 2),
    Assembly().add(box_surface({-1, -1, -1}, {1, 1, 0}), 1).add(ball_surface({.1, .2, .1}, .6), 2)};
  for (const Assembly& a : assemblies) {
    const Region_surfaces r = regions(a);
    const Region_mesher mesher(r.surface, r.materials, about(1500));
    ASSERT_EQ(mesher.region.size(), mesher.mesh.hexahedra.size());
    EXPECT_GT(mesher.mesh.hexahedra.size(), 1100u);
    EXPECT_LT(mesher.mesh.hexahedra.size(), 2400u);
    EXPECT_TRUE(mesher.unresolved.empty());
    std::map<int, double> volume = volumes(mesher);
    EXPECT_EQ(volume.size(), r.materials.size());
    for (const auto& material : r.materials)
      EXPECT_NEAR(volume[material.label], material.volume, .05 * material.volume);
  }
}

TEST(Region_mesher, divides_touching_boxes_along_their_grid)
{
  const Region_surfaces r = regions(
    Assembly().add(box_surface({0, 0, 0}, {1, 1, 1}), 1).add(box_surface({1, .25, .25}, {1.5, .75, .75}), 2));
  Meshing_parameters parameters;
  parameters.spacing = .125;
  const Region_mesher mesher(r.surface, r.materials, parameters);
  EXPECT_EQ(mesher.mesh.hexahedra.size(), 8u * 8 * 8 + 4 * 4 * 4);
  EXPECT_EQ(std::count(mesher.region.begin(), mesher.region.end(), 2), 64);
}

TEST(Region_mesher, lists_triangles_with_no_cell_of_their_region_behind_them)
{
  // a sheet between two boxes that is thinner than what gets a row of cells
  const Region_surfaces r = regions(Assembly()
                                      .add(box_surface({0, 0, 0}, {1, 1, 1}), 1)
                                      .add(box_surface({0, 0, 1}, {1, 1, 1.02}), 2)
                                      .add(box_surface({0, 0, 1.02}, {1, 1, 2}), 3));
  Meshing_parameters parameters;
  parameters.spacing = .25;
  const Region_mesher mesher(r.surface, r.materials, parameters);
  EXPECT_FALSE(mesher.thin_triangles.empty());
  for (std::size_t t : mesher.thin_triangles)
    EXPECT_TRUE(r.surface.labels[t][0] == 2 || r.surface.labels[t][1] == 2);
}

} // namespace
