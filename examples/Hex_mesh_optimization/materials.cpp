// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A bar of two materials: the interface stays where it is, its vertices slide in it.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/optimize_hex_mesh.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <vector>

int main()
{
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  CGAL::Hex_mesh_optimization::make_bent_bar(points, hexahedra, 12, 4);

  // The first half is of material 1, the second of material 2
  std::vector<int> material(hexahedra.size());
  std::vector<std::array<bool, 3>> is_in(points.size(), {{false, false, false}});
  for (std::size_t h = 0; h < hexahedra.size(); ++h) {
    material[h] = h < hexahedra.size() / 2 ? 1 : 2;
    for (std::size_t v : hexahedra[h])
      is_in[v][material[h]] = true;
  }

  // All of the interior is tangled but for the vertices between the materials
  const auto intact = points;
  CGAL::Hex_mesh_optimization::scramble_interior(points, hexahedra, 1); // 1: seed
  for (std::size_t v = 0; v < points.size(); ++v)
    if (is_in[v][1] && is_in[v][2])
      points[v] = intact[v];

  const auto status = CGAL::optimize_hex_mesh(points, hexahedra,
                                              CGAL::parameters::hexahedron_label_map(
                                                CGAL::make_property_map(material)));

  for (const auto& region : status.regions)
    std::cout << "material " << region.label << ": volume " << region.after << '\n';
  for (const auto& interface : status.interfaces)
    std::cout << interface.number_of_faces << " faces between them, at most " << interface.deviation.maximum
              << " from where they were\n";
  return status.valid_mesh() && status.interfaces.size() == 1 ? 0 : 1;
}
