// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs a fuzz target without libFuzzer on the files of a folder, and on every prefix of them in steps.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv)
try {
  LLVMFuzzerInitialize(&argc, &argv);
  std::size_t files = 0, runs = 0;
  for (int i = 1; i < argc; ++i) {
    if (argv[i][0] == '-')
      continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(argv[i])) {
      if (!entry.is_regular_file())
        continue;
      std::ifstream in(entry.path(), std::ios::binary);
      const std::vector<char> bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
      const std::size_t step = bytes.size() / 100 + 1;
      for (std::size_t size = bytes.size();; size -= step) {
        std::fprintf(stderr, "%s, %zu bytes\r", entry.path().c_str(), size);
        const std::vector<char> prefix(bytes.begin(),
                                       bytes.begin() + static_cast<std::ptrdiff_t>(size)); // no byte more can be read
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(prefix.data()), size);
        ++runs;
        if (size < step)
          break;
      }
      ++files;
    }
  }
  std::printf("\n%zu files, %zu runs\n", files, runs);
  return files == 0;
}
catch (const std::exception& error) {
  std::fprintf(stderr, "\n%s\n", error.what());
  return 1;
}
