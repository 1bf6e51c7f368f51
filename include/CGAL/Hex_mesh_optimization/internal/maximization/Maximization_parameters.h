// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_MAXIMIZATION_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_MAXIMIZATION_PARAMETERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The numbers of the phases of quality maximization, each with what it does
// and why it has this value. "Measured" refers to organic and CAD models of 2,500
// to 38,000 hexahedra.

#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Arrivals.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Quality_floor.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Newton_parameters.h>

#include <cstddef>

namespace CGAL::Hex_mesh_optimization::internal {

// Chosen with the meshes that benchmark/Hex_mesh_optimization/valid_meshes.py names and prints the table of.
struct Interior_point_parameters
{
  // The barrier of a corner: its weight, which decreases by the factor in each iteration, to the last; its width, and how
  // far below the minimum of now it is infinite. A weak barrier from the start lets many corners come to the minimum at
  // once, where steps are held back; with a larger gap corners are stopped there before the barrier holds them. The first
  // weight and the factor were chosen with the octree mesh `bone` of that script and the CAD part `block` of the paper on its
  // own surface.
  double first_weight = 10;
  double decrease = .7;
  double weight = .1;
  double width = .05;
  double gap = 3e-4;
  std::size_t iterations = 40; // at most
  // Factors of the weights of the shape, and of the shape for lengths that are certain.
  double shape = .45;
  double certain_shape = .65;
};

// Numbers without another source were chosen together by a coordinate search on organic and CAD models of 2,500 to
// 38,000 hexahedra.
struct Maximization_parameters
{
  // Once the mesh has relaxed, both weights of the shape are multiplied by balance / (offset + 1 − average scaled
  // Jacobian): the nearer the angles are to perfect, the more there is to gain from shape, and the less it costs.
  double shape_balance = .0382;
  double shape_balance_offset = .005;
  // Factor of the weight of poor shapes for a reference of its own without a bound: what holds it closely stretches edges
  // (measured on an organic model and a CAD part: the ratios of edges of a hundredth of the hexahedra are 9.0 and 13.7 with
  // 1.8, 8.8 and 13.5 with 2.1).
  double poor_shape_of_own = 2.1;

  // How far estimated target lengths of the interior move, on a logarithmic scale, to the lengths reached at the end of
  // the first phase. Those of the boundary stay: adapted too, they let single rows of its quads collapse (measured: the
  // ratios of edges of a hundredth of the hexahedra grow from 8.9 to 11.4).
  double length_adaptation = .93;

  // --- First phase: the worst corners climb, the boundary is loosely attached ---
  // Factor of all attachment weights. A tighter start freezes the minimum (measured: .07 instead of .70).
  double start_tightness = .02;
  // The phase ends when the minimum has not gained so much in so many iterations and the average has not changed so
  // much in so many, when the minimum is as high as is worth holding and the average has not changed in so many, or after
  // so many (with no condition on the average where the minimum stalls, a CAD part bound to .02 % of its diagonal has an
  // average of .9863 instead of .9882: target lengths come from a mesh that still moves; measured on seven surfaces that were
  // meshed with 8,000 hexahedra: with a gain of .005 in six there are up to a quarter more iterations of all phases, and
  // minima differ by no more than .004; with .01 in six a CAD part loses .01).
  double climbing_gain = .012;
  std::size_t climbing_patience = 8;
  double climbing_change_of_average = 2e-3;
  // Where distances are bounded, or vertices are to stand exactly on curves and faces: little comes right later (measured
  // with the other, and a least regularization of untangling of 3e-5: a CAD part bound to .1 % and .02 % of its diagonal has
  // a minimum of .285 instead of .323, and an average of .8843 instead of .8866, another one with all vertices on its surface
  // a minimum of .21 instead of .47. Where neither is so, a CAD part takes 49 iterations with the other instead of 55).
  double careful_climbing_change_of_average = 6e-4;
  std::size_t climbing_patience_for_average = 3, stalled_patience_for_average = 5;
  std::size_t climbing_iterations = 60;
  // Over-relaxation of its steps, where no distance is bounded (measured on eleven models: a tenth of the iterations fewer
  // with 1.7, a third on a CAD part, at the same quality; corners that are held later would oscillate, and the minimum
  // within a close bound can end higher than without a bound by more than .01).
  double climbing_relaxation = 1.7;

  // --- Second phase: the attachment tightens, the worst corners are held ---
  // Factor of the tightness in each iteration in which no corner is below this part of what is held, or which was the
  // last one to wait for that.
  double tightening = 1.5;
  double ready = .88;
  std::size_t waiting_patience = 5;
  // It ends when a fully tight state was met whose worst corner was close to what is held and the minimum has not
  // gained or the average not changed so much in so many iterations, or after so many.
  double held_closely = .97;
  double least_gain_of_minimum = 2e-3;
  double least_change_of_average = 1.5e-4;
  std::size_t patience = 5;
  std::size_t settling_iterations = 16;
  std::size_t least_settling_iterations = 3;
  // A later state with a minimum lower than that of an earlier one, but by no more than this, counts as better; and so do
  // all later states after the first few tight ones, which can have the highest minimum while they are far from settled
  // (measured on a CAD part that is brought to its surface: without that its average deviation is 1.86e-4 of the diagonal
  // instead of 1.55e-4).
  double accepted_loss = .01;

  // --- Third phase, where vertices stand exactly on curves and faces: they come to their places ---
  // After it the first two phases follow again, with what has come sliding.
  Arrival_parameters arrivals;
  // Once, when all has settled, the worst are raised by search, and all climb again if so much was gained.
  double gain_of_raising = .01;

  // Lengths that the caller asks for are kept so many times as closely as those that only seem to be meant, at what that
  // costs in quality (measured on layers that grow by 1.4: the percentiles 1 and 99 of their heights are .86 and 1.12 of
  // those asked for, instead of .63 and 1.32).
  double weight_of_lengths_asked_for = 15;

  // --- Bounded distances ---
  // The minimum that is held yields by the factor whenever, fully tight, the excess over the bound has not fallen to this
  // part in so many iterations, or vertices are away from where they are to stand, and recovers in each without that.
  // (With a patience of 1 it yields while samples swing into place: minima of six models are up to .12 lower.)
  double excess_part = .9;
  std::size_t yielding_patience = 2;
  double yielding = .98;
  double recovery = 1.03;
  // While there is excess, it goes on for so many iterations (after 60 it still falls on a CAD part that is bound to .02 %
  // of its diagonal).
  std::size_t most_bounded_iterations = 100;
  // Once fully tight, samples are added where the mesh is beyond the bound between those that there are, each time after
  // so many iterations, up to so often, and up to so often more before the end (measured on an organic model bound to
  // .05 % of its diagonal: without this it is within the bound at all samples, and beyond it by a fifth between them).
  std::size_t refinement_interval = 4;
  std::size_t most_refinements = 20, most_last_refinements = 6;
  // Further factor of both weights of the shape, for a bound of a tenth of an edge, and in proportion to the power of that,
  // between 1 and the most: in a narrow tube edges are the more likely to collapse, in a wide one the shape costs
  // deviation (measured on an organic model bound to .44 edges: the average is 3.57e-4 of the diagonal with a factor of
  // 3, 3.45e-4 with 2; on a CAD part bound to .1 % of its diagonal the 99th percentile of the ratios of edges is 2.7
  // with 4 and 2.4 with 10, which costs .0004 of the mean).
  double bounded_shape = 4.7;
  double bounded_shape_exponent = -.5;
  double most_bounded_shape = 8;
  // Where that factor is larger than this, poor shapes are dearer still, in proportion and up to the most (on the CAD
  // part the percentile is 2.57 with 8.6 for both weights, and 2.4 with half as much again for poor shapes, at the same
  // mean).
  double dearer_poor_shape = 3.5;
  double most_bounded_poor_shape = 1.5;
  // Where only interfaces are bounded, the shape yields first, by the factor and down to the least: hexahedra with two
  // faces on one smooth interface need not be flat if edges across it may become longer than others (measured: a ball
  // in a block keeps to .09 edges, and not to .15 without this).
  double shape_yielding = .8;
  double least_shape_yield = .25;

  // --- Steps ---
  // No corner may drop below this part of its own or the held scaled Jacobian, the lower of the two, in one step; the
  // vertices of those that would are held back to half the step, again and again, up to so often. The line search sees
  // sums only, and lets single corners collapse.
  double least_part_of_corner = .9;
  int holding_rounds = 6;

  Hexahedron_energy_parameters energy;
  Floor_parameters floor;
  Newton_parameters newton;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_MAXIMIZATION_PARAMETERS_H
