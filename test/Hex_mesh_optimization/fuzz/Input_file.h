// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_FUZZ_INPUT_FILE_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_FUZZ_INPUT_FILE_H

// What the fuzz targets share: the bytes of a run as a file for the readers, in the format
// that the argument --format=<extension> of the program chooses.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

namespace fuzz {

class Input_file
{
public:
  explicit Input_file(const std::string& extension)
    : folder_(std::filesystem::temp_directory_path() / ("hex_mesh_fuzz_" + std::to_string(std::random_device()())))
    , extension_(extension)
  {
    std::filesystem::create_directory(folder_);
  }

  ~Input_file()
  {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  Input_file(const Input_file&) = delete;
  Input_file& operator=(const Input_file&) = delete;

  // The name of a file with these bytes, which the next call overwrites.
  std::string operator()(const std::uint8_t* data, std::size_t size) const
  {
    std::ofstream(name("input"), std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return name("input");
  }

  // Another file of the same format.
  std::string name(const char* stem) const { return (folder_ / (std::string(stem) + "." + extension_)).string(); }

private:
  std::filesystem::path folder_;
  std::string extension_;
};

// --format=<extension> among the arguments of the program
inline std::string format(int argc, char** argv)
{
  for (int i = 1; i < argc; ++i)
    if (std::strncmp(argv[i], "--format=", 9) == 0)
      return argv[i] + 9;
  std::fprintf(stderr, "the argument --format=<extension> is missing\n");
  std::exit(2);
}

// The input is kept by libFuzzer.
inline void require(bool condition, const char* what)
{
  if (condition)
    return;
  std::fprintf(stderr, "violated: %s\n", what);
  std::abort();
}

} // namespace fuzz

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_FUZZ_INPUT_FILE_H
