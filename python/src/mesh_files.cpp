// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_files.h"

#include "arrays.h"
#include "files.h"

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/unsupported_data.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_mesh_to_reference.h>
#include <CGAL/Hex_mesh_optimization/validity.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace {

// Of the faces between hexahedra that have a label in the file, as the program optimize_hex_mesh keeps them.
std::vector<std::array<std::int64_t, 4>> internal_faces(const CGAL::IO::Hex_mesh_data& mesh_data)
{
  std::vector<std::array<std::int64_t, 4>> result;
  for (const auto& q : mesh_data.labelled_quadrilaterals())
    if (q.label != 0) {
      result.emplace_back();
      std::copy(q.vertices.begin(), q.vertices.end(), result.back().begin());
    }
  return result;
}

// The named parameters that the file of a solver speaks of, beside labels.
py::dict parameters(const CGAL::IO::Hex_mesh_file& file)
{
  py::dict result;
  if (!file.held_points.empty())
    result["vertex_is_constrained_map"] = as_array(file.held_points);
  if (!file.periodic_pairs.empty()) {
    std::vector<std::array<std::size_t, 2>> pairs;
    Points translations;
    for (const auto& [first, second, t] : file.periodic_pairs) {
      pairs.push_back({first, second});
      translations.emplace_back(t[0], t[1], t[2]);
    }
    result["periodic_vertices"] = py::make_tuple(as_array(std::move(pairs)), as_array(std::move(translations)));
  }
  if (file.has_exact_surfaces)
    result["boundary_placement"] = "on_surface";
  return result;
}

// The vertices of each set of the file of a solver, by its name.
py::dict sets(const CGAL::IO::Hex_mesh_file& file)
{
  py::dict result;
  for (const CGAL::IO::Hex_mesh_set& set : file.sets)
    result[py::str(set.name)] = as_array(set.vertices);
  return result;
}

void read_any(File_content& content, Points& points, Hexahedra& hexahedra)
{
  content.solver_file = read_solver_file(content.filename);
  if (!content.solver_file)
    return read(content.filename, points, hexahedra, content.mesh_data);
  for (const auto& p : content.solver_file->points)
    points.emplace_back(p[0], p[1], p[2]);
  hexahedra = content.solver_file->hexahedra;
  content.mesh_data = mesh_data_of(*content.solver_file);
}

// A copy may have no room for all digits.
std::vector<std::string> write_copy(const CGAL::IO::Hex_mesh_file& file, const std::string& filename,
                                    const Points& points)
{
  const auto number_of_invalid = [&](const Points& p) {
    std::vector<std::size_t> invalid;
    CGAL::Hex_mesh_optimization::invalid_hexahedra(p, file.hexahedra, std::back_inserter(invalid));
    return invalid.size();
  };
  const std::size_t before = number_of_invalid(points), after = number_of_invalid(copy(file, filename, points));
  if (after <= before)
    return {};
  return {std::to_string(after - before) +
          " hexahedra are invalid because the fields of the file have no room for more digits"};
}

} // namespace

py::dict read_mesh(const std::string& filename, const std::string& label_array)
{
  Points points;
  Hexahedra hexahedra;
  File_content content;
  content.filename = filename;
  CGAL::IO::Hex_mesh_data& mesh_data = content.mesh_data;
  {
    const py::gil_scoped_release unlocked;
    read_any(content, points, hexahedra);
  }
  if (!label_array.empty() && !mesh_data.use_label_array(label_array))
    throw CGAL::IO::Hex_mesh_file_error(filename, 0,
                                        "there is no array \"" + label_array +
                                          "\" with one integral number for each cell");
  py::dict result;
  result["points"] = as_array(std::move(points));
  result["hexahedra"] = as_array(std::move(hexahedra));
  result["labels"] = py::none();
  if (!mesh_data.hexahedron_labels.empty())
    result["labels"] = as_array(std::vector<std::int64_t>(mesh_data.hexahedron_labels));
  result["internal_faces"] = as_array(internal_faces(mesh_data));
  const CGAL::IO::Hex_mesh_file none, &file = content.solver_file ? *content.solver_file : none;
  result["parameters"] = parameters(file);
  result["sets"] = sets(file);
  result["notes"] = content.solver_file ? file.notes : mesh_data.skipped;
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
  of_arrays.mesh_data.hexahedron_labels = labels;
  const File_content& written = content == nullptr ? of_arrays : *content;
  const Points all_points = points_of(points);
  const Hexahedra all_hexahedra = hexahedra_of(hexahedra);
  const py::gil_scoped_release unlocked;
  if (written.solver_file && is_copy(written.filename, filename))
    return write_copy(*written.solver_file, filename, all_points);
  write(filename, all_points, all_hexahedra, written.mesh_data);
  std::vector<std::string> lost = CGAL::IO::unsupported_data(filename, written.mesh_data);
  if (written.solver_file) // what is left out of other files is left out when they are read
    lost.insert(lost.end(), written.mesh_data.skipped.begin(), written.mesh_data.skipped.end());
  for (std::string& line : lost)
    line = "not in the file: " + line;
  return lost;
}
