// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_DISTRIBUTED_MESH_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_DISTRIBUTED_MESH_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A mesh of which each rank has a block of the hexahedra and a block of the vertices, and what all of them have to agree on:
// where its boundary is, its unit of length, and which way is out.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Surface_faces.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Block_array.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Mesh_slices.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Ranks.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_curve_tracer.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

using Triple = std::array<double, 3>;

inline Vector_3 as_vector(const Triple& c) { return Vector_3(c[0], c[1], c[2]); }

// A face of the boundary as the hexahedron has it that comes first.
struct Distributed_face
{
  Global_index side;                    // 6 times the hexahedron and the face
  std::array<Global_index, 4> vertices; // counter-clockwise seen from outside
  std::array<int, 2> labels;            // of the hexahedron, and of the one beyond, or Surface_faces::no_label
};

class Distributed_mesh
{
public:
  // Values of all vertices that hexahedra of this rank have.
  template <class T>
  class Nearby
  {
  public:
    explicit Nearby(const Block_array<T>& all) : values_(all.data()) {}
    explicit Nearby(std::vector<T> some) : some_(std::move(some)), values_(some_.data()) {}
    Nearby(const Nearby&) = delete;
    Nearby& operator=(const Nearby&) = delete;

    const T& operator[](std::size_t i) const { return values_[i]; }

  private:
    const std::vector<T> some_;
    const T* values_;
  };

  // folder: for what need not be in memory; empty: all is. Throws Input_error; other ranks then wait in vain.
  Distributed_mesh(Mesh_slices& slices, Ranks& its_ranks, std::string folder,
                   const Feature_parameters& feature_parameters)
    : ranks(its_ranks)
    , number_of_vertices(slices.number_of_vertices())
    , number_of_hexahedra(slices.number_of_hexahedra())
    , folder_(std::move(folder))
  {
    if (number_of_hexahedra == 0)
      throw Input_error(Input_error::Element::MESH, 0, "the mesh has no hexahedra");
    if (number_of_vertices >= (Global_index(1) << 32) * ranks.size())
      throw Input_error(Input_error::Element::MESH, 0, "the mesh is larger than its indices can count");
    read(slices);
    count_hexahedra();
    pair_faces();
    gather_boundary(feature_parameters);
  }

  Global_index first_hexahedron() const { return ranks.first(number_of_hexahedra); }
  std::size_t number_of_own_hexahedra() const { return hexahedra.size(); }
  std::size_t number_of_nearby() const { return is_all_nearby() ? given.size() : nearby_.size(); }

  Global_index vertex(std::size_t nearby) const
  {
    return is_all_nearby() ? static_cast<Global_index>(nearby) : nearby_[nearby];
  }

  int label(std::size_t own) const { return labels.size() == 0 ? 0 : labels[own]; }

  // Collective.
  template <class T>
  Nearby<T> nearby(const Block_array<T>& of_vertices) const
  {
    if (is_all_nearby())
      return Nearby<T>(of_vertices);
    return Nearby<T>(ranks.fetch<T>(number_of_vertices, of_vertices, nearby_));
  }

  // What hexahedra of any rank say of their vertices comes together: combine(value, other). Collective.
  template <class T, class Combine>
  void combine(const Block_array<T>& of_nearby, Block_array<T>& of_vertices, const Combine& combined) const
  {
    if (is_all_nearby()) {
      for (std::size_t v = 0; v < of_vertices.size(); ++v)
        of_vertices[v] = combined(of_vertices[v], of_nearby[v]);
      return;
    }
    struct Said
    {
      Global_index vertex;
      T value;
    };
    std::vector<std::vector<Said>> to(ranks.size());
    int owner = 0;
    for (std::size_t i = 0; i < nearby_.size(); ++i) {
      while (ranks.first_of_block(number_of_vertices, owner + 1) <= nearby_[i])
        ++owner;
      if (of_nearby[i] != T())
        to[owner].push_back({nearby_[i], of_nearby[i]});
    }
    const Global_index first = ranks.first(number_of_vertices);
    for (const std::vector<Said>& from : ranks.exchange_values(to))
      for (const Said& said : from)
        of_vertices[said.vertex - first] = combined(of_vertices[said.vertex - first], said.value);
  }

  template <class T>
  Block_array<T> new_array(std::size_t size) const
  {
    return Block_array<T>(size, folder_);
  }

  // work(h) for the hexahedra of this rank; what is mapped does not stay.
  template <class Work>
  void for_own_hexahedra(const Work& work) const
  {
    constexpr std::size_t at_once = 1 << 18;
    for (std::size_t begin = 0; begin < hexahedra.size(); begin += at_once) {
      for (std::size_t h = begin; h < (std::min)(hexahedra.size(), begin + at_once); ++h)
        work(h);
      release();
    }
  }

  void release() const
  {
    hexahedra.release();
    given.release();
    points.release();
    labels.release();
    outer_faces.release();
    valence.release();
  }

  std::array<Vector_3, 8> corners(const Nearby<Triple>& places, std::size_t own) const
  {
    std::array<Vector_3, 8> result;
    for (int i = 0; i < 8; ++i)
      result[i] = as_vector(places[hexahedra[own][i]]);
    return result;
  }

  Ranks& ranks;
  const Global_index number_of_vertices, number_of_hexahedra;
  Block_array<std::array<std::uint32_t, 8>>
    hexahedra;                           // of this rank, with the places of their vertices among those nearby
  Block_array<int> labels;               // of those; none: all have the same
  Block_array<std::uint8_t> outer_faces; // of those: bit f says that nothing is beyond face f
  Block_array<Triple> given, points;     // of the vertices of this rank: as they came in, and as they are
  Block_array<int> valence;              // of those: number of hexahedra
  Block_array<char> is_fixed;            // of those
  std::vector<int> all_labels;           // of all ranks, in increasing order
  bool is_turned = false;                // all hexahedra came in inside out

  // The same on all ranks. Vertices are counted among those of the boundary.
  std::vector<Global_index> boundary_vertices; // in increasing order
  Surface_faces boundary;
  double unit = 0;                                   // mean boundary edge
  std::vector<std::array<Global_index, 2>> features; // edges on feature curves of the boundary, in increasing order

private:
  bool is_all_nearby() const { return ranks.size() == 1; }

  void read(Mesh_slices& slices)
  {
    const Global_index first = first_hexahedron(), last = ranks.last(number_of_hexahedra);
    const auto size = static_cast<std::size_t>(last - first);
    hexahedra = new_array<std::array<std::uint32_t, 8>>(size);
    if (!is_all_nearby()) {
      read_hexahedra(slices, [&](std::size_t, const std::array<Global_index, 8>& h) {
        nearby_.insert(nearby_.end(), h.begin(), h.end());
        if (nearby_.size() > 2 * unique_)
          make_unique();
      });
      make_unique();
      nearby_.shrink_to_fit();
    }
    read_hexahedra(slices, [&](std::size_t h, const std::array<Global_index, 8>& vertices) {
      for (int i = 0; i < 8; ++i)
        hexahedra[h][i] = static_cast<std::uint32_t>(
          is_all_nearby() ? vertices[i]
                          : std::lower_bound(nearby_.begin(), nearby_.end(), vertices[i]) - nearby_.begin());
    });
    hexahedra.release();
    if (slices.has_labels()) {
      labels = new_array<int>(size);
      slices.read_labels(first, last, labels.data());
      std::vector<int> own;
      for (std::size_t h = 0; h < size; ++h)
        if (own.empty() || own.back() != labels[h]) {
          own.push_back(labels[h]);
          if (own.size() > 4096)
            sort_unique(own);
        }
      all_labels = ranks.gather_values(own);
    }
    else
      all_labels.assign(1, 0);
    sort_unique(all_labels);
    const Global_index first_vertex = ranks.first(number_of_vertices), last_vertex = ranks.last(number_of_vertices);
    const auto vertices = static_cast<std::size_t>(last_vertex - first_vertex);
    given = new_array<Triple>(vertices);
    points = new_array<Triple>(vertices);
    is_fixed = new_array<char>(vertices);
    slices.read_points(first_vertex, last_vertex, given.data());
    slices.read_fixed(first_vertex, last_vertex, is_fixed.data());
    for (std::size_t v = 0; v < vertices; ++v) {
      if (!as_vector(given[v]).allFinite())
        throw Input_error(Input_error::Element::VERTEX, static_cast<std::size_t>(first_vertex) + v,
                          "vertex " + std::to_string(first_vertex + static_cast<Global_index>(v)) +
                            " has a coordinate that is not finite");
      points[v] = given[v];
    }
    release();
  }

  template <class Take>
  void read_hexahedra(Mesh_slices& slices, const Take& take) const
  {
    constexpr Global_index at_once = 1 << 16;
    std::vector<std::array<Global_index, 8>> some;
    const Global_index first = first_hexahedron(), last = ranks.last(number_of_hexahedra);
    for (Global_index begin = first; begin < last; begin += at_once) {
      const Global_index end = (std::min)(last, begin + at_once);
      some.resize(static_cast<std::size_t>(end - begin));
      slices.read_hexahedra(begin, end, some.data());
      for (std::size_t i = 0; i < some.size(); ++i) {
        check(begin + static_cast<Global_index>(i), some[i]);
        take(static_cast<std::size_t>(begin - first) + i, some[i]);
      }
    }
  }

  void check(Global_index h, const std::array<Global_index, 8>& vertices) const
  {
    for (int i = 0; i < 8; ++i) {
      if (vertices[i] < 0 || vertices[i] >= number_of_vertices)
        throw Input_error(Input_error::Element::HEXAHEDRON, static_cast<std::size_t>(h),
                          "hexahedron " + std::to_string(h) + " refers to a vertex that does not exist");
      for (int j = 0; j < i; ++j)
        if (vertices[i] == vertices[j])
          throw Input_error(Input_error::Element::HEXAHEDRON, static_cast<std::size_t>(h),
                            "hexahedron " + std::to_string(h) + " has vertex " + std::to_string(vertices[i]) +
                              " at two corners");
    }
  }

  template <class T>
  static void sort_unique(std::vector<T>& values)
  {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }

  void make_unique()
  {
    sort_unique(nearby_);
    unique_ = (std::max)(nearby_.size(), std::size_t(1) << 20);
  }

  void count_hexahedra()
  {
    Block_array<int> of_nearby = new_array<int>(number_of_nearby());
    valence = new_array<int>(given.size());
    for_own_hexahedra([&](std::size_t h) {
      for (std::uint32_t v : hexahedra[h])
        ++of_nearby[v];
    });
    combine(of_nearby, valence, std::plus<int>());
  }

  struct Side
  {
    std::array<Global_index, 4> vertices; // the least one, then in the order that leads to the lesser of its neighbors
    Global_index side;
    int label;
    bool is_reversed; // that order is not the one seen from outside

    bool has_vertices_of(const Side& other) const
    {
      std::array<Global_index, 4> a = vertices, b = other.vertices;
      std::sort(a.begin(), a.end());
      std::sort(b.begin(), b.end());
      return a == b;
    }
  };

  struct Found
  {
    Global_index side;
    int beyond; // label
  };

  // Sides with the same vertices come together at the rank that has the least of these: some of the vertices at once.
  void pair_faces()
  {
    outer_faces = new_array<std::uint8_t>(hexahedra.size());
    constexpr Global_index sides_at_once = 1 << 21;
    const Global_index rounds = 1 + 6 * (number_of_hexahedra / ranks.size()) / sides_at_once;
    std::vector<Found> all;
    for (Global_index round = 0; round < rounds; ++round) {
      std::vector<std::vector<Side>> to(ranks.size());
      for_own_hexahedra([&](std::size_t h) {
        std::array<Global_index, 8> vertices;
        for (int i = 0; i < 8; ++i)
          vertices[i] = vertex(hexahedra[h][i]);
        for (int f = 0; f < 6; ++f) {
          const Side side = side_of(vertices, h, f);
          const Global_index least = side.vertices[0];
          const int owner = ranks.owner(number_of_vertices, least);
          const Global_index first = ranks.first_of_block(number_of_vertices, owner),
                             last = ranks.first_of_block(number_of_vertices, owner + 1);
          const Global_index size = (last - first + rounds - 1) / rounds;
          if ((least - first) / size == round)
            to[owner].push_back(side);
        }
      });
      std::vector<std::vector<Side>> from = ranks.exchange_values(to);
      to.clear();
      std::vector<Side> sides;
      for (std::vector<Side>& some : from) {
        sides.insert(sides.end(), some.begin(), some.end());
        std::vector<Side>().swap(some);
      }
      std::vector<std::vector<Found>> back(ranks.size());
      match(sides, back);
      for (const std::vector<Found>& some : ranks.exchange_values(back))
        all.insert(all.end(), some.begin(), some.end());
    }
    std::sort(all.begin(), all.end(), [](const Found& a, const Found& b) { return a.side < b.side; });
    for (const Found& f : all) {
      const auto h = static_cast<std::size_t>(f.side / 6 - first_hexahedron());
      const int face = static_cast<int>(f.side % 6);
      if (f.beyond == Surface_faces::no_label)
        outer_faces[h] |= static_cast<std::uint8_t>(1 << face);
      Distributed_face own{f.side, {}, {label(h), f.beyond}};
      for (int k = 0; k < 4; ++k)
        own.vertices[k] = vertex(hexahedra[h][hexahedron_faces[face][k]]);
      own_faces_.push_back(own);
    }
    release();
  }

  Side side_of(const std::array<Global_index, 8>& vertices, std::size_t h, int face) const
  {
    std::array<Global_index, 4> v;
    for (int k = 0; k < 4; ++k)
      v[k] = vertices[hexahedron_faces[face][k]];
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    const bool is_reversed = v[3] < v[1];
    if (is_reversed)
      std::swap(v[1], v[3]);
    return {v, 6 * (first_hexahedron() + static_cast<Global_index>(h)) + face, label(h), is_reversed};
  }

  void match(std::vector<Side>& sides, std::vector<std::vector<Found>>& back) const
  {
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return std::tie(a.vertices, a.side) < std::tie(b.vertices, b.side); });
    const auto found = [&](const Side& side, int beyond) {
      back[ranks.owner(number_of_hexahedra, side.side / 6)].push_back({side.side, beyond});
    };
    for (std::size_t i = 0, end; i < sides.size(); i = end) {
      for (end = i + 1; end < sides.size() && sides[end].vertices == sides[i].vertices;)
        ++end;
      const std::string first = std::to_string(sides[i].side / 6);
      if (end - i > 2)
        refuse(sides[i + 2], "hexahedron " + std::to_string(sides[i + 2].side / 6) +
                               " is the third one on a face that hexahedra " + first + " and " +
                               std::to_string(sides[i + 1].side / 6) + " already share");
      if (end - i == 1) {
        found(sides[i], Surface_faces::no_label);
        continue;
      }
      const std::string both = "hexahedra " + first + " and " + std::to_string(sides[i + 1].side / 6);
      if (sides[i].is_reversed == sides[i + 1].is_reversed)
        refuse(sides[i + 1], both + " do not agree which way is out: one of them is numbered inside out, and a mesh in "
                                    "parts must be numbered alike");
      if (sides[i].label != sides[i + 1].label) {
        const std::size_t low = sides[i].label < sides[i + 1].label ? i : i + 1;
        found(sides[low], sides[2 * i + 1 - low].label);
      }
    }
    // with the same vertices in another order
    for (std::size_t i = 1; i < sides.size(); ++i)
      if (sides[i - 1].vertices != sides[i].vertices && sides[i - 1].vertices[0] == sides[i].vertices[0] &&
          sides[i - 1].has_vertices_of(sides[i]))
        refuse(sides[i], "hexahedra " + std::to_string(sides[i - 1].side / 6) + " and " +
                           std::to_string(sides[i].side / 6) +
                           " share four vertices but not a face with opposite orientations");
  }

  [[noreturn]] static void refuse(const Side& side, const std::string& message)
  {
    throw Input_error(Input_error::Element::HEXAHEDRON, static_cast<std::size_t>(side.side / 6), message);
  }

  void gather_boundary(const Feature_parameters& feature_parameters)
  {
    std::vector<Distributed_face> all = ranks.gather_values(own_faces_);
    std::vector<Distributed_face>().swap(own_faces_);
    if (all.empty())
      throw Input_error(Input_error::Element::MESH, 0, "the mesh has no boundary: every face belongs to two hexahedra");
    std::sort(all.begin(), all.end(),
              [](const Distributed_face& a, const Distributed_face& b) { return a.side < b.side; });
    for (const Distributed_face& f : all)
      boundary_vertices.insert(boundary_vertices.end(), f.vertices.begin(), f.vertices.end());
    sort_unique(boundary_vertices);
    for (const Distributed_face& f : all) {
      boundary.labels.push_back(f.labels);
      std::array<int, 4> quad;
      for (int k = 0; k < 4; ++k)
        quad[k] = static_cast<int>(std::lower_bound(boundary_vertices.begin(), boundary_vertices.end(), f.vertices[k]) -
                                   boundary_vertices.begin());
      boundary.quads.push_back(quad);
    }
    const std::vector<std::array<int, 2>> of_faces = boundary.labels;
    sort_unique(boundary.labels);
    if (boundary.labels.size() > 1)
      for (const std::array<int, 2>& l : of_faces)
        boundary.sheets.push_back(static_cast<int>(std::lower_bound(boundary.labels.begin(), boundary.labels.end(), l) -
                                                   boundary.labels.begin()));
    const std::vector<Triple> places = ranks.fetch<Triple>(number_of_vertices, given, boundary_vertices);
    unit = mean_edge(places);
    if (!(unit > 0) || !std::isfinite(unit))
      throw Input_error(Input_error::Element::MESH, 0,
                        "all vertices of the boundary lie in one point, or too far apart for their coordinates");
    if (enclosed_volume(places, of_faces) < 0)
      turn();
    find_features(places, feature_parameters);
  }

  // As they are found in one piece: a part may see too little of a curve, or of what is beside it.
  void find_features(const std::vector<Triple>& places, const Feature_parameters& parameters)
  {
    Positions in_units;
    for (const Triple& p : places)
      in_units.push_back((as_vector(p) - as_vector(places.front())) / unit);
    const auto normal = [&](int f) {
      const std::array<int, 4>& q = boundary.quads[f];
      return Vector_3((in_units[q[2]] - in_units[q[0]]).cross(in_units[q[3]] - in_units[q[1]]));
    };
    struct Side_of_edge
    {
      std::array<int, 2> edge; // the lower vertex first
      bool is_reversed;
      int face;
    };
    std::vector<Side_of_edge> sides;
    for (std::size_t f = 0; f < boundary.quads.size(); ++f)
      for (int k = 0; k < 4; ++k) {
        const int a = boundary.quads[f][k], b = boundary.quads[f][(k + 1) % 4];
        sides.push_back({{(std::min)(a, b), (std::max)(a, b)}, b < a, static_cast<int>(f)});
      }
    std::sort(sides.begin(), sides.end(), [](const Side_of_edge& a, const Side_of_edge& b) {
      return std::tie(a.edge, a.is_reversed, a.face) < std::tie(b.edge, b.is_reversed, b.face);
    });
    const double bound = std::cos(parameters.angle_bound * CGAL_PI / 180);
    Edge_list sharp;
    for (std::size_t i = 0, end; i < sides.size(); i = end) {
      for (end = i + 1; end < sides.size() && sides[end].edge == sides[i].edge;)
        ++end;
      const bool is_manifold = end - i == 2 && sides[i].is_reversed != sides[i + 1].is_reversed;
      const Vector_3 left = normal(sides[i].face), right = normal(sides[end - 1].face);
      if (!is_manifold || left.dot(right) < bound * left.norm() * right.norm())
        sharp.push_back(sides[i].edge);
    }
    const Feature_curve_tracer tracer(in_units, split_quads(boundary.quads), std::move(sharp), false, parameters);
    for (const std::vector<int>& curve : tracer.curves())
      for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const auto [low, high] = std::minmax(curve[i], curve[i + 1]);
        features.push_back({boundary_vertices[low], boundary_vertices[high]});
      }
    sort_unique(features);
  }

  double mean_edge(const std::vector<Triple>& places) const
  {
    std::vector<std::array<int, 2>> edges;
    for (const std::array<int, 4>& q : boundary.quads)
      for (int k = 0; k < 4; ++k) {
        const auto [low, high] = std::minmax(q[k], q[(k + 1) % 4]);
        edges.push_back({low, high});
      }
    sort_unique(edges);
    double sum = 0;
    for (const std::array<int, 2>& e : edges)
      sum += (as_vector(places[e[1]]) - as_vector(places[e[0]])).norm();
    return sum / double(edges.size());
  }

  // Up to a factor.
  double enclosed_volume(const std::vector<Triple>& places,
                         const std::vector<std::array<int, 2>>& labels_of_faces) const
  {
    const Vector_3 origin = as_vector(places.front());
    double volume = 0;
    for (std::size_t f = 0; f < boundary.quads.size(); ++f) {
      if (labels_of_faces[f][1] != Surface_faces::no_label)
        continue;
      Vector_3 p[4];
      for (int i = 0; i < 4; ++i)
        p[i] = (as_vector(places[boundary.quads[f][i]]) - origin) / unit;
      volume += p[0].dot(p[1].cross(p[2])) + p[0].dot(p[2].cross(p[3])) + p[1].dot(p[2].cross(p[3])) +
                p[0].dot(p[1].cross(p[3]));
    }
    return volume;
  }

  // Bottom and top are exchanged.
  void turn()
  {
    is_turned = true;
    for_own_hexahedra([&](std::size_t h) {
      std::swap_ranges(hexahedra[h].begin(), hexahedra[h].begin() + 4, hexahedra[h].begin() + 4);
      // as do their faces; each of the others stays where it is
      const std::uint8_t faces = outer_faces[h];
      outer_faces[h] = static_cast<std::uint8_t>((faces & ~3) | (faces & 1) << 1 | (faces & 2) >> 1);
    });
    for (std::array<int, 4>& q : boundary.quads)
      std::swap(q[1], q[3]);
  }

  const std::string folder_;
  std::vector<Global_index> nearby_; // vertices that hexahedra of this rank have; none where all are of this rank
  std::size_t unique_ = std::size_t(1) << 20;
  std::vector<Distributed_face> own_faces_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_DISTRIBUTED_MESH_H
