// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The engine, compiled once for all of the programs of the project.

#include <CGAL/Hex_mesh_optimization/internal/interface/run_engine_impl.h>
