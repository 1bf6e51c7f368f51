// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_REPORT_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_REPORT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What the run has come to: the result is certified, compared with what came in, and
// measured, all in the coordinates and the numbering that the caller gets.

#include <CGAL/Hex_mesh_optimization/Connectivity_limit.h>
#include <CGAL/Hex_mesh_optimization/Deviation.h>
#include <CGAL/Hex_mesh_optimization/Quality_statistics.h>
#include <CGAL/Hex_mesh_optimization/Status.h>
#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/certified_deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/connectivity_limits.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Checked_mesh.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Model.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Optimization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Jacobian_certificate.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Merit.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/scaled_jacobian.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/volume.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Hex_mesh_optimization::internal {

class Report
{
public:
  // All must outlive the object.
  Report(const Checked_mesh& mesh, const Model& model, const Optimization_parameters& parameters)
    : mesh_(mesh)
    , model_(model)
    , parameters_(parameters)
    , positions_(mesh.points)
  {
    status.reoriented_hexahedra = mesh.reoriented_hexahedra;
    status.number_of_coincident_vertices = mesh.number_of_coincident_vertices;
    status.before = mesh.statistics(mesh.points);
    std::vector<int> labels = mesh.complex.labels.empty() ? std::vector<int>(1, 0) : mesh.complex.labels;
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    for (int label : labels)
      status.regions.push_back({label, 0, 0});
    status.volume_before = measure_volumes(mesh.points, &Region_volume::before);
  }

  // Takes the result, in the coordinates of the input: the final statistics are those of the coordinates handed out, so
  // that no rounding undoes what they say. What is worse than the input is not taken, but the input. excess_before and
  // excess: of the boundaries of both over what is tolerated without a bound.
  void certify(Positions result, double excess_before, double excess)
  {
    positions_ = std::move(result);
    is_off_ = excess > 0 || away(positions_).in_all > 0;
    status.after = mesh_.statistics(positions_);
    Deviations measured = measured_deviations(positions_);
    status.deviation_bound = parameters_.maximum_deviation;
    status.deviation = measured.all;
    if (is_perfect() || is_worse(excess_before, excess)) {
      positions_ = mesh_.points;
      is_off_ = excess_before > 0 || away(mesh_.points).in_all > 0;
      status.after = status.before;
      measured = measured_deviations(mesh_.points);
      status.deviation = measured.all;
    }
    for (std::size_t s = 0; s < model_.faces.labels.size(); ++s)
      if (model_.faces.labels[s][1] != Surface_faces::no_label)
        status.interfaces.push_back(
          {model_.faces.labels[s], model_.faces.size_of_sheet(static_cast<int>(s)), measured.of_sheet[s]});
    status.volume_after = measure_volumes(positions_, &Region_volume::after);
    find_volume_changes();
    for (std::size_t h = 0; h < mesh_.complex.hexahedra.size(); ++h)
      if (hexahedron_validity(hexahedron_coordinates(positions_, mesh_.complex.hexahedra[h])) != Validity::VALID) {
        status.invalid_hexahedra.push_back(mesh_.order.given_hexahedron(h));
        if (is_locked(mesh_.complex.hexahedra[h]))
          status.locked_hexahedra.push_back(mesh_.order.given_hexahedron(h));
      }
    for (int v : sliding(positions_).vertices_away())
      status.vertices_off_reference.push_back(mesh_.order.given_vertex(v));
    std::sort(status.vertices_off_reference.begin(), status.vertices_off_reference.end());
    for (Connectivity_limit limit : connectivity_limits(mesh_.complex, model_.attachment)) {
      limit.scaled_jacobian = scaled_jacobian(
        hexahedron_coordinates(positions_, mesh_.complex.hexahedra[limit.hexahedron]));
      if (limit.scaled_jacobian <= limit.largest_scaled_jacobian) {
        limit.hexahedron = mesh_.order.given_hexahedron(limit.hexahedron);
        status.connectivity_limits.push_back(limit);
      }
    }
    std::sort(status.invalid_hexahedra.begin(), status.invalid_hexahedra.end());
    std::sort(status.locked_hexahedra.begin(), status.locked_hexahedra.end());
    std::sort(status.connectivity_limits.begin(), status.connectivity_limits.end(),
              [](const Connectivity_limit& a, const Connectivity_limit& b) { return a.hexahedron < b.hexahedron; });
  }

  // Why the run ended, as far as the result says so; otherwise: where it does not.
  Return_code return_code(Return_code otherwise) const
  {
    if (!status.is_within_deviation_bound())
      return Return_code::DEVIATION_BOUND_NOT_MET;
    if (positions_ == mesh_.points)
      return Return_code::NO_IMPROVEMENT;
    if (status.valid_mesh() && status.after.minimum >= parameters_.target_quality && !is_off_)
      return Return_code::TARGET_QUALITY_REACHED;
    return otherwise;
  }

  Status status;

  const Positions& positions() const { return positions_; }

private:
  Deviations measured_deviations(const Positions& positions) const
  {
    Deviations result = deviations(model_.faces, model_.in_units(positions), *model_.surface,
                                   parameters_.measuring_spacing);
    const auto scale = [&](Deviation& d) {
      d.average *= model_.unit;
      d.maximum *= model_.unit;
    };
    scale(result.all);
    for (Deviation& d : result.of_sheet)
      scale(d);
    result.all.bilinear = model_.unit * bilinear_excess(mesh_.complex, model_.in_units(positions));
    if (std::isfinite(parameters_.maximum_deviation))
      result.all.certified = model_.unit *
                             certified_deviation(model_.faces, model_.in_units(positions), *model_.surface,
                                                 parameters_.maximum_deviation / model_.unit, parameters_.certification)
                               .upper_bound;
    return result;
  }

  Sliding sliding(const Positions& positions) const
  {
    return Sliding(*model_.surface, model_.attachment, parameters_.boundary_placement, model_.in_units(positions),
                   mesh_.complex.ties);
  }

  Away away(const Positions& positions) const { return sliding(positions).away(model_.in_units(positions)); }

  // Whether a corner is inverted whose vertices are all fixed.
  bool is_locked(const Hexahedron& h) const
  {
    const auto is_fixed = [&](int i) { return model_.is_fixed[h[i]] != 0; };
    for (int c = 0; c < 8; ++c) {
      const int(&next)[3] = corner_neighbors[c];
      const auto edge = [&](int k) { return Vector_3(positions_[h[next[k]]] - positions_[h[c]]); };
      if (is_fixed(c) && is_fixed(next[0]) && is_fixed(next[1]) && is_fixed(next[2]) &&
          edge(0).dot(edge(1).cross(edge(2))) <= 0)
        return true;
    }
    return false;
  }

  // Of all, and of each label.
  double measure_volumes(const Positions& positions, double Region_volume::*of_region)
  {
    double sum = 0;
    for (std::size_t h = 0; h < mesh_.complex.hexahedra.size(); ++h) {
      const double v = volume_of(h, positions);
      sum += v;
      const auto region = std::lower_bound(status.regions.begin(), status.regions.end(),
                                           mesh_.complex.label(static_cast<int>(h)),
                                           [](const Region_volume& r, int label) { return r.label < label; });
      (*region).*of_region += v;
    }
    return sum;
  }

  double volume_of(std::size_t h, const Positions& positions) const
  {
    Vector_3 corners[8];
    for (int k = 0; k < 8; ++k)
      corners[k] = positions[mesh_.complex.hexahedra[h][k]];
    return volume(corners);
  }

  // Of the pieces of one label that hang together through faces.
  void find_volume_changes()
  {
    const Hexahedral_complex& complex = mesh_.complex;
    Disjoint_sets pieces(complex.hexahedra.size());
    for (const auto& sides : complex.interior_faces)
      pieces.unite(static_cast<std::size_t>(sides[0].first), static_cast<std::size_t>(sides[1].first));
    for (const Hexahedral_complex::Boundary_face& face : complex.boundary_faces)
      if (face.beyond >= 0 && complex.label(face.beyond) == complex.label(face.hexahedron))
        pieces.unite(static_cast<std::size_t>(face.hexahedron), static_cast<std::size_t>(face.beyond));
    std::vector<Volume_change> of_piece(complex.hexahedra.size(), {0, complex.hexahedra.size(), 0, 0, 0});
    for (std::size_t h = 0; h < complex.hexahedra.size(); ++h) {
      Volume_change& piece = of_piece[pieces.find(h)];
      piece.label = complex.label(static_cast<int>(h));
      piece.hexahedron = (std::min)(piece.hexahedron, static_cast<std::size_t>(mesh_.order.given_hexahedron(h)));
      ++piece.number_of_hexahedra;
      piece.before += volume_of(h, mesh_.points);
      piece.after += volume_of(h, positions_);
    }
    for (const Volume_change& piece : of_piece)
      if (std::abs(piece.after - piece.before) > noticed_change * std::abs(piece.before))
        status.volume_changes.push_back(piece);
    std::sort(status.volume_changes.begin(), status.volume_changes.end(),
              [](const Volume_change& a, const Volume_change& b) { return a.hexahedron < b.hexahedron; });
  }

  // Whether the input is as good as a mesh can be, and on its reference: what may still change is rounding.
  bool is_perfect() const
  {
    return status.before.minimum >= 1 - rounding && measured_deviations(mesh_.points).all.maximum_relative <= rounding;
  }

  // In the order of goals; quality is kept where nothing comes before it.
  bool is_worse(double excess_before, double excess) const
  {
    if (std::isfinite(parameters_.maximum_deviation)) {
      excess_before = excess_over_bound(measured_deviations(mesh_.points).all);
      excess = excess_over_bound(status.deviation);
    }
    const Merit before{status.before.number_of_inverted, status.before.number_of_invalid, excess_before,
                          away(mesh_.points)};
    const Merit now{status.after.number_of_inverted, status.after.number_of_invalid, excess, away(positions_)};
    return before < now || (before.is_good() && status.after.minimum < status.before.minimum);
  }

  double excess_over_bound(const Deviation& deviation) const
  {
    return (std::max)(0.0, deviation.certified / parameters_.maximum_deviation - 1);
  }

  static constexpr double rounding = 1e-12;
  static constexpr double noticed_change = .01; // of a volume

  const Checked_mesh& mesh_;
  const Model& model_;
  const Optimization_parameters& parameters_;
  Positions positions_;
  bool is_off_ = false; // the reference, by more than is tolerated, or what vertices are to stand on
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_REPORT_H
