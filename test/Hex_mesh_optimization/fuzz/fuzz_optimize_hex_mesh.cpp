// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fuzz target of optimize_hex_mesh(). The bytes are a recipe: a small block of hexahedra, then edits of its
// connectivity, coordinates and regions, and options. Whatever comes of it is refused by the documented exception and
// unchanged, or obeys the guarantees.

#include "Byte_reader.h"
#include "Input_file.h"

#include "../Marked_vertices.h"
#include "../mesh_checks.h"
#include "../mesh_families.h"

#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/quality.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/optimize_hex_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace params = CGAL::parameters;

using Mesh = Indexed_mesh;
using Point = Mesh::Point;
using Surface_mesh = CGAL::Surface_mesh<Point>;

struct Options
{
  HMO::Method method;
  std::size_t iterations, restarts;
  int calls; // of the visitor until it asks for an end
  bool fixed_boundary, has_reference;
};

// What divides the mesh, unless it is edited away.
struct Regions
{
  std::vector<int> labels; // of the hexahedra that there have been; those added later have the label 0
  std::vector<std::array<std::size_t, 4>> faces;

  int label(std::size_t h) const { return h < labels.size() ? labels[h] : 0; }
};

struct Label_map
{
  using key_type = std::size_t;
  using value_type = int;
  using reference = int;
  using category = boost::readable_property_map_tag;
  const Regions* regions;
  friend int get(const Label_map& map, std::size_t h) { return map.regions->label(h); }
};

// Ends the run after a number of iterations.
struct Patience
{
  int left;
  bool on_iteration(const HMO::Iteration&) { return left-- > 0; }
};

Options read_options(fuzz::Byte_reader& bytes)
{
  using HMO::Method;
  Options o;
  o.method = std::array<Method, 4>{Method::FULL, Method::RECTIFICATION, Method::MAXIMIZATION,
                                   Method::FULL}[bytes.below(4)];
  o.iterations = bytes.below(4);
  o.restarts = bytes.below(2);
  o.calls = int(bytes.below(16));
  o.fixed_boundary = bytes.below(4) == 1;
  o.has_reference = bytes.below(2) == 1;
  return o;
}

double& coordinate(std::array<double, 3>& p, fuzz::Byte_reader& bytes) { return p[bytes.below(3)]; }

std::array<double, 3> coordinates(const Point& p) { return {p.x(), p.y(), p.z()}; }

void edit(Mesh& mesh, Regions& regions, std::vector<char>& is_fixed, fuzz::Byte_reader& bytes)
{
  const auto any_vertex = [&] { return bytes.below(mesh.points.size()); };
  const auto any_hexahedron = [&]() -> std::array<std::size_t, 8>& {
    return mesh.hexahedra[bytes.below(mesh.hexahedra.size())];
  };
  const auto set = [&](std::size_t v, const std::array<double, 3>& p) { mesh.points[v] = Point(p[0], p[1], p[2]); };
  switch (bytes.below(mesh.hexahedra.empty() ? 6 : 16)) {
  case 0: { // a small move
    const std::size_t v = any_vertex();
    std::array<double, 3> p = coordinates(mesh.points[v]);
    for (double& x : p)
      x += bytes.signed_byte() / 64.;
    set(v, p);
    break;
  }
  case 1: { // any bits as a coordinate
    const std::size_t v = any_vertex();
    std::array<double, 3> p = coordinates(mesh.points[v]);
    coordinate(p, bytes) = bytes.bits_of_double();
    set(v, p);
    break;
  }
  case 2: // two vertices in one place
    mesh.points[any_vertex()] = mesh.points[any_vertex()];
    break;
  case 3: { // another scale along an axis, zero among them
    const std::size_t axis = bytes.below(3);
    const int exponent = bytes.signed_byte();
    const double factor = exponent == 0 ? 0 : std::ldexp(1, exponent);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      std::array<double, 3> p = coordinates(mesh.points[v]);
      p[axis] *= factor;
      set(v, p);
    }
    break;
  }
  case 4:
    is_fixed[any_vertex()] = true;
    break;
  case 5: // a vertex of no hexahedron
    mesh.points.push_back(mesh.points[any_vertex()]);
    is_fixed.push_back(false);
    break;
  case 6: { // one vertex in the place of another in all hexahedra
    const std::size_t a = any_vertex(), b = any_vertex();
    for (auto& h : mesh.hexahedra)
      std::replace(h.begin(), h.end(), a, b);
    break;
  }
  case 7: // any index, also beyond the end
    any_hexahedron()[bytes.below(8)] = bytes.below(mesh.points.size() + 2);
    break;
  case 8: {
    auto& h = any_hexahedron();
    const std::size_t i = bytes.below(8), k = bytes.below(8);
    std::swap(h[i], h[k]);
    break;
  }
  case 9: // all hexahedra inside out
    for (auto& h : mesh.hexahedra)
      std::swap_ranges(h.begin(), h.begin() + 4, h.begin() + 4);
    break;
  case 10:
    if (mesh.hexahedra.size() < 20) {
      const auto again = any_hexahedron();
      mesh.hexahedra.push_back(again);
    }
    break;
  case 11:
    mesh.hexahedra.erase(mesh.hexahedra.begin() + std::ptrdiff_t(bytes.below(mesh.hexahedra.size())));
    break;
  case 12: { // one hexahedron inside out
    auto& h = any_hexahedron();
    std::swap_ranges(h.begin(), h.begin() + 4, h.begin() + 4);
    break;
  }
  case 13: // a hexahedron gets vertices of its own in the same places
    if (mesh.points.size() < 60)
      for (std::size_t& v : any_hexahedron())
        if (v < mesh.points.size()) {
          mesh.points.push_back(Point(mesh.points[v]));
          is_fixed.push_back(is_fixed[v]);
          v = mesh.points.size() - 1;
        }
    break;
  case 14: // another region
    regions.labels.resize(mesh.hexahedra.size(), 0);
    regions.labels[bytes.below(mesh.hexahedra.size())] = bytes.signed_byte();
    break;
  case 15: { // an internal face, of a hexahedron or of any vertices
    const auto& h = any_hexahedron();
    const auto& f = HMO::internal::hexahedron_faces[bytes.below(6)];
    regions.faces.push_back({h[f[0]], h[f[1]], h[f[2]], h[f[3]]});
    if (bytes.below(8) == 7)
      regions.faces.back()[bytes.below(4)] = bytes.below(mesh.points.size() + 2);
    break;
  }
  }
}

// The boundary of a block, some of its vertices moved.
Surface_mesh read_reference(fuzz::Byte_reader& bytes)
{
  const std::size_t n = 1 + bytes.below(2);
  const double scale = std::ldexp(1, bytes.signed_byte() / 40); // half of them are too large or too small
  Mesh block;
  HMO::make_block(block.points, block.hexahedra, {{n, n, n}}, {{2, 2, 2}});
  Surface_mesh surface;
  std::vector<Surface_mesh::Vertex_index> number;
  for (const Point& p : block.points)
    number.push_back(surface.add_vertex(Point(scale * p.x(), scale * p.y(), scale * p.z())));
  const auto faces = block.complex().boundary_faces;
  for (const auto& f : faces) {
    if (bytes.below(32) == 31) // a hole
      continue;
    surface.add_face(number[f.vertices[0]], number[f.vertices[1]], number[f.vertices[2]]);
    surface.add_face(number[f.vertices[0]], number[f.vertices[2]], number[f.vertices[3]]);
  }
  for (std::size_t moves = bytes.below(4); moves > 0; --moves) {
    Point& p = surface.point(number[bytes.below(number.size())]);
    std::array<double, 3> q = coordinates(p);
    coordinate(q, bytes) = bytes.below(4) == 0 ? bytes.bits_of_double() : bytes.signed_byte() / 32.;
    p = Point(q[0], q[1], q[2]);
  }
  return surface;
}

void require_guarantees(Mesh before, Mesh after, const Regions& regions, const std::vector<char>& is_fixed,
                        bool is_on_reference, const HMO::Status& status)
{
  for (std::size_t v = 0; v < before.points.size(); ++v) {
    fuzz::require(!is_fixed[v] || same_bits(before.points[v], after.points[v]), "fixed vertices stay");
    for (int d = 0; d < 3; ++d)
      fuzz::require(std::isfinite(after.points[v][d]), "coordinates are finite");
  }
  for (Mesh* m : {&before, &after})
    for (std::size_t h : status.reoriented_hexahedra)
      std::swap_ranges(m->hexahedra[h].begin(), m->hexahedra[h].begin() + 4, m->hexahedra[h].begin() + 4);
  const HMO::Quality_statistics a = HMO::quality_statistics(before.points, before.hexahedra);
  const HMO::Quality_statistics b = HMO::quality_statistics(after.points, after.hexahedra);
  const std::vector<std::size_t> invalid = invalid_hexahedra(after);
  fuzz::require(b.number_of_inverted <= a.number_of_inverted, "the number of inverted hexahedra does not rise");
  if (invalid_hexahedra(before).empty()) {
    fuzz::require(invalid.empty(), "a valid mesh stays valid");
    fuzz::require(!is_on_reference || b.minimum >= a.minimum,
                  "the minimum of a valid mesh on its reference does not fall");
  }
  fuzz::require(status.invalid_hexahedra == invalid, "the status lists the invalid hexahedra");
  fuzz::require(status.valid_mesh() == invalid.empty(), "the status knows whether the mesh is valid");
  std::set<int> labels;
  for (std::size_t h = 0; h < before.hexahedra.size(); ++h)
    labels.insert(regions.label(h));
  fuzz::require(status.regions.size() == labels.size(), "the status has a volume for each label");
  for (const HMO::Interface_statistics& i : status.interfaces)
    fuzz::require(labels.count(i.labels[0]) && labels.count(i.labels[1]) && i.labels[0] <= i.labels[1] &&
                    i.number_of_faces > 0,
                  "interfaces are between labels");
  fuzz::require(status.after.number_of_inverted == b.number_of_inverted, "the status counts the inverted hexahedra");
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) { return 0; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Byte_reader bytes(data, size);
  const Options options = read_options(bytes);
  Mesh mesh;
  const std::size_t nx = 1 + bytes.below(3), ny = 1 + bytes.below(2), nz = 1 + bytes.below(2);
  HMO::make_block(mesh.points, mesh.hexahedra, {{nx, ny, nz}}, {{double(nx), double(ny), double(nz)}});
  Surface_mesh reference;
  if (options.has_reference)
    reference = read_reference(bytes);
  std::vector<char> is_fixed(mesh.points.size(), false);
  Regions regions;
  for (int edits = 0; edits < 64 && !bytes.is_empty(); ++edits)
    edit(mesh, regions, is_fixed, bytes);

  const Mesh before = mesh;
  const auto np = params::optimization_method(options.method)
                    .number_of_iterations(options.iterations)
                    .number_of_restarts(options.restarts)
                    .fixed_boundary(options.fixed_boundary)
                    .vertex_is_constrained_map(Marked_vertices{&is_fixed})
                    .hexahedron_label_map(Label_map{&regions})
                    .internal_faces(regions.faces)
                    .visitor(Patience{options.calls});
  HMO::Status status;
  try {
    status = options.has_reference ? CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, reference, np)
                                   : CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, np);
  }
  catch (const HMO::Input_error&) {
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      fuzz::require(same_bits(mesh.points[v], before.points[v]), "what is refused is unchanged");
    return 0;
  }
  fuzz::require(mesh.hexahedra == before.hexahedra && mesh.points.size() == before.points.size(),
                "the connectivity stays");
  require_guarantees(before, mesh, regions, is_fixed, !options.has_reference, status);
  return 0;
}
