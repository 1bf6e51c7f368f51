// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_SEPARATE_COMPILATION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_SEPARATE_COMPILATION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The functions behind which a caller's program need not look are no templates. They are inline, and compiled with each
// program, unless it is linked with the library CGAL::Hex_mesh_optimization_engine, where they are once and for all.

#ifdef CGAL_HEX_MESH_OPTIMIZATION_SEPARATE_ENGINE
#define CGAL_HEX_MESH_OPTIMIZATION_INLINE
#else
#define CGAL_HEX_MESH_OPTIMIZATION_INLINE inline
#endif

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_SEPARATE_COMPILATION_H
