// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

// A part of the library CGAL::Hex_mesh_optimization_engine: meshes of surfaces, compiled once for all programs.

#include <CGAL/Hex_mesh_optimization/internal/meshing/mesh_surface_impl.h>
