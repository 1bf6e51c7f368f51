// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_TRANSLATIONS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_TRANSLATIONS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The translations from vertices to their periodic partners, which rounding leaves nearly and the caller wants exactly.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include <cstddef>
#include <sstream>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Translations
{
public:
  // In the coordinates of the caller.
  Translations(std::size_t number_of_vertices, std::vector<Tie> ties) : ties_(std::move(ties))
  {
    if (ties_.empty())
      return;
    const Grouped_array from(
      number_of_vertices, ties_.size(), [this](std::size_t i) { return ties_[i].vertex; },
      [](std::size_t i) { return static_cast<int>(i); });
    std::vector<char> is_partner(number_of_vertices, false), is_known(number_of_vertices, false);
    for (const Tie& tie : ties_)
      is_partner[tie.partner] = true;
    for (const bool starts : {true, false}) // those that are nobody's partner; then one of each circle
      for (std::size_t v = 0; v < number_of_vertices; ++v) {
        if (is_known[v] || starts == bool(is_partner[v]))
          continue;
        is_known[v] = true;
        std::vector<int> known(1, static_cast<int>(v));
        for (std::size_t k = 0; k < known.size(); ++k)
          for (int i : from[known[k]])
            if (!is_known[ties_[i].partner]) {
              is_known[ties_[i].partner] = true;
              known.push_back(ties_[i].partner);
              order_.push_back(i);
            }
      }
  }

  // Throws Input_error if a partner is not where the translation leads, within a small part of the unit of length.
  // name(v): the number of a vertex for the caller.
  template <class Name>
  void check(const Positions& points, double unit, const Name& name) const
  {
    for (std::size_t i = 0; i < ties_.size(); ++i) {
      const Tie& tie = ties_[i];
      const double off = (points[tie.partner] - points[tie.vertex] - tie.translation).norm();
      if (off <= tolerance * unit)
        continue;
      std::ostringstream message;
      message << "vertex " << name(tie.partner) << " is not where the translation takes vertex " << name(tie.vertex)
              << ", but " << off << " away";
      throw Input_error(Input_error::Element::PARAMETER, i, message.str());
    }
  }

  // Partners that have moved from where they were are exactly where the translations take their vertices.
  void restore(const Positions& before, Positions& points) const
  {
    for (int i : order_) {
      const Tie& tie = ties_[i];
      if (points[tie.vertex] != before[tie.vertex] || points[tie.partner] != before[tie.partner])
        points[tie.partner] = points[tie.vertex] + tie.translation;
    }
  }

private:
  static constexpr double tolerance = 1e-6;

  std::vector<Tie> ties_;
  std::vector<int> order_; // of ties, in which each partner is determined once
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_TRANSLATIONS_H
