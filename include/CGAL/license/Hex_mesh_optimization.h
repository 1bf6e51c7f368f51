// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_LICENSE_HEX_MESH_OPTIMIZATION_H
#define CGAL_LICENSE_HEX_MESH_OPTIMIZATION_H

// Says under which license the package is used, to those who ask as for CGAL's own packages: with the macro
// CGAL_LICENSE_WARNING or CGAL_LICENSE_ERROR. There is no other license than this one.

#include <CGAL/config.h>
#include <CGAL/license.h>

#ifdef CGAL_LICENSE_WARNING
CGAL_pragma_warning("You use the package Hexahedral Mesh Optimization under the terms of the GPLv3+.")
#endif

#ifdef CGAL_LICENSE_ERROR
#error "You use the package Hexahedral Mesh Optimization under the terms of the GPLv3+, and defined CGAL_LICENSE_ERROR."
#endif

#endif // CGAL_LICENSE_HEX_MESH_OPTIMIZATION_H
