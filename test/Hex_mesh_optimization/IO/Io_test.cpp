// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Io_test.h"

#include <CGAL/Hex_mesh_optimization/IO/hex_mesh.h>

void read_hex_mesh(const std::string& filename, Points& points, Cells& hexahedra, Mesh_data& mesh_data)
{
  CGAL::IO::read_hex_mesh(filename, points, hexahedra, mesh_data);
}

void read_hex_mesh(const std::string& filename, Points& points, Cells& hexahedra)
{
  CGAL::IO::read_hex_mesh(filename, points, hexahedra);
}

void write_hex_mesh(const std::string& filename, const Points& points, const Cells& hexahedra,
                    const Mesh_data& mesh_data)
{
  CGAL::IO::write_hex_mesh(filename, points, hexahedra, mesh_data);
}

void write_hex_mesh(const std::string& filename, const Points& points, const Cells& hexahedra,
                    const Mesh_data& mesh_data, bool is_binary)
{
  CGAL::IO::write_hex_mesh(filename, points, hexahedra, mesh_data, CGAL::parameters::use_binary_mode(is_binary));
}
