// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_BLOCK_ARRAY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_BLOCK_ARRAY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// An array of plain values in memory, or in a file without a name that is mapped into it: what of that is in use
// need not fit.

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#define CGAL_HEX_MESH_OPTIMIZATION_CAN_MAP_FILES
#include <cstdlib>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace CGAL::Hex_mesh_optimization::internal {

// folder: of the file; empty: the array is in memory. All values are 0 at first.
template <class T>
class Block_array
{
public:
  Block_array() = default;

  Block_array(std::size_t size, const std::string& folder) : size_(size)
  {
#ifdef CGAL_HEX_MESH_OPTIMIZATION_CAN_MAP_FILES
    if (!folder.empty() && size > 0) {
      std::string name = folder + "/hex_mesh_parts_XXXXXX";
      const int file = mkstemp(name.data());
      if (file >= 0)
        unlink(name.c_str());
      void* mapped = MAP_FAILED;
      if (file >= 0 && ftruncate(file, static_cast<off_t>(size * sizeof(T))) == 0)
        mapped = mmap(nullptr, size * sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
      if (file >= 0)
        close(file);
      if (mapped == MAP_FAILED)
        throw std::runtime_error("there is no room for a temporary file in " + folder);
      data_ = static_cast<T*>(mapped);
      is_mapped_ = true;
      return;
    }
#endif
    values_.resize(size);
    data_ = values_.data();
  }

  Block_array(Block_array&& other) noexcept { *this = std::move(other); }
  Block_array& operator=(Block_array&& other) noexcept
  {
    std::swap(values_, other.values_);
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(is_mapped_, other.is_mapped_);
    return *this;
  }

  ~Block_array()
  {
#ifdef CGAL_HEX_MESH_OPTIMIZATION_CAN_MAP_FILES
    if (is_mapped_)
      munmap(data_, size_ * sizeof(T));
#endif
  }

  std::size_t size() const { return size_; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }

  // What is mapped need not stay in memory.
  void release() const
  {
#ifdef CGAL_HEX_MESH_OPTIMIZATION_CAN_MAP_FILES
    if (is_mapped_)
      madvise(data_, size_ * sizeof(T), MADV_DONTNEED);
#endif
  }

private:
  std::vector<T> values_;
  T* data_ = nullptr;
  std::size_t size_ = 0;
  bool is_mapped_ = false;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_BLOCK_ARRAY_H
