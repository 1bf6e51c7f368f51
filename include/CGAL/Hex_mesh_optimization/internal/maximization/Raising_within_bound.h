// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_RAISING_WITHIN_BOUND_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_RAISING_WITHIN_BOUND_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The worst hexahedra of a mesh within a bound of the deviation are raised by
// search, one vertex after the other: in a narrow tube Newton's method jams. What
// samples do not see of the bound is taken back afterwards.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Pattern_search.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Places_within_bound.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Measured on a CAD part, an organic model and another CAD part, bound to .1 %, .1 % and .2 % of their diagonals, whose
// minima are .319, .240 and .425 without a search: .345, .324 and .448.
struct Raising_parameters
{
  // Searches, each from what the last one that gained so much of the minimum has left. With less nothing is kept.
  std::size_t most_searches = 4;
  double least_gain = .002;
  // What corners lack of 1 counts so much besides.
  double weight_of_average = .001;
  // What a search has taken out of the bound between samples goes back, in steps of this part of the way and at last all
  // of it, for up to so many places that samples see one after the other. (With half of the way the second minimum above
  // is .310, and where all is repeated from the start with the further samples instead, the third .425.)
  double step_back = .25;
  std::size_t most_steps_back = 7;
  std::size_t most_returns = 6;
};

class Raising_within_bound
{
public:
  // lengths: the targets of the edges. All but the numbers must outlive the object.
  Raising_within_bound(const Hexahedral_complex& complex, const std::vector<double>& lengths,
                       const Reference_surface& surface, const Boundary_attachment& attachment, const Sliding& sliding,
                       Boundary_samples& samples, const Pattern_search_parameters& of_search,
                       const Raising_parameters& parameters)
    : complex_(complex)
    , lengths_(lengths)
    , surface_(surface)
    , attachment_(attachment)
    , sliding_(sliding)
    , samples_(samples)
    , of_search_(of_search)
    , parameters_(parameters)
  {
    of_search_.weight_of_average = parameters.weight_of_average;
  }

  // Up to the limit, from points within the bound to others for which is_within(points) holds as well.
  template <class IsWithin, class TimeIsOver>
  void raise(double limit, const IsWithin& is_within, const TimeIsOver& time_is_over, Positions& points)
  {
    // edges that are short already may stay so
    std::vector<double> lengths = lengths_;
    for (std::size_t e = 0; e < lengths.size(); ++e) {
      const auto& [a, b] = complex_.edges[e];
      lengths[e] = (std::min)(lengths[e], (points[b] - points[a]).norm() / of_search_.least_edge_of_raised);
    }
    for (std::size_t i = 0; i < parameters_.most_searches && !time_is_over(); ++i) {
      const Mesh_quality before(complex_, points);
      const auto is_worth = [&](const Positions& raised) {
        const Mesh_quality after(complex_, raised);
        return after.invalid <= before.invalid && after.minimum >= before.minimum + parameters_.least_gain;
      };
      samples_.update(points, 1);
      const Places_within_bound places = places_now();
      Positions raised = points;
      Pattern_search(complex_, lengths, places, of_search_).raise(limit, raised);
      if (!is_worth(raised))
        return;
      bool is_there = is_within(raised);
      for (std::size_t k = 0;
           k < parameters_.most_returns && !is_there && come_back(points, raised) && is_worth(raised); ++k)
        is_there = is_within(raised);
      if (is_there && is_worth(raised))
        points = std::move(raised);
    }
  }

private:
  Places_within_bound places_now() const
  {
    return Places_within_bound(surface_, attachment_, sliding_, samples_, complex_.number_of_vertices());
  }

  // Adds samples where it has left the bound, and takes vertices there back towards the points until these are within.
  // Whether there are any.
  bool come_back(const Positions& points, Positions& raised)
  {
    samples_.update(raised, 1);
    if (!samples_.add_where_beyond(raised))
      return false;
    samples_.update(raised, 1);
    const Places_within_bound places = places_now();
    for (std::size_t step = 0; step <= parameters_.most_steps_back; ++step) {
      const double part = step < parameters_.most_steps_back ? parameters_.step_back : 1;
      std::vector<int> leaving;
      for (int v = 0; v < static_cast<int>(points.size()); ++v)
        if (raised[v] != points[v] && !places.allows({v}, raised))
          leaving.push_back(v);
      if (leaving.empty())
        break;
      for (int v : leaving)
        raised[v] = part < 1 ? Vector_3(raised[v] + part * (points[v] - raised[v])) : points[v];
    }
    return true;
  }

  const Hexahedral_complex& complex_;
  const std::vector<double>& lengths_;
  const Reference_surface& surface_;
  const Boundary_attachment& attachment_;
  const Sliding& sliding_;
  Boundary_samples& samples_;
  Pattern_search_parameters of_search_;
  const Raising_parameters parameters_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_RAISING_WITHIN_BOUND_H
