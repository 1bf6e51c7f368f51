// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#include "files.h"

#include <CGAL/Hex_mesh_optimization/repair_surface.h>

void repair(Surface& surface) { CGAL::Hex_mesh_optimization::repair_surface(surface); }

CGAL::Hex_mesh_optimization::Surface_repair repair(Soup& soup)
{
  return CGAL::Hex_mesh_optimization::repair_surface(soup.points, soup.triangles);
}
