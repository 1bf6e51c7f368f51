// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

// A part of the library CGAL::Hex_mesh_optimization_engine: the optimization, which is no template, compiled once for all
// programs.

#include <CGAL/Hex_mesh_optimization/internal/parts/run_in_parts_impl.h>
