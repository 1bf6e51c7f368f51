// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fuzz target of the readers of surfaces, --format=off, obj, stl, ply, mesh, vtk or vtu: whatever is in the file, it is
// refused by the documented exception, or gives a triangle mesh.

#include "Input_file.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hex_mesh_optimization/IO/surface.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <memory>

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

std::unique_ptr<fuzz::Input_file> input_file;

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
  input_file = std::make_unique<fuzz::Input_file>(fuzz::format(*argc, *argv));
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  CGAL::Surface_mesh<Point> surface;
  surface.add_vertex();
  try {
    CGAL::IO::read_surface((*input_file)(data, size), surface);
  }
  catch (const CGAL::IO::Hex_mesh_file_error&) {
    fuzz::require(num_vertices(surface) == 1 && num_faces(surface) == 0, "what is refused changes nothing");
    return 0;
  }
  fuzz::require(num_faces(surface) > 0, "there are faces");
  fuzz::require(CGAL::is_valid_polygon_mesh(surface), "the faces are connected consistently");
  fuzz::require(CGAL::is_triangle_mesh(surface), "all faces are triangles");
  for (const auto v : vertices(surface))
    for (int d = 0; d < 3; ++d)
      fuzz::require(std::isfinite(surface.point(v)[d]), "all coordinates are finite");
  return 0;
}
