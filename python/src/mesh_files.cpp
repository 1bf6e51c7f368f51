// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_files.h"

#include "arrays.h"
#include "files.h"

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/lost_attachments.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_mesh_to_reference.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <utility>

namespace {

// Of the faces between hexahedra that have a label in the file, as the program optimize_hex_mesh keeps them.
std::vector<std::array<std::int64_t, 4>> internal_faces(const CGAL::IO::Hex_mesh_attachments& attachments)
{
  std::vector<std::array<std::int64_t, 4>> result;
  for (const auto& q : attachments.labelled_quadrilaterals())
    if (q.label != 0) {
      result.emplace_back();
      std::copy(q.vertices.begin(), q.vertices.end(), result.back().begin());
    }
  return result;
}

} // namespace

py::dict read_mesh(const std::string& filename, const std::string& label_array)
{
  Points points;
  Hexahedra hexahedra;
  File_content content;
  CGAL::IO::Hex_mesh_attachments& attachments = content.attachments;
  {
    const py::gil_scoped_release unlocked;
    read(filename, points, hexahedra, attachments);
  }
  if (!label_array.empty() && !attachments.use_label_array(label_array))
    throw CGAL::IO::Hex_mesh_file_error(filename, 0,
                                        "there is no array \"" + label_array +
                                          "\" with one integral number for each cell");
  py::dict result;
  result["points"] = as_array(std::move(points));
  result["hexahedra"] = as_array(std::move(hexahedra));
  result["labels"] = py::none();
  if (!attachments.hexahedron_labels.empty())
    result["labels"] = as_array(std::vector<std::int64_t>(attachments.hexahedron_labels));
  result["internal_faces"] = as_array(internal_faces(attachments));
  result["left_out"] = attachments.left_out;
  result["content"] = std::move(content);
  return result;
}

py::tuple read_triangles(const std::string& filename)
{
  CGAL::Hex_mesh_optimization::internal::Reference_input reference;
  {
    const py::gil_scoped_release unlocked;
    Surface surface;
    read(filename, surface);
    reference = CGAL::Hex_mesh_optimization::internal::triangle_mesh_to_reference(surface,
                                                                                  CGAL::parameters::default_values());
  }
  Points points;
  for (const auto& p : reference.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::array<std::int64_t, 3>> triangles;
  for (const auto& t : reference.triangles)
    triangles.push_back({t[0], t[1], t[2]});
  return py::make_tuple(as_array(std::move(points)), as_array(std::move(triangles)));
}

std::vector<std::string> write_mesh(const std::string& filename, const py::array& points, const py::array& hexahedra,
                                    const File_content* content, const std::vector<std::int64_t>& labels)
{
  require_vertices(Table(hexahedra), Table(points).rows());
  File_content of_arrays;
  of_arrays.attachments.hexahedron_labels = labels;
  const File_content& written = content == nullptr ? of_arrays : *content;
  const Points all_points = points_of(points);
  const Hexahedra all_hexahedra = hexahedra_of(hexahedra);
  const py::gil_scoped_release unlocked;
  write(filename, all_points, all_hexahedra, written.attachments);
  return CGAL::IO::lost_attachments(filename, written.attachments);
}
