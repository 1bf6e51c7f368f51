// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

// CGAL reads its list of named parameters from a header of this path. This one
// hands on CGAL's own list and appends the parameters of Hex_mesh_optimization,
// so that they chain with all others. No include guard: CGAL reads it repeatedly.

// Nobody else's warnings, although it is found by -I: the folder must come before CGAL's, and holds nothing else.
#if defined(__GNUC__)
#pragma GCC system_header
#endif

#include_next <CGAL/STL_Extension/internal/parameters_interface.h>

#include <CGAL/version.h>

// Told to the headers of the package, which cannot do without.
#ifndef CGAL_HEX_MESH_OPTIMIZATION_EXTENDS_NAMED_PARAMETERS
#define CGAL_HEX_MESH_OPTIMIZATION_EXTENDS_NAMED_PARAMETERS
#endif

// clang-format off
#ifndef CGAL_HEX_MESH_OPTIMIZATION_NO_NAMED_PARAMETERS
#if CGAL_VERSION_NR < 1060000000
CGAL_add_named_parameter(features_angle_bound_t, features_angle_bound, features_angle_bound)
#endif
CGAL_add_named_parameter(hex_optimization_method_t, hex_optimization_method, optimization_method)
CGAL_add_named_parameter(hexahedron_label_map_t, hexahedron_label_map, hexahedron_label_map)
CGAL_add_named_parameter(hex_internal_faces_t, hex_internal_faces, internal_faces)
CGAL_add_named_parameter(hex_interface_references_t, hex_interface_references, interface_references)
CGAL_add_named_parameter(hex_periodic_vertices_t, hex_periodic_vertices, periodic_vertices)
CGAL_add_named_parameter(hex_fixed_boundary_t, hex_fixed_boundary, fixed_boundary)
CGAL_add_named_parameter(hex_boundary_placement_t, hex_boundary_placement, boundary_placement)
CGAL_add_named_parameter(hex_target_quality_t, hex_target_quality, target_quality)
CGAL_add_named_parameter(hex_maximum_deviation_t, hex_maximum_deviation, maximum_deviation)
CGAL_add_named_parameter(hex_target_edge_lengths_t, hex_target_edge_lengths, target_edge_lengths)
CGAL_add_named_parameter(hex_target_edge_length_map_t, hex_target_edge_length_map, target_edge_length_map)
CGAL_add_named_parameter(hex_number_of_restarts_t, hex_number_of_restarts, number_of_restarts)
CGAL_add_named_parameter(hex_length_update_t, hex_length_update, edge_length_update)
CGAL_add_named_parameter(hex_surface_weight_t, hex_surface_weight, surface_weight)
CGAL_add_named_parameter(hex_feature_weight_t, hex_feature_weight, feature_weight)
CGAL_add_named_parameter(hex_regularization_weight_t, hex_regularization_weight, regularization_weight)
CGAL_add_named_parameter(hex_cone_angle_bound_t, hex_cone_angle_bound, cone_angle_bound)
CGAL_add_named_parameter(hex_maximize_minimum_quality_t, hex_maximize_minimum_quality, maximize_minimum_quality)
CGAL_add_named_parameter(hex_number_of_hexahedra_t, hex_number_of_hexahedra, number_of_hexahedra)
CGAL_add_named_parameter(hex_minimum_cells_across_t, hex_minimum_cells_across, minimum_cells_across)
CGAL_add_named_parameter(hex_face_label_map_t, hex_face_label_map, face_label_map)
CGAL_add_named_parameter(hex_layer_thickness_t, hex_layer_thickness, layer_thickness)
#endif
