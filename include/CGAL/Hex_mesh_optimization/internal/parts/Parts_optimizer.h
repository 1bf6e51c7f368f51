// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_PARTS_OPTIMIZER_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_PARTS_OPTIMIZER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Nonlinear Schwarz iteration: in each round the engine improves parts of the mesh apart from each other, which hold
// the vertices that they share; the parts of the next round overlap where those have met.

#include <CGAL/Hex_mesh_optimization/Status.h>
#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Surface_faces.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Chosen_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Optimization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Block_array.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Mesh_slices.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Part.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Parts_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Ranks.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/distributed_deviations.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Distributed_mesh.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Distributed_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/coordinate_bisection.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/smooth_tangled.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Merit.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/limit_of_held_vertices.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Parts_optimizer
{
public:
  Parts_optimizer(Mesh_slices& slices, Ranks& ranks, const Chosen_parameters& chosen, const Parts_parameters& parts)
    : start_(Clock::now())
    , slices_(slices)
    , ranks_(ranks)
    , chosen_(chosen)
    , parts_(parts)
    , mesh_(slices, ranks, parts.folder, chosen.features)
    , is_pending_(mesh_.new_array<char>(mesh_.points.size()))
    , is_off_(mesh_.new_array<char>(mesh_.points.size()))
    , is_held_(mesh_.new_array<char>(mesh_.points.size()))
  {}

  Status run()
  {
    const Distributed_quality before(mesh_, mesh_.given);
    status_.before = before.statistics;
    // as in one piece: what was tangled is brought to its best within its boundary, if that suffices
    const Optimization_parameters parameters;
    worth_raising_to_ = (std::min)(parameters.maximization.floor.hold_limit, chosen_.target_quality);
    Quality_statistics now = before.statistics;
    const bool is_tangled = now.number_of_inverted > 0 || now.minimum < parameters.untangling.untangled;
    if (is_tangled) {
      hold_boundary();
      smooth_tangled(mesh_, is_held_, parameters.untangling.untangled, parts_, [this] { return is_over(); });
      was_tangled_ = true;
    }
    if (is_tangled && limit_of_held_boundary() >= parameters.worth_holding_boundary) {
      holds_boundary_ = true;
      untangle();
      improve();
      holds_boundary_ = false;
      now = Distributed_quality(mesh_, mesh_.points).statistics;
    }
    if (!is_tangled || now.minimum < worth_raising_to_) {
      untangle();
      improve();
    }
    finish(before);
    return status_;
  }

private:
  using Clock = std::chrono::steady_clock;
  enum class Goal { VALID, BEST };

  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  // Where hexahedra are invalid, until they are not, or none of two rounds has helped.
  void untangle()
  {
    Block_array<char> is_in = mesh_.new_array<char>(mesh_.number_of_own_hexahedra());
    const auto measured = [&] {
      const Distributed_quality quality(mesh_, mesh_.points);
      for (std::size_t h = 0; h < is_in.size(); ++h)
        is_in[h] = quality.is_invalid[h];
      return quality.statistics;
    };
    Quality_statistics now = measured();
    int in_vain = 0;
    for (int round = 0; round < parts_.most_rounds && now.number_of_invalid > 0 && in_vain < 2 && !is_over();
         ++round) {
      grow(is_in, (1 + in_vain) * parts_.layers);
      run_round(is_in, Goal::VALID);
      const Quality_statistics next = measured();
      const auto rank = [](const Quality_statistics& q) {
        return std::make_pair(q.number_of_inverted, q.number_of_invalid);
      };
      in_vain = rank(next) < rank(now) ? 0 : in_vain + 1;
      now = next;
    }
  }

  // And what is between regions.
  void hold_boundary()
  {
    const Global_index first = ranks_.first(mesh_.number_of_vertices), last = ranks_.last(mesh_.number_of_vertices);
    for (std::size_t v = 0; v < is_held_.size(); ++v)
      is_held_[v] = mesh_.is_fixed[v];
    for (Global_index v : mesh_.boundary_vertices)
      if (v >= first && v < last)
        is_held_[static_cast<std::size_t>(v - first)] = true;
  }

  // No minimum is higher while what is held does not move.
  double limit_of_held_boundary() const
  {
    const Distributed_mesh::Nearby<char> is_held = mesh_.nearby(is_held_);
    const Distributed_mesh::Nearby<Triple> places = mesh_.nearby(mesh_.given);
    double least = 1;
    mesh_.for_own_hexahedra([&](std::size_t h) {
      std::array<char, 8> held;
      for (int i = 0; i < 8; ++i)
        held[i] = is_held[mesh_.hexahedra[h][i]];
      least = (std::min)(least, limit_of_held_vertices(mesh_.corners(places, h), held));
    });
    return -ranks_.maximum_of(-least);
  }

  // First all of the mesh that can gain; then around what was held so far, and around the worst, until that gains nothing.
  void improve()
  {
    for (std::size_t v = 0; v < is_pending_.size(); ++v)
      is_pending_[v] = true;
    Block_array<char> is_in = mesh_.new_array<char>(mesh_.number_of_own_hexahedra());
    Block_array<float> last = mesh_.new_array<float>(mesh_.number_of_own_hexahedra());
    Quality_statistics then;
    for (int round = 0; round < parts_.most_rounds && !is_over(); ++round) {
      const Distributed_quality quality(mesh_, mesh_.points);
      const Quality_statistics& now = quality.statistics;
      if (round > 1 &&
          !(now.minimum > then.minimum + parts_.least_raise || now.average > then.average + parts_.least_raise))
        break;
      then = now;
      // what is far from all that can gain stays, and what is held there is not pending
      for (std::size_t h = 0; h < is_in.size(); ++h)
        is_in[h] = quality.qualities[h] < 1 - parts_.least_gain;
      grow(is_in, parts_.layers - 1);
      bool is_any = false;
      {
        const Distributed_mesh::Nearby<char> pending = mesh_.nearby(is_pending_);
        mesh_.for_own_hexahedra([&](std::size_t h) {
          const auto& vertices = mesh_.hexahedra[h];
          is_in[h] = is_in[h] &&
                     std::any_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) { return pending[v]; });
          const float q = quality.qualities[h];
          const bool rises = round > 1 && q < now.minimum + parts_.near_worst && q > last[h] + parts_.least_gain;
          // while the boundary is held, poor hexahedra are worth a round: without that all of the mesh is run again
          if (rises || (round > 0 && holds_boundary_ && q < worth_raising_to_))
            is_in[h] = true;
          is_any = is_any || is_in[h];
          last[h] = quality.qualities[h];
        });
      }
      if (!ranks_.any(is_any))
        break;
      grow(is_in, round == 0 ? 1 : parts_.layers - 1);
      run_round(is_in, Goal::BEST);
    }
  }

  // By layers of hexahedra that share vertices.
  void grow(Block_array<char>& is_in, int layers)
  {
    Block_array<char> of_nearby = mesh_.new_array<char>(mesh_.number_of_nearby());
    Block_array<char> of_vertices = mesh_.new_array<char>(mesh_.points.size());
    for (int layer = 0; layer < layers; ++layer) {
      mesh_.for_own_hexahedra([&](std::size_t h) {
        for (std::uint32_t v : mesh_.hexahedra[h])
          of_nearby[v] = of_nearby[v] || is_in[h];
      });
      mesh_.combine(of_nearby, of_vertices, [](char a, char b) { return static_cast<char>(a || b); });
      const Distributed_mesh::Nearby<char> is_reached = mesh_.nearby(of_vertices);
      mesh_.for_own_hexahedra([&](std::size_t h) {
        for (std::uint32_t v : mesh_.hexahedra[h])
          is_in[h] = is_in[h] || is_reached[v];
      });
    }
  }

  void run_round(const Block_array<char>& is_in, Goal goal)
  {
    std::vector<std::int64_t> size(1, 0);
    for (std::size_t h = 0; h < is_in.size(); ++h)
      size[0] += is_in[h] != 0;
    ranks_.sum(size);
    const auto most = static_cast<int>(
      (std::min)(std::int64_t(parts_.number_of_parts), 1 + size[0] / std::int64_t(parts_.least_size)));
    const bool is_all = goal == Goal::BEST && size[0] == mesh_.number_of_hexahedra;
    const int number = is_all ? parts_.number_of_parts : most;
    const Block_array<int> part = coordinate_bisection(mesh_, number, cut_++,
                                                       [&](std::size_t h) { return is_in[h] != 0; });
    std::vector<std::int64_t> sizes(number, 0);
    for (std::size_t h = 0; h < part.size(); ++h)
      if (part[h] >= 0)
        ++sizes[part[h]];
    part.release();
    ranks_.sum(sizes);
    const std::vector<int> rank_of_part = divided_among_ranks(sizes);
    // where there are several ranks, they get all of their parts at once, and need not wait for each other until the end
    if (ranks_.size() > 1)
      run_parts(part, rank_of_part, -1, goal);
    else
      for (int p = 0; p < number && !is_over(); ++p)
        run_parts(part, rank_of_part, p, goal);
  }

  // The largest first, each to the rank that has the least.
  std::vector<int> divided_among_ranks(const std::vector<std::int64_t>& sizes) const
  {
    std::vector<int> order(sizes.size()), result(sizes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return sizes[a] > sizes[b]; });
    std::vector<std::int64_t> loads(ranks_.size(), 0);
    for (int p : order) {
      result[p] = static_cast<int>(std::min_element(loads.begin(), loads.end()) - loads.begin());
      loads[result[p]] += sizes[p];
    }
    return result;
  }

  // only: this part; -1: all
  void run_parts(const Block_array<int>& part, const std::vector<int>& rank_of_part, int only, Goal goal)
  {
    std::vector<Part> parts = collected(part, rank_of_part, only);
    std::vector<Global_index> vertices;
    for (const Part& p : parts)
      vertices.insert(vertices.end(), p.vertices.begin(), p.vertices.end());
    const Global_index n = mesh_.number_of_vertices;
    Part::Vertices of_all{ranks_.fetch<Triple>(n, mesh_.given, vertices),
                          ranks_.fetch<Triple>(n, mesh_.points, vertices),
                          ranks_.fetch<int>(n, mesh_.valence, vertices),
                          ranks_.fetch<char>(n, holds_boundary_ ? is_held_ : mesh_.is_fixed, vertices)};
    mesh_.release();
    std::vector<Global_index> moved, free;
    std::vector<Triple> places;
    std::vector<char> off;
    std::size_t first = 0;
    for (Part& p : parts) {
      const std::size_t last = first + p.vertices.size();
      const auto of_part = [&](const auto& values) {
        return std::decay_t<decltype(values)>(values.begin() + first, values.begin() + last);
      };
      Part::Vertices of_vertices{of_part(of_all.given), of_part(of_all.points), of_part(of_all.valence),
                                 of_part(of_all.is_fixed)};
      if (parts.size() == 1)
        of_all = {};
      first = last;
      const Status status = run_part(p, std::move(of_vertices), goal);
      moved.insert(moved.end(), p.moved.begin(), p.moved.end());
      places.insert(places.end(), p.places.begin(), p.places.end());
      std::vector<char> is_off(p.vertices.size(), false);
      for (std::size_t v : status.vertices_off_reference)
        is_off[v] = true;
      for (std::size_t v = 0; v < p.is_shared.size(); ++v)
        if (!p.is_shared[v]) {
          free.push_back(p.vertices[v]);
          off.push_back(is_off[v]);
        }
      p = Part({});
    }
    ranks_.store<Triple>(n, mesh_.points, moved, places);
    ranks_.store<char>(n, is_off_, free, off);
    ranks_.store<char>(n, is_pending_, free, std::vector<char>(free.size(), false));
  }

  std::vector<Part> collected(const Block_array<int>& part, const std::vector<int>& rank_of_part, int only) const
  {
    std::vector<std::vector<Hexahedron_of_part>> to(ranks_.size());
    mesh_.for_own_hexahedra([&](std::size_t h) {
      if (part[h] < 0 || (only >= 0 && part[h] != only))
        return;
      Hexahedron_of_part sent{
        mesh_.first_hexahedron() + static_cast<Global_index>(h), {}, part[h], mesh_.label(h), mesh_.outer_faces[h]};
      for (int i = 0; i < 8; ++i)
        sent.vertices[i] = mesh_.vertex(mesh_.hexahedra[h][i]);
      to[rank_of_part[part[h]]].push_back(sent);
    });
    std::vector<Hexahedron_of_part> all;
    for (const std::vector<Hexahedron_of_part>& from : ranks_.exchange_values(to))
      all.insert(all.end(), from.begin(), from.end());
    to.clear();
    // the ranks come in the order of their hexahedra
    std::stable_sort(all.begin(), all.end(),
                     [](const Hexahedron_of_part& a, const Hexahedron_of_part& b) { return a.part < b.part; });
    std::vector<Part> parts;
    for (auto begin = all.begin(); begin != all.end();) {
      const auto end = std::find_if(begin, all.end(), [&](const auto& h) { return h.part != begin->part; });
      parts.emplace_back(std::vector<Hexahedron_of_part>(begin, end));
      begin = end;
    }
    return parts;
  }

  Status run_part(Part& part, Part::Vertices vertices, Goal goal)
  {
    Chosen_parameters parameters = chosen_;
    parameters.maximum_running_time = (std::max)(0., chosen_.maximum_running_time - seconds());
    if (goal == Goal::VALID)
      parameters.target_quality = (std::min)(0., chosen_.target_quality);
    else if (was_tangled_ && chosen_.method == Method::FULL &&
             (holds_boundary_ || !std::isfinite(chosen_.maximum_deviation)))
      parameters.method = Method::MAXIMIZATION; // as in one piece; a bound asks for more
    if (chosen_.on_iteration)
      parameters.on_iteration = [this](const Iteration& of_part) {
        Iteration i = of_part;
        i.seconds = seconds();
        is_stopped_ = is_stopped_ || !chosen_.on_iteration(i);
        return !is_stopped_;
      };
    const Status status = part.run(std::move(vertices), mesh_.unit, mesh_.features, mesh_.all_labels.size() > 1,
                                   goal == Goal::VALID, parameters);
    status_.iterations += status.iterations;
    status_.rectification_seconds += status.rectification_seconds;
    status_.untangling_seconds += status.untangling_seconds;
    status_.maximization_seconds += status.maximization_seconds;
    return status;
  }

  // Collective.
  bool is_over()
  {
    is_late_ = ranks_.any(is_late_ || seconds() >= chosen_.maximum_running_time);
    is_stopped_ = ranks_.any(is_stopped_);
    return is_late_ || is_stopped_;
  }

  void finish(const Distributed_quality& before)
  {
    const Optimization_parameters defaults;
    const double bound = chosen_.maximum_deviation;
    const auto deviations = [&](const Block_array<Triple>& places) {
      return distributed_deviations(mesh_, places, bound, defaults.measuring_spacing, defaults.certification);
    };
    Distributed_quality after(mesh_, mesh_.points);
    Deviations measured = deviations(mesh_.points);
    const auto excess = [&](const Deviations& d) {
      return std::isfinite(bound) ? (std::max)(0., d.all.certified / bound - 1) : 0.;
    };
    const Merit then{before.statistics.number_of_inverted, before.statistics.number_of_invalid, 0, {}},
      now{after.statistics.number_of_inverted, after.statistics.number_of_invalid, excess(measured), {}};
    bool has_moved = false;
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      has_moved = has_moved || mesh_.points[v] != mesh_.given[v];
    has_moved = ranks_.any(has_moved);
    if (has_moved && (then < now || (then.is_good() && after.statistics.minimum < before.statistics.minimum))) {
      for (std::size_t v = 0; v < mesh_.points.size(); ++v)
        mesh_.points[v] = mesh_.given[v];
      after = Distributed_quality(mesh_, mesh_.points);
      measured = deviations(mesh_.points);
      has_moved = false;
    }
    report(before, after, measured, has_moved);
    mesh_.release();
    slices_.write_points(ranks_.first(mesh_.number_of_vertices), ranks_.last(mesh_.number_of_vertices),
                         mesh_.points.data());
    status_.total_seconds = seconds();
  }

  void report(const Distributed_quality& before, const Distributed_quality& after, const Deviations& measured,
              bool has_moved)
  {
    std::vector<std::int64_t> iterations(1, static_cast<std::int64_t>(status_.iterations));
    ranks_.sum(iterations);
    status_.iterations = static_cast<std::size_t>(iterations[0]);
    status_.after = after.statistics;
    status_.deviation = measured.all;
    status_.deviation_bound = chosen_.maximum_deviation;
    for (std::size_t l = 0; l < mesh_.all_labels.size(); ++l) {
      status_.regions.push_back({mesh_.all_labels[l], before.volumes[l], after.volumes[l]});
      status_.volume_before += before.volumes[l];
      status_.volume_after += after.volumes[l];
    }
    for (std::size_t s = 0; s < mesh_.boundary.labels.size(); ++s)
      if (mesh_.boundary.labels[s][1] != Surface_faces::no_label)
        status_.interfaces.push_back(
          {mesh_.boundary.labels[s], mesh_.boundary.size_of_sheet(static_cast<int>(s)), measured.of_sheet[s]});
    status_.invalid_hexahedra.assign(after.invalid.begin(), after.invalid.end());
    std::vector<Global_index> off;
    for (std::size_t v = 0; v < is_off_.size(); ++v)
      if (is_off_[v])
        off.push_back(ranks_.first(mesh_.number_of_vertices) + static_cast<Global_index>(v));
    off = ranks_.gather_values(off);
    status_.vertices_off_reference.assign(off.begin(), off.end());
    if (mesh_.is_turned) {
      status_.reoriented_hexahedra.resize(static_cast<std::size_t>(mesh_.number_of_hexahedra));
      std::iota(status_.reoriented_hexahedra.begin(), status_.reoriented_hexahedra.end(), std::size_t(0));
    }
    is_over();
    status_.return_code = is_stopped_                            ? Return_code::STOPPED_BY_VISITOR
                          : is_late_                             ? Return_code::TIME_LIMIT
                          : !status_.is_within_deviation_bound() ? Return_code::DEVIATION_BOUND_NOT_MET
                          : !has_moved                           ? Return_code::NO_IMPROVEMENT
                          : status_.valid_mesh() && status_.after.minimum >= chosen_.target_quality
                            ? Return_code::TARGET_QUALITY_REACHED
                            : Return_code::CONVERGED;
  }

  const Clock::time_point start_;
  Mesh_slices& slices_;
  Ranks& ranks_;
  const Chosen_parameters chosen_;
  const Parts_parameters parts_;
  Distributed_mesh mesh_;
  Block_array<char> is_pending_; // of the vertices of this rank: held whenever the mesh was improved
  Block_array<char> is_off_;     // of those: do not stand where they are to stand
  Block_array<char> is_held_;    // of those, while the boundary does not move
  bool was_tangled_ = false, holds_boundary_ = false;
  double worth_raising_to_ = 0; // the minimum, though the boundary has to move for that
  int cut_ = 0;
  bool is_stopped_ = false, is_late_ = false;
  Status status_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_PARTS_OPTIMIZER_H
