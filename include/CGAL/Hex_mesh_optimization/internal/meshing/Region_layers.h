// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_REGION_LAYERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_REGION_LAYERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The faces of a mesh that divide its regions from each other and from what is outside: to which patches of a surface
// they belong, and layers of hexahedra on both sides of them.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Hexahedra.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Layer_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Surface_partition.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/insert_layers.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_adjacency.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Region_layers
{
public:
  // region: of each hexahedron, a label. labels: of the sheets of the partition. Sets mesh.label of both sides of the
  // faces that divide to patches; inserts hexahedra, and their regions.
  Region_layers(Hexahedra& mesh, std::vector<int>& region, const Surface_partition& partition,
                const std::vector<std::array<int, 2>>& labels, const Layer_parameters& parameters)
    : mesh_(mesh)
    , region_(region)
    , partition_(partition)
    , labels_(labels)
    , parameters_(parameters)
  {
    measure_angles();
    number_sides();
    label_faces();
    insert();
  }

  // Of each vertex, the patches of the faces around it, sorted.
  std::vector<std::vector<int>> patches_of_vertices() const
  {
    std::vector<std::vector<int>> result(mesh_.points.size());
    for (std::size_t side = 0; side < opposite_.size(); ++side)
      if (divides(side))
        for (int v : mesh_.face(side))
          result[v].push_back(mesh_.label[side]);
    for (std::vector<int>& patches : result) {
      std::sort(patches.begin(), patches.end());
      patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    }
    return result;
  }

private:
  static constexpr int outside = Reference_input::no_label;

  // Around an edge, from one face that divides to the next: what is between them is of one region.
  struct Wedge
  {
    std::size_t first, last; // sides of that region
    int hexahedra;
  };

  // Of an edge, in cyclic order: closed, or from outside to outside.
  struct Fan
  {
    std::vector<Wedge> wedges;
    bool is_closed;
  };

  int region_beyond(std::size_t side) const { return opposite_[side] < 0 ? outside : region_[opposite_[side] / 6]; }

  bool divides(std::size_t side) const { return divides_[side]; }

  void number_sides()
  {
    opposite_ = opposite_sides(mesh_);
    divides_.resize(opposite_.size());
    for (std::size_t side = 0; side < opposite_.size(); ++side)
      divides_[side] = region_beyond(side) != region_[side / 6];
    fans_.clear();
    std::set<std::tuple<std::size_t, int>> done; // side, its corner
    for (bool from_outside : {true, false})
      for (std::size_t side = 0; side < opposite_.size(); ++side)
        for (int k = 0; k < 4; ++k)
          if (divides(side) && (opposite_[side] < 0) == from_outside && !done.count({side, k}))
            add_fan(side, k, done);
  }

  int corner(std::size_t side, int a, int b) const
  {
    const std::array<int, 4> q = mesh_.face(side);
    for (int k = 0; k < 4; ++k)
      if ((q[k] == a && q[(k + 1) % 4] == b) || (q[k] == b && q[(k + 1) % 4] == a))
        return k;
    return 0;
  }

  void add_fan(std::size_t start, int k, std::set<std::tuple<std::size_t, int>>& done)
  {
    const int a = mesh_.face(start)[k], b = mesh_.face(start)[(k + 1) % 4];
    Fan fan;
    fan.is_closed = false;
    std::size_t first = start;
    for (;;) {
      std::size_t side = side_beside(mesh_, first, a, b);
      int n = 1;
      for (; !divides(side); ++n)
        side = side_beside(mesh_, static_cast<std::size_t>(opposite_[side]), a, b);
      fan.wedges.push_back({first, side, n});
      done.insert({first, corner(first, a, b)});
      done.insert({side, corner(side, a, b)});
      if (opposite_[side] < 0)
        break;
      first = static_cast<std::size_t>(opposite_[side]);
      if (first == start) {
        fan.is_closed = true;
        break;
      }
    }
    fans_.push_back(std::move(fan));
  }

  // Between two patches, through a region, in degrees: the mean over the length of the curves between them.
  void measure_angles()
  {
    std::map<std::tuple<int, int, int>, std::array<double, 2>> sums; // length, and that times the angle
    const Reference_surface& surface = partition_.surface;
    const Triangle_adjacency adjacency(surface.triangles);
    adjacency.for_each_edge([&](const Triangle_adjacency::Sides& sides) {
      for (const std::array<int, 2>& of_sheet : labels_)
        for (int r : of_sheet) {
          std::vector<Triangle_adjacency::Side> around; // faces of the region
          for (const Triangle_adjacency::Side& s : sides)
            if (labels_[surface.sheet(s.triangle)][0] == r || labels_[surface.sheet(s.triangle)][1] == r)
              around.push_back(s);
          if (r == outside || around.size() != 2)
            continue;
          const int p = partition_.patch_of_triangle(around[0].triangle),
                    q = partition_.patch_of_triangle(around[1].triangle);
          if (p == q)
            continue;
          const double length = (surface.points[sides[0].edge[1]] - surface.points[sides[0].edge[0]]).norm();
          std::array<double, 2>& sum = sums[{(std::min)(p, q), (std::max)(p, q), r}];
          sum[0] += length;
          sum[1] += length * interior_angle(around[0], around[1], r);
        }
    });
    for (const auto& [key, sum] : sums)
      if (sum[0] > 0)
        angles_[key] = sum[1] / sum[0];
  }

  double interior_angle(const Triangle_adjacency::Side& a, const Triangle_adjacency::Side& b, int r) const
  {
    const Reference_surface& surface = partition_.surface;
    const auto is_turned = [&](const Triangle_adjacency::Side& s) {
      return labels_[surface.sheet(s.triangle)][0] != r;
    };
    const auto normal = [&](const Triangle_adjacency::Side& s) {
      const Vector_3& origin = surface.corner(s.triangle, 0);
      const Vector_3 n = (surface.corner(s.triangle, 1) - origin).cross(surface.corner(s.triangle, 2) - origin);
      return Vector_3(is_turned(s) ? -n : n);
    };
    const Vector_3 m = normal(a), n = normal(b);
    Vector_3 edge = surface.corner(a.triangle, (a.corner + 1) % 3) - surface.corner(a.triangle, a.corner);
    if (is_turned(a))
      edge = -edge;
    const double bend = std::atan2(m.cross(n).dot(edge.normalized()), m.dot(n)); // positive where convex
    return 180 - bend * 180 / CGAL_PI;
  }

  // 180 within a patch; where patches have no edge in common, as much.
  double angle(const Wedge& w) const
  {
    const int p = mesh_.label[w.first], q = mesh_.label[w.last];
    const auto found = angles_.find({(std::min)(p, q), (std::max)(p, q), region_[w.first / 6]});
    return p == q || found == angles_.end() ? 180 : found->second;
  }

  int sheet_between(int a, int b) const
  {
    const std::array<int, 2> labels = {(std::min)(a, b), (std::max)(a, b)};
    const auto found = std::lower_bound(labels_.begin(), labels_.end(), labels);
    return found != labels_.end() && *found == labels ? static_cast<int>(found - labels_.begin()) : -1;
  }

  // Of the patch that is nearest, of those between the same two regions.
  void label_faces()
  {
    mesh_.label.assign(opposite_.size(), Hexahedra::no_label);
    for (std::size_t side = 0; side < opposite_.size(); ++side)
      if (divides(side) && opposite_[side] <= static_cast<std::ptrdiff_t>(side)) {
        const std::array<int, 4> q = mesh_.face(side);
        const int sheet = (std::max)(0, sheet_between(region_[side / 6], region_beyond(side)));
        Vector_3 center = Vector_3::Zero();
        for (int v : q)
          center += partition_.surface.closest_point(mesh_.points[v], Surface_point::no_triangle, sheet).point / 4;
        set_label(side, partition_.patch_of_triangle(
                          partition_.surface.closest_point(center, Surface_point::no_triangle, sheet).triangle));
      }
    constexpr int most_rounds = 20;
    bool any = true;
    for (int round = 0; any && round < most_rounds; ++round) {
      any = smooth();
      any = drop_islands() || any;
    }
  }

  void set_label(std::size_t side, int label)
  {
    mesh_.label[side] = label;
    if (opposite_[side] >= 0)
      mesh_.label[opposite_[side]] = label;
  }

  // Pairs of neighbors between the same two regions: calls visit(side, side)
  template <class Visit>
  void for_neighbors(const Visit& visit) const
  {
    for (const Fan& fan : fans_)
      for (const Wedge& w : fan.wedges)
        if (region_beyond(w.first) == region_beyond(w.last))
          visit(w.first, w.last);
  }

  // A face with another patch on three sides takes it.
  bool smooth()
  {
    std::map<std::size_t, std::map<int, int>> beside;
    for_neighbors([&](std::size_t a, std::size_t b) {
      ++beside[a][mesh_.label[b]];
      ++beside[b][mesh_.label[a]];
    });
    bool any = false;
    for (const auto& [side, labels] : beside)
      for (const auto& [label, number] : labels)
        if (label != mesh_.label[side] && number >= 3) {
          set_label(side, label);
          any = true;
        }
    return any;
  }

  // Faces of a patch that do not hang together with the most of them take what is around them, if that is between the
  // same regions.
  bool drop_islands()
  {
    Disjoint_sets sets(opposite_.size());
    for_neighbors([&](std::size_t a, std::size_t b) {
      if (mesh_.label[a] == mesh_.label[b])
        sets.unite(a, b);
    });
    for (std::size_t side = 0; side < opposite_.size(); ++side)
      if (divides(side) && opposite_[side] >= 0)
        sets.unite(side, static_cast<std::size_t>(opposite_[side]));
    std::map<std::size_t, int> size;
    for (std::size_t side = 0; side < opposite_.size(); ++side)
      if (divides(side))
        ++size[sets.find(side)];
    std::map<int, std::size_t> largest;
    for (const auto& [root, number] : size) {
      const auto inserted = largest.emplace(mesh_.label[root], root);
      if (number > size[inserted.first->second])
        inserted.first->second = root;
    }
    std::map<std::size_t, std::map<int, int>> around;
    for_neighbors([&](std::size_t a, std::size_t b) {
      if (mesh_.label[a] == mesh_.label[b])
        return;
      for (const auto& [island, other] : {std::pair(a, b), std::pair(b, a)})
        if (largest[mesh_.label[island]] != sets.find(island))
          ++around[sets.find(island)][mesh_.label[other]];
    });
    std::map<std::size_t, int> becomes;
    for (const auto& [root, beside] : around)
      becomes[root] = std::max_element(beside.begin(), beside.end(), [](const auto& a, const auto& b) {
                        return a.second < b.second;
                      })->first;
    for (std::size_t side = 0; side < opposite_.size() && !becomes.empty(); ++side) {
      const auto found = divides(side) ? becomes.find(sets.find(side)) : becomes.end();
      if (found != becomes.end())
        mesh_.label[side] = found->second;
    }
    return !becomes.empty();
  }

  // A layer ends within a region, on a face that is not marked, or goes on through one face that is not, into the next
  // region, to a marked one. Whether all ends of those with a group do so.
  static bool is_consistent(const Fan& fan, const std::vector<int>& groups, int group)
  {
    // of each face around the edge, whether it is marked; those of a closed fan begin with a marked one
    std::vector<char> marks;
    for (int g : groups)
      marks.push_back(g == group);
    const auto marked = std::count(marks.begin(), marks.end(), char(true));
    if (marked == 0)
      return true;
    if (fan.is_closed) {
      std::rotate(marks.begin(), std::find(marks.begin(), marks.end(), char(true)), marks.end());
      marks.push_back(true);
    }
    int passed = 0; // faces not marked since the last marked one
    for (const char is_marked : marks) {
      passed = is_marked ? 0 : passed + 1;
      if (passed > 1)
        return false;
    }
    return true;
  }

  // Of each patch.
  std::vector<int> groups() const
  {
    Disjoint_sets sets(partition_.number_of_patches());
    for (const Fan& fan : fans_)
      for (const Wedge& w : fan.wedges)
        if (mesh_.label[w.first] != mesh_.label[w.last] && angle(w) > parameters_.largest_crossing)
          sets.unite(mesh_.label[w.first], mesh_.label[w.last]);
    for (bool any = true; any;) {
      any = false;
      for (const Fan& fan : fans_)
        any = make_consistent(fan, sets) || any;
    }
    std::vector<int> result;
    for (std::size_t p = 0; p < partition_.number_of_patches(); ++p)
      result.push_back(static_cast<int>(sets.find(p)));
    return result;
  }

  // Of the faces around an edge: those before the wedges, and in an open fan that after the last one.
  std::vector<int> patches_around(const Fan& fan) const
  {
    std::vector<int> result;
    for (const Wedge& w : fan.wedges)
      result.push_back(mesh_.label[w.first]);
    if (!fan.is_closed)
      result.push_back(mesh_.label[fan.wedges.back().last]);
    return result;
  }

  // Unites as few as will do.
  bool make_consistent(const Fan& fan, Disjoint_sets& sets) const
  {
    const std::vector<int> patches = patches_around(fan);
    const auto is_good = [&](int p, int q) { // with both in one group
      std::vector<int> of;
      for (int r : patches) {
        const int g = static_cast<int>(sets.find(r));
        of.push_back(g == q ? p : g);
      }
      return std::all_of(of.begin(), of.end(), [&](int g) { return is_consistent(fan, of, g); });
    };
    if (is_good(-1, -1))
      return false;
    for (std::size_t i = 0; i < patches.size(); ++i)
      for (std::size_t j = i + 1; j < patches.size(); ++j) {
        const int p = static_cast<int>(sets.find(patches[i])), q = static_cast<int>(sets.find(patches[j]));
        if (p != q && is_good(p, q)) {
          sets.unite(patches[i], patches[j]);
          return true;
        }
      }
    for (int p : patches)
      sets.unite(p, patches[0]);
    return true;
  }

  // Those whose faces cannot do with the hexahedra that they have: see Patch_layers.
  std::set<int> groups_in_need(const std::vector<int>& group) const
  {
    const std::vector<std::vector<int>> patches = patches_of_vertices();
    std::map<std::size_t, std::vector<std::pair<int, int>>> borders; // of a side: its corner, the patch beyond
    std::set<int> result;
    for (const Fan& fan : fans_)
      for (const Wedge& w : fan.wedges) {
        const double theta = angle(w);
        if (theta / w.hexahedra > parameters_.largest_crossing || theta / w.hexahedra < parameters_.smallest_angle)
          result.insert({group[mesh_.label[w.first]], group[mesh_.label[w.last]]});
      }
    for (const Fan& fan : fans_)
      for (const Wedge& w : fan.wedges)
        if (mesh_.label[w.first] != mesh_.label[w.last]) {
          const std::array<int, 4> p = mesh_.face(w.first), q = mesh_.face(w.last);
          for (const auto& [side, face, other] : {std::tuple(w.first, p, w.last), std::tuple(w.last, q, w.first)}) {
            int k = 0;
            for (int i = 0; i < 4; ++i) {
              const std::array<int, 4> across = mesh_.face(other);
              if (std::count(across.begin(), across.end(), face[i]) &&
                  std::count(across.begin(), across.end(), face[(i + 1) % 4]))
                k = i;
            }
            borders[side].emplace_back(k, mesh_.label[other]);
          }
        }
    for (const auto& [side, list] : borders)
      for (const auto& [k, beyond] : list)
        for (const auto& [l, also_beyond] : list)
          if (beyond == also_beyond && (k + 1) % 4 == l && patches[mesh_.face(side)[l]].size() == 2)
            result.insert({group[mesh_.label[side]], group[beyond]});
    return result;
  }

  void insert()
  {
    const std::vector<int> group = groups();
    for (int g : groups_in_need(group)) {
      std::vector<char> is_marked(opposite_.size(), false);
      bool any = false;
      for (std::size_t side = 0; side < opposite_.size(); ++side) {
        is_marked[side] = divides(side) && group[mesh_.label[side]] == g;
        any = any || is_marked[side];
      }
      if (!any)
        continue;
      std::vector<int> of_new;
      for (std::size_t side = 0; side < opposite_.size(); ++side)
        if (is_marked[side])
          of_new.push_back(region_[side / 6]);
      insert_layers(mesh_, opposite_, is_marked, parameters_.thickness);
      region_.insert(region_.end(), of_new.begin(), of_new.end());
      number_sides();
      label_rest();
    }
  }

  // Faces that a layer has on the surface between two regions are of the patch that they continue.
  void label_rest()
  {
    for (std::size_t side = 0; side < opposite_.size(); ++side)
      if (!divides(side))
        mesh_.label[side] = Hexahedra::no_label;
    for (bool any = true; any;) {
      any = false;
      for_neighbors([&](std::size_t a, std::size_t b) {
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
          if (mesh_.label[from] != Hexahedra::no_label && mesh_.label[to] == Hexahedra::no_label) {
            set_label(to, mesh_.label[from]);
            any = true;
          }
      });
    }
    for (std::size_t side = 0; side < opposite_.size(); ++side)
      if (divides(side) && mesh_.label[side] == Hexahedra::no_label)
        set_label(side, 0);
  }

  Hexahedra& mesh_;
  std::vector<int>& region_;
  const Surface_partition& partition_;
  const std::vector<std::array<int, 2>>& labels_;
  const Layer_parameters parameters_;
  std::vector<std::ptrdiff_t> opposite_;
  std::vector<char> divides_; // of each side
  std::vector<Fan> fans_;
  std::map<std::tuple<int, int, int>, double> angles_; // of two patches and a region
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_REGION_LAYERS_H
