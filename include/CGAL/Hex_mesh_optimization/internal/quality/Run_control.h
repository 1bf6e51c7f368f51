// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_RUN_CONTROL_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_RUN_CONTROL_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Time limit and visitor of one run: whether to go on, and why not.

#include <CGAL/Hex_mesh_optimization/Visitor.h>
#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL::Hex_mesh_optimization::internal {

// Why a stage ended.
enum class Stage_end {
  CONVERGED,       // nothing was gained any more, or as much as was asked for
  ITERATION_LIMIT, // the iterations were used up before
  STOPPED          // by the time limit or the visitor
};

class Run_control
{
public:
  using Callback = std::function<bool(const Iteration&)>;

  explicit Run_control(double maximum_seconds = std::numeric_limits<double>::infinity(),
                       Callback on_iteration = nullptr)
    : start_(Clock::now())
    , maximum_seconds_(maximum_seconds)
    , on_iteration_(std::move(on_iteration))
  {}

  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  bool time_is_over() const { return seconds() >= maximum_seconds_; }

  // What the caller sees of a state.
  struct Shown
  {
    std::size_t inverted;
    double minimum, average;
  };

  // Called with the state after each iteration, of any stage; returns what is shown for it. Not called if empty.
  std::function<Shown(const Positions&, const Mesh_quality&, std::optional<double> excess)> on_state;

  // Reports one iteration, and the points that it has reached. excess: of the boundary over what the stage tolerates, if that
  // has found it. False when the run has to end; return_code() says why.
  bool after_iteration(Stage stage, std::size_t iteration, double energy, const Positions& points,
                       const Mesh_quality& quality, std::optional<double> excess = std::nullopt)
  {
    ++iterations;
    Shown shown{quality.inverted, quality.minimum, quality.average};
    if (on_state)
      shown = on_state(points, quality, excess);
    if (on_iteration_ &&
        !on_iteration_({stage, iteration, energy, shown.inverted, shown.minimum, shown.average, seconds()})) {
      stop(Return_code::STOPPED_BY_VISITOR);
      return false;
    }
    return !check_time();
  }

  // True when the run has to end because its time is over.
  bool check_time()
  {
    if (!stopped_ && time_is_over())
      stop(Return_code::TIME_LIMIT);
    return stopped_;
  }

  bool is_stopped() const { return stopped_; }

  // Of a stage that otherwise ran into a limit of its iterations, or did not.
  Stage_end stage_end(bool used_up) const
  {
    return stopped_ ? Stage_end::STOPPED : used_up ? Stage_end::ITERATION_LIMIT : Stage_end::CONVERGED;
  }

  Return_code return_code() const { return return_code_; }

  std::size_t iterations = 0;

private:
  using Clock = std::chrono::steady_clock;

  void stop(Return_code why)
  {
    stopped_ = true;
    return_code_ = why;
  }

  Clock::time_point start_;
  double maximum_seconds_;
  Callback on_iteration_;
  bool stopped_ = false;
  Return_code return_code_ = Return_code::CONVERGED;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_RUN_CONTROL_H
