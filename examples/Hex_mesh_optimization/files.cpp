// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files.h"

#include <CGAL/Hex_mesh_optimization/IO/hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/IO/surface.h>

void read(const std::string& filename, Points& points, Hexahedra& hexahedra)
{
  CGAL::IO::read_hex_mesh(filename, points, hexahedra);
}

void read(const std::string& filename, Points& points, Hexahedra& hexahedra,
          CGAL::IO::Hex_mesh_attachments& attachments)
{
  CGAL::IO::read_hex_mesh(filename, points, hexahedra, attachments);
}

void read(const std::string& filename, Surface& surface) { CGAL::IO::read_surface(filename, surface); }

void read(const std::string& filename, Soup& soup)
{
  CGAL::IO::read_triangle_soup(filename, soup.points, soup.triangles);
}

void write(const std::string& filename, const Points& points, const Hexahedra& hexahedra,
           const CGAL::IO::Hex_mesh_attachments& attachments)
{
  CGAL::IO::write_hex_mesh(filename, points, hexahedra, attachments);
}
