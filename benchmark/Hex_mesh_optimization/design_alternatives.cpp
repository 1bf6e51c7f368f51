// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The design alternatives of Livesu et al. 2015, on the meshes whose files are given: edge-cone rectification as it is,
// without the regularization, and with nothing but the regularization. Prints, as CSV, how many hexahedra are inverted
// before and after the first start, which is from the given places if no more than half of the hexahedra are inverted, and
// how good the result is after all starts.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hex_mesh_optimization/IO/hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/index_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/run_engine.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <vector>

namespace HMO = CGAL::Hex_mesh_optimization;

struct Alternative
{
  const char* name;
  double cone_weight, regularization_weight;
};

const Alternative alternatives[] = {{"as it is", 1, 1},
                                    {"without regularization", 1, 0},
                                    {"regularization alone", 0, 1}};

int main(int argc, char** argv)
{
  std::cout << "file,alternative,hexahedra,inverted_before,inverted_after_first_start,inverted_after,minimum,average\n";
  for (int i = 1; i < argc; ++i) {
    std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
    std::vector<std::array<std::size_t, 8>> hexahedra;
    CGAL::IO::read_hex_mesh(argv[i], points, hexahedra);
    for (const Alternative& alternative : alternatives) {
      HMO::internal::Chosen_parameters parameters;
      parameters.method = HMO::Method::RECTIFICATION;
      parameters.rectification.cone_weight = alternative.cone_weight;
      parameters.rectification.regularization_weight = alternative.regularization_weight;
      std::size_t starts = 0, inverted = hexahedra.size();
      parameters.on_iteration = [&](const HMO::Iteration& i) {
        if (i.iteration == 0)
          ++starts;
        if (starts == 1)
          inverted = (std::min)(inverted, i.number_of_inverted);
        return true;
      };
      HMO::internal::Positions positions = HMO::internal::engine_positions(points);
      const HMO::Status status = HMO::internal::run_engine(positions, HMO::internal::engine_hexahedra(hexahedra),
                                                           HMO::internal::Regions(), nullptr,
                                                           std::vector<char>(points.size(), false), parameters);
      std::cout << argv[i] << ',' << alternative.name << ',' << hexahedra.size() << ','
                << status.before.number_of_inverted << ',' << inverted << ',' << status.after.number_of_inverted << ','
                << status.after.minimum << ',' << status.after.average << std::endl;
    }
  }
}
