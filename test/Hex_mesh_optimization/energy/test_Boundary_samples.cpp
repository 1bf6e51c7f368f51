// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The samples that hold interfaces: bounded without a bound being asked for, each on its own sheet.

#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>

#include "../block_of_cubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Cubes below z = 2 and above it, in one region or in two
struct Layers
{
  Block block{4, 4, 4};
  Hexahedral_complex complex;
  Surface_faces faces;
  std::unique_ptr<Reference_surface> surface;
  Boundary_attachment attachment;
  std::vector<double> lengths;
  Boundary_sample_parameters parameters;

  explicit Layers(bool is_divided, bool outside_is_one = false)
    : complex(block.points.size(), block.hexahedra, {is_divided ? labels() : std::vector<int>(), {}})
    , faces(boundary_surface_faces(complex, outside_is_one))
    , surface(boundary_as_reference(complex, faces, block.points, Feature_parameters()))
    , attachment(attach_to_own_boundary(complex, *surface))
    , lengths(edge_lengths(complex, block.points))
  {
    attachment.set_sheets(faces);
  }

  std::vector<int> labels() const
  {
    std::vector<int> result;
    for (const Hexahedron& h : block.hexahedra)
      result.push_back(block.points[h[0]][2] < 2 ? 1 : 2);
    return result;
  }

  Boundary_samples samples(double maximum_deviation = infinity) const
  {
    return Boundary_samples(complex, faces, *surface, attachment, lengths, false, maximum_deviation, parameters);
  }
};

TEST(Boundary_samples, are_bounded_where_there_is_an_interface)
{
  EXPECT_FALSE(Layers(false).samples().is_bounded());
  EXPECT_FALSE(Layers(false).samples().has_tolerance());
  const Layers layers(true);
  Boundary_samples samples = layers.samples();
  EXPECT_TRUE(samples.is_bounded());
  EXPECT_FALSE(samples.is_bounded_everywhere());
  samples.update(layers.block.points, 1);
  int of_interface = 0;
  for (const Boundary_sample& s : samples.samples()) {
    const bool is_on_interface = layers.faces.is_interface(s.face);
    of_interface += is_on_interface;
    EXPECT_EQ(std::isfinite(s.bound), is_on_interface);
    if (is_on_interface) {
      EXPECT_NEAR(s.bound, layers.parameters.kept_part * layers.parameters.interface_deviation, 1e-12);
    }
  }
  EXPECT_GT(of_interface, 16 * 9) << "on a lattice in each face";
  Boundary_samples bounded = layers.samples(.01);
  EXPECT_TRUE(bounded.is_bounded_everywhere());
  bounded.update(layers.block.points, 1);
  for (const Boundary_sample& s : bounded.samples())
    EXPECT_NEAR(s.bound, layers.parameters.kept_part * .01, 1e-12) << "the lower of two bounds";
}

// What the samples see already is seen by the added ones as well, which stay from then on.
TEST(Boundary_samples, are_added_where_the_mesh_is_beyond_the_bound)
{
  const Layers layers(false);
  Boundary_samples samples = layers.samples(.1);
  samples.update(layers.block.points, 1);
  const std::size_t before = samples.samples().size();
  EXPECT_FALSE(samples.add_where_beyond(layers.block.points));
  EXPECT_EQ(samples.samples().size(), before) << "without another update";

  Positions raised = layers.block.points;
  std::size_t top = raised.size(); // within the face z = 4
  for (std::size_t v = 0; v < raised.size(); ++v)
    if (raised[v] == Vector_3(2, 2, 4))
      top = v;
  ASSERT_LT(top, raised.size());
  raised[top].z() += .3;
  samples.update(raised, 1);
  const double excess = samples.excess(raised);
  EXPECT_GT(excess, 0);
  EXPECT_TRUE(samples.add_where_beyond(raised));
  samples.update(raised, 1);
  EXPECT_GT(samples.samples().size(), before);
  EXPECT_NEAR(samples.excess(raised), excess, .02 * excess) << "the vertex itself was the farthest place";
  samples.update(layers.block.points, 1);
  EXPECT_EQ(samples.excess(layers.block.points), 0) << "all of them follow";
}

// The wall of a sample is what is left to it of its multiplier: nothing but the least where it is far from its bound.
TEST(Boundary_samples, keep_their_walls_only_where_they_come_near_the_bound)
{
  const Layers layers(false);
  const Boundary_sample_parameters& parameters = layers.parameters;
  Boundary_samples samples = layers.samples(.1);
  samples.update(layers.block.points, 1);
  for (const Boundary_sample& s : samples.samples())
    ASSERT_EQ(s.hold, 1);
  samples.adapt_walls(layers.block.points);
  for (const Boundary_sample& s : samples.samples())
    EXPECT_EQ(s.hold, parameters.wall_fading);
  for (int i = 0; i < 20; ++i)
    samples.adapt_walls(layers.block.points);
  for (const Boundary_sample& s : samples.samples())
    EXPECT_EQ(s.hold, parameters.least_wall);

  Positions raised = layers.block.points;
  const auto top = std::find(raised.begin(), raised.end(), Vector_3(2, 2, 4));
  ASSERT_NE(top, raised.end());
  top->z() += .3;
  samples.update(raised, 1);
  samples.adapt_walls(raised);
  int returned = 0, faded = 0;
  for (const Boundary_sample& s : samples.samples()) {
    const double part = s.offset(raised).norm() / (parameters.aimed_part * s.bound);
    if (part > 1) {
      EXPECT_NEAR(s.hold, parameters.least_wall * (std::min)(parameters.wall_return, part * part), 1e-12);
      ++returned;
    }
    else {
      EXPECT_EQ(s.hold, parameters.least_wall);
      ++faded;
    }
  }
  EXPECT_GT(returned, 5);
  EXPECT_GT(faded, 5);
  ASSERT_TRUE(samples.add_where_beyond(raised));
  samples.update(raised, 1);
  int full = 0;
  for (const Boundary_sample& s : samples.samples())
    full += s.hold == 1;
  EXPECT_GT(full, 0) << "the new ones";
  int returned_now = 0;
  for (const Boundary_sample& s : samples.samples())
    returned_now += s.hold > parameters.least_wall && s.hold < 1;
  EXPECT_EQ(returned_now, returned) << "the others keep theirs, wherever they are in the order now";
  samples.restore_walls();
  samples.update(raised, 1);
  for (const Boundary_sample& s : samples.samples())
    EXPECT_EQ(s.hold, 1);

  const Layers divided(true);
  Boundary_samples of_interface = divided.samples();
  of_interface.update(divided.block.points, 1);
  of_interface.adapt_walls(divided.block.points);
  for (const Boundary_sample& s : of_interface.samples())
    EXPECT_EQ(s.hold, 1) << "without a bound of all";
}

// What would be little for the edges is a lot where the solid is thin.
TEST(Boundary_samples, of_the_surface_have_the_thickness_as_their_scale_where_it_is_less_than_an_edge)
{
  for (double height : {.01, 3.}) {
    Block plate(3, 3, 1);
    for (Vector_3& p : plate.points)
      p.z() *= height;
    const Hexahedral_complex complex = plate.complex();
    const Surface_faces faces = boundary_surface_faces(complex);
    const auto surface = boundary_as_reference(complex, faces, plate.points, Feature_parameters());
    const Boundary_attachment attachment = attach_to_own_boundary(complex, *surface);
    const std::vector<double> lengths = edge_lengths(complex, plate.points);
    Boundary_samples samples(complex, faces, *surface, attachment, lengths, false, infinity,
                             Boundary_sample_parameters());
    samples.update(plate.points, 1);
    int on_plate = 0;
    for (const Boundary_sample& s : samples.samples()) {
      const auto& q = faces.quads[s.face];
      const bool is_flat = std::all_of(q.begin(), q.end(),
                                       [&](int v) { return plate.points[v].z() == plate.points[q[0]].z(); });
      if (is_flat && s.kind == Vertex_kind::SURFACE) {
        ++on_plate;
        EXPECT_LE(s.scale, height);
        EXPECT_TRUE(height > 1 || std::abs(s.scale - height) < 1e-12);
      }
      if (s.kind == Vertex_kind::FEATURE) {
        EXPECT_GT(s.scale, .5) << "whatever the height";
      }
    }
    EXPECT_GT(on_plate, 18);
  }
}

// Beyond the bound of the interface, and at the same distance on the outer boundary
TEST(Boundary_samples, exceed_the_bound_of_an_interface_only_there)
{
  const Layers layers(true);
  const double way = 2 * layers.parameters.interface_deviation;
  for (const bool on_interface : {true, false}) {
    Boundary_samples samples = layers.samples();
    Positions points = layers.block.points;
    points[layers.block.vertex(2, 2, on_interface ? 2 : 4)][2] += way;
    samples.update(points, 1);
    if (on_interface) {
      EXPECT_NEAR(samples.excess(points),
                  way / (layers.parameters.kept_part * layers.parameters.interface_deviation) - 1, 1e-6);
    }
    else {
      EXPECT_EQ(samples.excess(points), 0);
    }
    // the hexahedra on both sides of the interface, or none
    std::vector<char> is_leaving(layers.block.hexahedra.size(), false);
    Boundary_samples at_rest = layers.samples();
    at_rest.update(layers.block.points, 1);
    at_rest.find_leaving(layers.block.points, points, layers.complex, is_leaving);
    for (std::size_t h = 0; h < is_leaving.size(); ++h) {
      const Hexahedron& vertices = layers.block.hexahedra[h];
      const bool has_vertex = std::count(vertices.begin(), vertices.end(), layers.block.vertex(2, 2, 2)) > 0;
      EXPECT_EQ(bool(is_leaving[h]), on_interface && has_vertex) << h;
    }
  }
}

// Where the outside has a reference of its own, an interface goes along with it in its plane.
TEST(Boundary_samples, of_an_interface_are_free_beyond_its_rim_but_across)
{
  Layers layers(true, true);
  const std::vector<Triangle_indices> triangles = split_quads(layers.faces.quads);
  const std::vector<int> sheets = triangle_sheets(layers.faces);
  layers.surface = std::make_unique<Reference_surface>(layers.block.points, triangles, Edge_list(), false,
                                                       Feature_parameters(), sheets, std::vector<int>(),
                                                       Rims(triangles, sheets, rim_sides(layers.faces),
                                                            Beyond_rim::PLANE));
  layers.attachment = Boundary_attachment(layers.complex);
  layers.attachment.set_sheets(layers.faces);
  for (double factor : {.6, 1.4})
    for (double height : {0., .2}) {
      Positions points = layers.block.points;
      for (Vector_3& p : points)
        p = Vector_3(2 + factor * (p[0] - 2), 2 + factor * (p[1] - 2), p[2] + height);
      Boundary_samples samples = layers.samples();
      samples.update(points, 1);
      double least = infinity, largest = 0;
      int of_mesh = 0;
      for (const Boundary_sample& s : samples.samples())
        if (layers.faces.is_interface(s.face)) {
          largest = (std::max)(largest, s.offset(points).norm());
          if (s.count != 3) { // not of the reference
            least = (std::min)(least, s.offset(points).norm());
            ++of_mesh;
          }
        }
      EXPECT_NEAR(largest, height, 1e-9);
      EXPECT_NEAR(least, height, 1e-9) << "at the rim too";
      EXPECT_GT(of_mesh, 16 * 9);
    }
}

// Close to another sheet, what belongs to the interface is drawn to the interface.
TEST(Boundary_samples, have_their_targets_in_their_own_sheet)
{
  const Layers layers(true);
  Positions points = layers.block.points;
  for (Vector_3& p : points)
    if (p[2] == 2)
      p[2] = 3.8; // nearly at the top
  Boundary_samples samples = layers.samples();
  samples.update(points, 1);
  for (const Boundary_sample& s : samples.samples())
    if (layers.faces.is_interface(s.face)) {
      EXPECT_NEAR(s.offset(points).norm(), 1.8, 1e-9);
    }
}

} // namespace
