// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_MAXIMIZATION_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_MAXIMIZATION_PARAMETERS_H

// The numbers of quality maximization, each with what it does and why it has this
// value. Distances are in units of the local edge length unless something else is
// said; "measured" refers to organic and CAD models of 2,500 to 38,000 hexahedra.

#include <CGAL/Hex_mesh_optimization/internal/solver/Newton_parameters.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

struct Maximization_parameters
{
  // --- Energy of a hexahedron ---
  // Keeps the root of the norm differentiable at a perfect hexahedron.
  double norm_offset = 1e-3;
  // ν, the weight of −log s. It only has to be infinite at 0: the floor does the work.
  double barrier_weight = .005;
  // ρ, the weight of the exterior floor. Stronger than an attachment at any distance, so that it wins.
  double floor_weight = 2000;
  // κ and κ', the shape: the scaled Jacobian is blind to lengths. Growth with the third power keeps the long tail of edge
  // ratios short at little cost for the average; a linear term of the same effect cost .002 to .004 of it (measured).
  double shape_weight = .11;
  double poor_shape_weight = .545;
  // Once the mesh has relaxed, both are multiplied by balance / (offset + 1 − average scaled Jacobian): the nearer the
  // angles are to perfect, the more there is to gain from shape, and the less it costs.
  double shape_balance = .0375;
  double shape_balance_offset = .005;

  // How far estimated target lengths of the interior move, on a logarithmic scale, to the lengths reached at the end of the
  // first phase. Those of the boundary stay: adapted too, they let single rows of its quads collapse (measured: the
  // ratios of edges of a hundredth of the hexahedra grow from 8.9 to 11.4).
  double length_adaptation = .93;

  // --- Attachment of the boundary ---
  // Slope of the energy over the distance d, in a mesh whose mean boundary edge is one fiftieth of the diagonal of the
  // reference. In proportion to the edge: what counts is the deviation of the model, not that of one edge.
  double attachment_weight = 1.18;
  double typical_edge = .02;
  double size_exponent = 1.35;
  // Factor for a reference of its own. The boundary of a mesh, taken for its own reference, is as rough as the mesh.
  double trust = 5;
  // Below this the energy is quadratic, above linear: with the square of d the same average deviation buys less quality.
  double linear_distance = .027;
  // From about this distance on an additional term grows with the sixth power, up to twice the distance; relative to the
  // geometric mean of the edge and its typical length, as the bound has to suit both the element and the model.
  double steep_weight = .25;
  double steep_distance = .19;
  // Weights of the samples, times the third power of the local edge: one for the distance, which is relative to it, and two
  // for the area, so that all is summed as the average deviation is. 1 at vertices and centers of faces.
  double edge_sample_weight = .5;
  // Of samples of the reference, per area of one squared edge, and per edge length of a feature curve.
  double pull_weight = 10.2;
  double curve_pull_weight = .5;
  double reference_spacing = .8; // in mean boundary edges
  // Factor for features.
  double feature_weight = 4.6;
  // Samples keep their targets until they have moved this far.
  double still_distance = .02;

  // --- Untangling: ε² = least + factor · min(0, lowest determinant)², as in Garanzha et al. ---
  double least_regularization = 1e-6;
  double regularization = .04;
  // It ends when no corner is below this: from nearly inverted ones, the maximization of quality climbs slowly, if at all.
  double untangled = .02;
  // Only vertices so many hexahedra around an inverted one move; twice as many after so many iterations without a
  // hexahedron less that is inverted. After so many it gives up, and after the former number where none is left.
  std::size_t untangling_rings = 5;
  std::size_t widening_patience = 10;
  std::size_t untangling_patience = 30;

  // --- First phase: the worst corners climb, the boundary is loosely attached ---
  // Factor of all attachment weights. A tighter start freezes the minimum (measured: .07 instead of .70).
  double start_tightness = .02;
  // The floor stands this far above the worst corner, at most, no higher than the limit, and where this part of the
  // hexahedra is worse, they are left in peace.
  double floor_step = .2;
  double floor_limit = .95;
  double floor_fraction = .04;
  // The phase ends when the minimum has not gained so much in so many iterations, when it is as high as is worth holding
  // and the average has not changed so much in so many, or after so many.
  double climbing_gain = .005;
  std::size_t climbing_patience = 6;
  double climbing_change_of_average = 6e-4;
  std::size_t climbing_patience_for_average = 3;
  std::size_t climbing_iterations = 60;

  // --- Second phase: the attachment tightens, the worst corners are held ---
  // Held is this part of the minimum reached, but no more than the limit or, if that is higher, than the gap below
  // the floor_fraction of the hexahedra: a higher minimum than that is not worth the deviation. The gap is no more
  // than a multiple of what those lack of 1: nearly perfect meshes stay so.
  double hold = .98;
  double hold_limit = .694;
  double hold_gap = .115;
  double relative_hold_gap = 1.5;
  // The penalty acts from this far above what is held.
  double hold_margin = .04;
  // Part of what a corner lacks that its multiplier grows by in an iteration; all of it overshoots and oscillates.
  double lift_rate = .5;
  // Bound of the multipliers, against hexahedra that cannot be held at all.
  double largest_lift = 2;
  // Factor of the tightness in each iteration in which no corner is below this part of what is held, or which was the
  // last one to wait for that.
  double tightening = 1.5;
  double ready = .88;
  std::size_t waiting_patience = 5;
  // It ends when a fully tight state was met whose worst corner was close to what is held and the minimum has not gained or
  // the average not changed so much in so many iterations, or after so many; without such a state it goes on longer.
  double held_closely = .97;
  double least_gain_of_minimum = 2e-3;
  double least_change_of_average = 1.5e-4;
  std::size_t patience = 10;
  std::size_t settling_iterations = 16;
  std::size_t longest_settling_iterations = 40;
  // A later state with a minimum lower than that of an earlier one, but by no more than this, counts as better.
  double accepted_loss = .01;

  // --- Bound of the deviation, if there is one; in units of the mean boundary edge ---
  double maximum_deviation = std::numeric_limits<double>::infinity();
  // Samples farther than this part of it get heavier by the factor in each iteration, within the limit.
  double strained_part = .9;
  double straining = 1.5;
  double largest_strain = 1e4;

  // --- Newton's method ---
  Newton_parameters newton;
  // No corner may drop below this part of its own or the held scaled Jacobian, the lower of the two, in one step; the
  // vertices of those that would are held back to half the step, again and again, up to so often. The line search sees
  // sums only, and lets single corners collapse.
  double least_part_of_corner = .9;
  int holding_rounds = 6;
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_MAXIMIZATION_PARAMETERS_H
