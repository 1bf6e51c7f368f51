// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The page of --report without a browser: how the data get into it. What it shows is tested by report/test_report.py.

#include "Report_page.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <sys/wait.h>

namespace {

std::string text(const std::string& filename)
{
  std::ifstream in(filename);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

std::string quoted(const std::vector<const char*>& words)
{
  return command_line(static_cast<int>(words.size()), words.data());
}

TEST(Report_page, is_refused_before_all_work_where_it_cannot_be_written)
{
  EXPECT_EQ(Report_page::reason_of_absence("<html>"), "");
  const int status = std::system(OPTIMIZE_HEX_MESH_WITHOUT_PAGE
                                 " no_such.mesh out.mesh --report page.html 2>report_page.err");
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 2); // and not that of a file that cannot be read
  EXPECT_NE(text("report_page.err").find("libjs-three"), std::string::npos);
  std::filesystem::remove("report_page.err");
}

TEST(Report_page, has_data_that_do_not_end_their_element)
{
  const Report_page page("<title>@title@</title><script>@data@</script>");
  page.write("report_page.html", "a < b & c", {{"input", "</script>@data@"}});
  const std::string written = text("report_page.html");
  EXPECT_EQ(written,
            "<title>a &lt; b &amp; c</title><script>{\"meshes\":[],\"report\":{\"input\":\"\\u003c/script>@data@\"}}"
            "</script>");
  std::filesystem::remove("report_page.html");
}

TEST(Report_page, is_not_there_in_parts)
{
  const Report_page page("@title@ @data@");
  EXPECT_THROW(page.write("no_such_folder/report_page.html", "", {}), std::exception);
}

TEST(Report_page, measures_from_the_first_mesh)
{
  Report_page page("@title@ @data@");
  Report_page::Points points{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
  const Report_page::Hexahedra cube{{{0, 1, 2, 3, 4, 5, 6, 7}}};
  page.add_mesh("before", "Before", points, cube);
  EXPECT_LT(page.deviation().maximum, 1e-15);
  points[6] = {2, 2, 1.25};
  page.add_mesh("after", "After", points, cube);
  EXPECT_DOUBLE_EQ(page.deviation().maximum, .25);
  EXPECT_DOUBLE_EQ(page.deviation().maximum_relative, .25 / 3);
}

TEST(command_line, is_what_a_shell_reads_as_the_same_words)
{
  EXPECT_EQ(quoted({"/usr/bin/program", "a.mesh", "--quality=.5"}), "program a.mesh --quality=.5");
  EXPECT_EQ(quoted({"program", "a b", "", "it's", "$x"}), "program 'a b' '' 'it'\\''s' '$x'");
}

} // namespace
