// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_FOLDER_TEST_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_FOLDER_TEST_H

// A fixture for tests that write files: each runs in a folder of its own, which is gone after it.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace test {

class Folder_test : public testing::Test
{
protected:
  void SetUp() override
  {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    folder = std::filesystem::absolute(std::string(test.test_suite_name()) + "_" + test.name());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }

  void TearDown() override { std::filesystem::remove_all(folder); }

  std::string file(const std::string& name) const { return (folder / name).string(); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder / name); }

  std::string bytes(const std::string& name) const
  {
    std::ifstream in(file(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }

  std::filesystem::path folder;
};

} // namespace test

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_FOLDER_TEST_H
