// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiled without -I for the folder that extends CGAL's named parameters: CGAL's own are found first.

#include <CGAL/optimize_hex_mesh.h> // error: CGAL's own headers come before those of Hex_mesh_optimization
// error: must_come_first
