// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The compiled part of the Python module: hex_mesh_optimization._engine. Its functions take arguments that the Python
// part has checked.

#include "Report_page.h"
#include "arrays.h"
#include "files.h"
#include "optimize.h"
#include "options.h"
#include "status.h"

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_attachments.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/lost_attachments.h>
#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_mesh_to_reference.h>
#include <CGAL/Hex_mesh_optimization/quality.h>
#include <CGAL/Hex_mesh_optimization/validity.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

using Attachments = CGAL::IO::Hex_mesh_attachments;

void require_vertices(const Table& hexahedra, std::size_t number_of_points)
{
  for (std::size_t h = 0; h < hexahedra.rows(); ++h)
    for (std::size_t k = 0; k < 8; ++k) {
      const std::int64_t v = hexahedra.index(h, k);
      if (v < 0 || static_cast<std::uint64_t>(v) >= number_of_points)
        throw HMO::Input_error(HMO::Input_error::Element::HEXAHEDRON, h,
                               "hexahedron " + std::to_string(h) + " refers to a vertex that does not exist");
    }
}

std::set<Edge> feature_edges(const Table& edges, const Table& triangles)
{
  std::set<Edge> all, result;
  for (const auto& t : cell_range<3>(triangles))
    for (std::size_t k = 0; k < 3; ++k)
      all.insert(edge_of(t[k], t[(k + 1) % 3]));
  for (const auto& e : cell_range<2>(edges)) {
    if (all.count(edge_of(e[0], e[1])) == 0)
      throw py::value_error("edge_is_constrained_map: no triangle has the edge between the vertices " +
                            std::to_string(e[0]) + " and " + std::to_string(e[1]));
    result.insert(edge_of(e[0], e[1]));
  }
  return result;
}

namespace {

// Both are ranges that can be indexed, as the functions of the package ask for.
struct Mesh_of_arrays
{
  struct Point_container
  {
    Point_of_row row;
    Kernel::Point_3 operator[](std::size_t v) const { return row(v); }
  };

  Table hexahedra;
  Point_container points;

  Mesh_of_arrays(const py::array& p, const py::array& h) : hexahedra(h), points{{Table(p)}}
  {
    require_vertices(hexahedra, points.row.table.rows());
  }
};

py::array quality(const py::array& points, const py::array& hexahedra)
{
  const Mesh_of_arrays mesh(points, hexahedra);
  std::vector<double> result;
  {
    const py::gil_scoped_release unlocked;
    result = HMO::scaled_jacobians(mesh.points, cell_range<8>(mesh.hexahedra));
  }
  return as_array(std::move(result));
}

py::array invalid(const py::array& points, const py::array& hexahedra)
{
  const Mesh_of_arrays mesh(points, hexahedra);
  std::vector<std::int64_t> result;
  {
    const py::gil_scoped_release unlocked;
    HMO::invalid_hexahedra(mesh.points, cell_range<8>(mesh.hexahedra), std::back_inserter(result));
  }
  return as_array(std::move(result));
}

py::dict statistics(const py::array& points, const py::array& hexahedra)
{
  const Mesh_of_arrays mesh(points, hexahedra);
  HMO::Quality_statistics result;
  {
    const py::gil_scoped_release unlocked;
    result = HMO::quality_statistics(mesh.points, cell_range<8>(mesh.hexahedra));
  }
  return as_dict(result);
}

Points points_of(const py::array& points)
{
  const auto range = point_range(Table(points));
  return Points(range.begin(), range.end());
}

Hexahedra hexahedra_of(const py::array& hexahedra)
{
  Hexahedra result;
  for (const auto& h : cell_range<8>(Table(hexahedra))) {
    result.emplace_back();
    std::copy(h.begin(), h.end(), result.back().begin());
  }
  return result;
}

// Of the faces between hexahedra that have a label in the file, as the program optimize_hex_mesh keeps them.
std::vector<std::array<std::int64_t, 4>> internal_faces(const Attachments& attachments)
{
  std::vector<std::array<std::int64_t, 4>> result;
  for (const auto& q : attachments.labelled_quadrilaterals())
    if (q.label != 0) {
      result.emplace_back();
      std::copy(q.vertices.begin(), q.vertices.end(), result.back().begin());
    }
  return result;
}

py::dict as_dict(Points&& points, Hexahedra&& hexahedra, Attachments&& attachments)
{
  const auto size = static_cast<py::ssize_t>(hexahedra.size());
  const void* corners;
  const py::capsule owner = owner_of(std::move(hexahedra), corners);
  py::dict result;
  result["points"] = as_array(std::move(points));
  static_assert(sizeof(std::size_t) == sizeof(std::int64_t), "indices are integers of numpy");
  result["hexahedra"] = py::array_t<std::int64_t>({size, py::ssize_t(8)}, static_cast<const std::int64_t*>(corners),
                                                  owner);
  result["labels"] = attachments.hexahedron_labels.empty()
                       ? py::object(py::none())
                       : py::object(as_array(std::vector<std::int64_t>(attachments.hexahedron_labels)));
  result["internal_faces"] = as_array(internal_faces(attachments));
  result["left_out"] = attachments.left_out;
  result["attachments"] = std::move(attachments);
  return result;
}

// label_array: of a file of VTK, or empty
py::dict read_mesh(const std::string& filename, const std::string& label_array)
{
  Points points;
  Hexahedra hexahedra;
  Attachments attachments;
  {
    const py::gil_scoped_release unlocked;
    read(filename, points, hexahedra, attachments);
  }
  if (!label_array.empty() && !attachments.use_label_array(label_array))
    throw CGAL::IO::Hex_mesh_file_error(filename, 0,
                                        "there is no array \"" + label_array +
                                          "\" with one integral number for each cell");
  return as_dict(std::move(points), std::move(hexahedra), std::move(attachments));
}

py::tuple read_triangles(const std::string& filename)
{
  HMO::internal::Reference_input reference;
  {
    const py::gil_scoped_release unlocked;
    Surface surface;
    read(filename, surface);
    reference = HMO::internal::triangle_mesh_to_reference(surface, CGAL::parameters::default_values());
  }
  Points points;
  for (const auto& p : reference.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::array<std::int64_t, 3>> triangles;
  for (const auto& t : reference.triangles)
    triangles.push_back({t[0], t[1], t[2]});
  return py::make_tuple(as_array(std::move(points)), as_array(std::move(triangles)));
}

// Returns what the format cannot hold. labels: of a mesh that is of no file, or empty.
std::vector<std::string> write_mesh(const std::string& filename, const py::array& points, const py::array& hexahedra,
                                    const Attachments* attachments, const std::vector<std::int64_t>& labels)
{
  require_vertices(Table(hexahedra), Table(points).rows());
  Attachments own;
  if (attachments == nullptr) {
    own.hexahedron_labels = labels;
    attachments = &own;
  }
  const Points all_points = points_of(points);
  const Hexahedra all_hexahedra = hexahedra_of(hexahedra);
  const py::gil_scoped_release unlocked;
  write(filename, all_points, all_hexahedra, *attachments);
  return CGAL::IO::lost_attachments(filename, *attachments);
}

using Named_mesh = std::tuple<std::string, std::string, py::array, py::array>; // role and name, see Report_page

struct Shown_mesh
{
  std::string role, name;
  Points points;
  Hexahedra hexahedra;
};

HMO::internal::Reference_input reference_of(const py::object& reference)
{
  const auto [vertices, triangles] = reference.cast<std::pair<py::array, py::array>>();
  return HMO::internal::triangle_soup_to_reference(point_range(Table(vertices)), cell_range<3>(Table(triangles)),
                                                   CGAL::parameters::default_values());
}

// report: as the programs write it, but that the deviation may be missing. why_it_stopped: empty if there was no run.
void write_page(const std::string& filename, const std::string& title, const std::vector<Named_mesh>& named_meshes,
                const py::object& reference, const std::vector<std::int64_t>& labels, const std::string& report,
                const std::string& why_it_stopped)
{
  const std::string reason = Report_page::reason_of_absence();
  if (!reason.empty())
    throw std::runtime_error(reason);
  const bool has_reference = !reference.is_none();
  HMO::internal::Reference_input surface;
  if (has_reference)
    surface = reference_of(reference);
  std::vector<Shown_mesh> meshes;
  for (const auto& [role, name, points, hexahedra] : named_meshes) {
    require_vertices(Table(hexahedra), Table(points).rows());
    meshes.push_back({role, name, points_of(points), hexahedra_of(hexahedra)});
  }

  const py::gil_scoped_release unlocked;
  Report_page page;
  if (has_reference)
    page.set_reference(std::move(surface.points), std::move(surface.triangles));
  for (const Shown_mesh& mesh : meshes)
    page.add_mesh(mesh.role, mesh.name, mesh.points, mesh.hexahedra);
  page.add_reference(has_reference ? "Reference" : "Boundary before");
  const Labels numbered(labels);
  if (numbered.values.size() > 1)
    page.add_labels(numbered.numbers);
  page.add("command", "Python, hex_mesh_optimization " CGAL_HEX_MESH_OPTIMIZATION_VERSION);
  if (!why_it_stopped.empty())
    page.add("why_it_stopped", why_it_stopped);
  Json all = Json::parse(report);
  if (!all["status"].contains("deviation"))
    all["status"]["deviation"] = json(page.deviation());
  page.write(filename, title, std::move(all));
}

const char* name(HMO::Input_error::Element element)
{
  using Element = HMO::Input_error::Element;
  switch (element) {
  case Element::MESH:
    return "MESH";
  case Element::VERTEX:
    return "VERTEX";
  case Element::HEXAHEDRON:
    return "HEXAHEDRON";
  case Element::REFERENCE_VERTEX:
    return "REFERENCE_VERTEX";
  case Element::REFERENCE_FACE:
    return "REFERENCE_FACE";
  case Element::PARAMETER:
    return "PARAMETER";
  }
  return "";
}

// As the classes of the Python part.
void translate(std::exception_ptr thrown)
{
  const auto raise = [](const char* type, const auto&... arguments) {
    const py::object error = py::module_::import("hex_mesh_optimization._errors").attr(type)(arguments...);
    PyErr_SetObject(py::type::of(error).ptr(), error.ptr());
  };
  try {
    std::rethrow_exception(thrown);
  }
  catch (const HMO::Input_error& error) {
    raise("Input_error", error.what(), std::string(name(error.element())), error.element_index());
  }
  catch (const CGAL::IO::Hex_mesh_file_error& error) {
    raise("Hex_mesh_file_error", std::string(error.what()), error.file(), error.line());
  }
}

} // namespace

PYBIND11_MODULE(_engine, m)
{
  py::register_exception_translator(&translate);
  py::class_<Attachments>(m, "Attachments");
  m.attr("version") = CGAL_HEX_MESH_OPTIMIZATION_VERSION;
  m.def("optimize", &optimize);
  m.def("make", &make);
  m.def("quality", &quality);
  m.def("invalid", &invalid);
  m.def("statistics", &statistics);
  m.def("read", &read_mesh);
  m.def("read_surface", &read_triangles);
  m.def("write", &write_mesh);
  m.def("write_page", &write_page);
}
