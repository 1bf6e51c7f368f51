// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_LICENSE_HEX_MESH_OPTIMIZATION_H
#define CGAL_LICENSE_HEX_MESH_OPTIMIZATION_H

// As the headers of this folder of CGAL: tells who asks, with CGAL_LICENSE_WARNING or CGAL_LICENSE_ERROR, whether the
// package is used under the terms of the GPLv3+.

#include <CGAL/config.h>
#include <CGAL/license.h>

#ifdef CGAL_HEX_MESH_OPTIMIZATION_COMMERCIAL_LICENSE

#if CGAL_HEX_MESH_OPTIMIZATION_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE

#if defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("Your commercial license for CGAL does not cover "
                    "this release of the Hexahedral Mesh Optimization package.")
#endif

#ifdef CGAL_LICENSE_ERROR
#error "Your commercial license for CGAL does not cover this release \
        of the Hexahedral Mesh Optimization package. \
        You get this error, as you defined CGAL_LICENSE_ERROR."
#endif

#endif // CGAL_HEX_MESH_OPTIMIZATION_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE

#else // no CGAL_HEX_MESH_OPTIMIZATION_COMMERCIAL_LICENSE

#if defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("\nThe macro CGAL_HEX_MESH_OPTIMIZATION_COMMERCIAL_LICENSE is not defined."
                    "\nYou use the CGAL Hexahedral Mesh Optimization package under "
                    "the terms of the GPLv3+.")
#endif

#ifdef CGAL_LICENSE_ERROR
#error "The macro CGAL_HEX_MESH_OPTIMIZATION_COMMERCIAL_LICENSE is not defined. \
        You use the CGAL Hexahedral Mesh Optimization package under the terms of \
        the GPLv3+. You get this error, as you defined CGAL_LICENSE_ERROR."
#endif

#endif // no CGAL_HEX_MESH_OPTIMIZATION_COMMERCIAL_LICENSE

#endif // CGAL_LICENSE_HEX_MESH_OPTIMIZATION_H
