// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiles only if the installed list of named parameters is found before the
// one of CGAL, which it extends.

#include <CGAL/Named_function_parameters.h>

int main()
{
  const auto np = CGAL::parameters::target_quality(.5).number_of_iterations(10).fixed_boundary(true);
  (void)np;
  return 0;
}
