// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The program optimize_hex_mesh_mpi as a cluster sees it, with more processes than processors.

#include <CGAL/Hex_mesh_optimization/IO/vtu.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/quality.h>

#include <CGAL/Simple_cartesian.h>

#include "Folder_test.h"
#include "raw_vtu.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <sys/wait.h>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace fs = std::filesystem;
using Point = CGAL::Simple_cartesian<double>::Point_3;

using Mesh = test::Labelled_mesh;
using test::tangled_ball;

class Mpi_program : public test::Folder_test
{
protected:
  // The exit code of a shell command, in which $RANKS n arguments starts the program.
  int shell(const std::string& command) const
  {
    const std::string line =
      "cd '" + folder.string() +
      "' && export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1"
      " PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe OMPI_MCA_hwloc_base_binding_policy=none"
      " OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_btl_base_warn_component_unused=0 OMPI_MCA_plm_rsh_agent=false"
      " OMPI_MCA_btl_vader_single_copy_mechanism=none OMP_NUM_THREADS=1 TMPDIR=/tmp"
      " && ranks() { n=$1; shift; exec '" MPIRUN "' -n $n '" OPTIMIZE_HEX_MESH_MPI "' \"$@\"; }"
      // until the first of the ranks that the process has started has worked for a second, however busy the machine is
      " && wait_for_work() { for i in $(seq 600); do r=$(pgrep -P $1 | head -n 1);"
      " if [ \"$r\" ] && [ \"$(ps -o cputimes= -p $r)\" -ge 1 ]; then return; fi; sleep .1; done; }"
      " && { " +
      command + "; } >stdout 2>stderr";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  int run(int number_of_ranks, const std::string& arguments) const
  {
    return shell("(ranks " + std::to_string(number_of_ranks) + " " + arguments + ")");
  }

  // name: less .vtu
  void write(const std::string& name, const Mesh& mesh) const
  {
    test::write_raw_vtu(file(name + ".vtu"), mesh.points, mesh.hexahedra, mesh.labels);
  }

  HMO::Quality_statistics statistics(const std::string& name) const
  {
    Mesh mesh;
    CGAL::IO::read_vtu_hex_mesh(file(name), mesh.points, mesh.hexahedra);
    return HMO::quality_statistics(mesh.points, mesh.hexahedra);
  }
};

// The upper half has another label.
Mesh tangled_block_of_two_materials(std::size_t n)
{
  Mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{n, n, n}});
  for (const auto& h : mesh.hexahedra)
    mesh.labels.push_back(mesh.points[h[0]].z() < .499 ? 1 : 2);
  const Point center(.5, .5, .5);
  for (Point& p : mesh.points)
    if (p == center)
      p = Point(.77, .71, .5);
  return mesh;
}

TEST_F(Mpi_program, Any_number_of_ranks_writes_the_same_bytes_as_parts_one_after_the_other)
{
  write("ball", tangled_ball(3));
  write("block", tangled_block_of_two_materials(8));
  for (const std::string name : {"ball", "block"}) {
    const std::string rest = name + ".vtu out.vtu --parts 7 --quiet";
    ASSERT_EQ(shell("'" OPTIMIZE_HEX_MESH "' " + rest), 0) << bytes("stderr");
    const std::string expected = bytes("out.vtu");
    EXPECT_EQ(statistics("out.vtu").number_of_invalid, 0u);
    for (int ranks : {1, 2, 4, 7}) {
      fs::remove(folder / "out.vtu");
      ASSERT_EQ(run(ranks, rest), 0) << bytes("stderr");
      EXPECT_TRUE(bytes("out.vtu") == expected) << name << " with " << ranks << " ranks";
    }
  }
}

TEST_F(Mpi_program, Its_report_is_that_of_the_whole_mesh)
{
  write("in", tangled_block_of_two_materials(8));
  ASSERT_EQ(run(4, "in.vtu out.vtu --json out.json --max-deviation .02"), 0) << bytes("stderr");
  const nlohmann::json report = nlohmann::json::parse(bytes("out.json")), &status = report["status"];
  EXPECT_EQ(report["options"]["ranks"], 4);
  EXPECT_EQ(status["after"]["minimum"], statistics("out.vtu").minimum);
  EXPECT_GT(status["before"]["number_of_inverted"], 0);
  EXPECT_EQ(status["after"]["number_of_invalid"], 0);
  EXPECT_LE(status["deviation"]["certified"], .02);
  EXPECT_EQ(status["interfaces"].size(), 1u);
  EXPECT_EQ(status["interfaces"][0]["number_of_faces"], 64);
  EXPECT_NE(bytes("stdout").find("The mesh is valid."), std::string::npos) << bytes("stdout");
}

TEST_F(Mpi_program, What_one_rank_finds_wrong_ends_all)
{
  Mesh mesh = tangled_ball(2);
  mesh.hexahedra.back()[3] = mesh.points.size() + 5;
  write("in", mesh);
  EXPECT_EQ(run(3, "in.vtu out.vtu"), 3) << bytes("stderr");
  EXPECT_NE(bytes("stderr").find("refers to a vertex that does not exist"), std::string::npos) << bytes("stderr");
  EXPECT_FALSE(exists("out.vtu"));
  EXPECT_EQ(run(2, "missing.vtu out.vtu"), 3);
  EXPECT_EQ(run(2, "in.vtu"), 2);
}

TEST_F(Mpi_program, A_rank_that_is_killed_leaves_nothing_half_done)
{
  write("in", tangled_ball(28));
  const std::string before = bytes("in.vtu");
  EXPECT_NE(shell("(ranks 2 in.vtu in.vtu) & wait_for_work $!; kill -9 $r; wait $!"), 0);
  EXPECT_TRUE(bytes("in.vtu") == before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 3) << "in.vtu, stdout, stderr";
}

TEST_F(Mpi_program, When_it_is_told_to_end_it_writes_the_best_mesh_so_far)
{
  write("in", tangled_ball(28));
  const std::size_t inverted = statistics("in.vtu").number_of_inverted;
  const int code = shell("(ranks 2 in.vtu out.vtu) & wait_for_work $!; kill -TERM $(pgrep -P $!); wait $!");
  EXPECT_TRUE(code == 0 || code == 1) << code << bytes("stderr");
  ASSERT_TRUE(exists("out.vtu")) << bytes("stderr");
  EXPECT_NE(bytes("stdout").find("interrupted"), std::string::npos) << bytes("stdout");
  EXPECT_LE(statistics("out.vtu").number_of_inverted, inverted);
}

TEST_F(Mpi_program, When_time_is_over_it_writes_the_best_mesh_so_far)
{
  write("in", tangled_ball(14));
  const int code = run(2, "in.vtu out.vtu --time-limit .5");
  EXPECT_TRUE(code == 0 || code == 1) << bytes("stderr");
  EXPECT_NE(bytes("stdout").find("time limit reached"), std::string::npos) << bytes("stdout");
  EXPECT_TRUE(exists("out.vtu"));
}

} // namespace
