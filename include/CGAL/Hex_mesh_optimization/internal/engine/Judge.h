// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_JUDGE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_JUDGE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How good a state of the mesh is, by what the caller asks for: whatever the
// stages that lead to it are bound to and attached to, all are judged alike.

#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/certified_deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Checked_mesh.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Model.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Optimization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Merit.h>

#include <cmath>
#include <optional>

namespace CGAL::Hex_mesh_optimization::internal {

// With samples of the boundary of the mesh and of the reference. bound: of the deviation, in mean boundary edges.
// stays_within: the bound is not relaxed while the weight of the boundary is small. All but the numbers must outlive the
// result.
inline Boundary_samples boundary_samples(const Checked_mesh& mesh, const Model& model,
                                         const Optimization_parameters& parameters,
                                         const Boundary_attachment& attachment, double bound, bool stays_within)
{
  // where all vertices are to be on the surface, those that are not are counted instead
  const bool has_tolerance = model.reference_is_given &&
                             parameters.boundary_placement != Boundary_placement::ON_SURFACE;
  Boundary_sample_parameters of_samples = parameters.boundary.samples;
  if (stays_within)
    of_samples.loosening = 0;
  return Boundary_samples(mesh.complex, model.faces, *model.surface, attachment, model.targets.lengths, has_tolerance,
                          bound, of_samples);
}

class Judge
{
public:
  // All must outlive the object.
  Judge(const Checked_mesh& mesh, const Model& model, const Optimization_parameters& parameters)
    : mesh_(mesh)
    , model_(model)
    , parameters_(parameters)
    , bound_(parameters.maximum_deviation / model.unit)
    , sliding_(*model.surface, model.attachment, parameters.boundary_placement, model.points, mesh.complex.ties)
  {}

  // A state with what the order of goals compares.
  struct Judged
  {
    Positions points;
    Mesh_quality quality;
    Merit merit;
    mutable std::optional<bool> is_shown_within_bound; // once asked for
  };

  Judged judged(const Positions& points)
  {
    samples_.reset(); // what has hardly moved would keep its target, and be judged by where the surface was near that
    const Mesh_quality quality(mesh_.complex, points);
    Judged result{points, quality, merit(points, quality, excess(points)), {}};
    // samples keep to less than the bound: what is shown to be within is so
    if (result.merit.excess > 0 && has_bound() && !samples_->has_interface() && !is_beyond_bound(result))
      result.merit.excess = 0;
    return result;
  }

  Merit merit(const Positions& points, const Mesh_quality& quality, double excess)
  {
    return {quality.inverted, quality.invalid, excess, away(points)};
  }

  // Of the boundary over what is tolerated, relative to that. Searches go on from where the last have ended.
  double excess(const Positions& points)
  {
    if (!samples_)
      samples_.emplace(boundary_samples(mesh_, model_, parameters_, model_.attachment, bound_, false));
    if (samples_->has_tolerance())
      samples_->update(points, 1);
    return samples_->excess(points);
  }

  Away away(const Positions& points)
  {
    sliding_.notice(points);
    return sliding_.away(points);
  }

  // Whether the first comes before the second in the order of goals.
  bool is_better(const Judged& first, const Judged& second) const
  {
    if (first.merit < second.merit || second.merit < first.merit)
      return first.merit < second.merit;
    if (is_beyond_bound(first) != is_beyond_bound(second))
      return is_beyond_bound(second);
    return first.quality.minimum > second.quality.minimum;
  }

  bool has_bound() const { return std::isfinite(bound_); }

  // Whether the boundary is not shown to be within the bound everywhere: samples keep to a little less than that, and see
  // nothing between them.
  bool is_beyond_bound(const Judged& state) const
  {
    if (has_bound() && !state.is_shown_within_bound)
      state.is_shown_within_bound = is_shown_within_bound(state.points);
    return has_bound() && !*state.is_shown_within_bound;
  }

  bool is_shown_within_bound(const Positions& points) const
  {
    return certified_deviation(model_.faces, points, *model_.surface, bound_, parameters_.certification).is_shown;
  }

private:
  const Checked_mesh& mesh_;
  const Model& model_;
  const Optimization_parameters& parameters_;
  const double bound_; // of the deviation, in mean boundary edges
  std::optional<Boundary_samples> samples_;
  Sliding sliding_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_JUDGE_H
