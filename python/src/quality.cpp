// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "quality.h"

#include "arrays.h"
#include "status.h"

#include <CGAL/Hex_mesh_optimization/quality.h>
#include <CGAL/Hex_mesh_optimization/validity.h>

#include <iterator>

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

} // namespace

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
