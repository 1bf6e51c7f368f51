// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_PYTHON_WATCHER_H
#define CGAL_HEX_MESH_OPTIMIZATION_PYTHON_WATCHER_H

// The visitor that keeps Python informed while a run goes on without the lock of the interpreter.

#include "status_report.h"

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

namespace py = pybind11;

class Watcher
{
public:
  // progress: called with the members of each iteration, stops the run by returning False; or None.
  explicit Watcher(py::object progress) : progress_(std::move(progress)) {}

  bool on_iteration(const HMO::Iteration& iteration)
  {
    const py::gil_scoped_acquire lock;
    iterations_.push_back(iteration);
    return goes_on([&] { return is_wanted(iteration); });
  }

  // With the lock, once the run has ended: throws what has stopped it, but for the interruption by the user, which
  // counts after the last iteration as well.
  void finish()
  {
    if (!error_)
      goes_on([] { return true; });
    if (error_)
      throw py::error_already_set(*error_);
  }

  bool is_interrupted() const { return is_interrupted_; }
  const std::vector<HMO::Iteration>& iterations() const { return iterations_; }

  // Leaves the optimization. The error is kept here: it belongs to the interpreter, whose lock is not held on that way.
  struct Failure
  {};

private:
  template <class Question>
  bool goes_on(const Question& question)
  {
    try {
      const bool answer = question();
      if (PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      return answer && !is_interrupted_;
    }
    catch (py::error_already_set& error) {
      if (error.matches(PyExc_KeyboardInterrupt)) {
        is_interrupted_ = true;
        return false;
      }
      error_ = std::make_unique<py::error_already_set>(error);
    }
    throw Failure();
  }

  bool is_wanted(const HMO::Iteration& i) const
  {
    if (progress_.is_none())
      return true;
    const py::object answer = progress_(json(i.stage).get<std::string>(), i.iteration, i.energy, i.number_of_inverted,
                                        i.minimum, i.average, i.seconds);
    return !answer.is(py::bool_(false));
  }

  py::object progress_;
  std::vector<HMO::Iteration> iterations_;
  bool is_interrupted_ = false;
  std::unique_ptr<py::error_already_set> error_;
};

#endif // CGAL_HEX_MESH_OPTIMIZATION_PYTHON_WATCHER_H
