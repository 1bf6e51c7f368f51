// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The engine, which all of the tests link.

#include <CGAL/Hex_mesh_optimization/internal/run_engine_impl.h>
