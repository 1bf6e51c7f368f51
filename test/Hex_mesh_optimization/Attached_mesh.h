// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_ATTACHED_MESH_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_ATTACHED_MESH_H

// A mesh with all that its energies need, attached to its own boundary.

#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Surface_faces.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_parameters.h>

#include "mesh_families.h"
#include "random_positions.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace test {

using namespace CGAL::Hex_mesh_optimization::internal;

struct Attached_mesh
{
  Hexahedral_complex complex;
  Positions points; // in units of the mean boundary edge
  Surface_faces faces;
  std::unique_ptr<Reference_surface> surface;
  Boundary_attachment attachment;
  Edge_relations relations;
  std::vector<double> lengths;
  std::vector<char> is_fixed;
  double maximum_deviation = std::numeric_limits<double>::infinity();
  Boundary_parameters boundary;

  explicit Attached_mesh(const Indexed_mesh& mesh)
    : complex(mesh.complex())
    , points(normalized(complex, positions(mesh)))
    , faces(boundary_surface_faces(complex))
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

  // The mesh must outlive them.
  Boundary_samples samples() const
  {
    return Boundary_samples(complex, faces, *surface, attachment, lengths, false, maximum_deviation, boundary.samples);
  }

  using Placement = CGAL::Hex_mesh_optimization::Boundary_placement;

  Sliding sliding(Placement placement = Placement::WITHIN_TOLERANCE) const
  {
    return Sliding(*surface, attachment, placement, points);
  }

  Distance_energy distance() const { return boundary_distance_energy(*surface, false, boundary); }

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

} // namespace test

using namespace test;

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_ATTACHED_MESH_H
