// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_EMBEDDED_REPORT_PAGE_H
#define CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_EMBEDDED_REPORT_PAGE_H

#include <string>

// The page without data, which is compiled into the program; empty if three.js was not found.
std::string embedded_report_page();

#endif // CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_EMBEDDED_REPORT_PAGE_H
