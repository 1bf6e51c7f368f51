// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_RANKS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_RANKS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The processes that share a mesh, and what they tell each other. This one is alone; what is derived from it
// has others.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

using Global_index = std::int64_t;
using Bytes = std::vector<char>;

// All functions but rank() and size() are collective. Arrays are spread over the ranks in blocks: first_of_block().
class Ranks
{
public:
  virtual ~Ranks() = default;

  virtual int rank() const { return 0; }
  virtual int size() const { return 1; }

  // The values of any items of an array of n items, of which each rank has its block.
  virtual void fetch_bytes(Global_index, const char* block, std::size_t size_of_item,
                           const std::vector<Global_index>& items, char* values)
  {
    for (std::size_t i = 0; i < items.size(); ++i)
      std::memcpy(values + i * size_of_item, block + items[i] * size_of_item, size_of_item);
  }

  // The other way: no item is given by two ranks.
  virtual void store_bytes(Global_index, char* block, std::size_t size_of_item, const std::vector<Global_index>& items,
                           const char* values)
  {
    for (std::size_t i = 0; i < items.size(); ++i)
      std::memcpy(block + items[i] * size_of_item, values + i * size_of_item, size_of_item);
  }

  // From each rank what it has for this one, in the order of the ranks.
  virtual std::vector<Bytes> exchange(std::vector<Bytes> to_ranks) { return to_ranks; }

  // Of all ranks, one after the other.
  virtual Bytes gather(Bytes own) { return own; }

  // Over all ranks, in place.
  virtual void sum(std::vector<std::int64_t>&) {}
  virtual void maximum(std::vector<double>&) {}

  Global_index first_of_block(Global_index n, int of_rank) const
  {
    // the product of both may not be counted
    return n / size() * of_rank + n % size() * of_rank / size();
  }
  Global_index first(Global_index n) const { return first_of_block(n, rank()); }
  Global_index last(Global_index n) const { return first_of_block(n, rank() + 1); }

  int owner(Global_index n, Global_index item) const
  {
    int low = 0, high = size();
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      (first_of_block(n, middle) <= item ? low : high) = middle;
    }
    return low;
  }

  template <class T, class Block>
  std::vector<T> fetch(Global_index n, const Block& block, const std::vector<Global_index>& items)
  {
    std::vector<T> values(items.size());
    fetch_bytes(n, reinterpret_cast<const char*>(block.data()), sizeof(T), items,
                reinterpret_cast<char*>(values.data()));
    return values;
  }

  template <class T, class Block>
  void store(Global_index n, Block& block, const std::vector<Global_index>& items, const std::vector<T>& values)
  {
    store_bytes(n, reinterpret_cast<char*>(block.data()), sizeof(T), items,
                reinterpret_cast<const char*>(values.data()));
  }

  template <class T>
  std::vector<std::vector<T>> exchange_values(const std::vector<std::vector<T>>& to_ranks)
  {
    std::vector<Bytes> bytes;
    for (const std::vector<T>& values : to_ranks)
      bytes.push_back(as_bytes(values));
    std::vector<std::vector<T>> result;
    for (const Bytes& b : exchange(std::move(bytes)))
      result.push_back(as_values<T>(b));
    return result;
  }

  template <class T>
  std::vector<T> gather_values(const std::vector<T>& own)
  {
    return as_values<T>(gather(as_bytes(own)));
  }

  bool any(bool own)
  {
    std::vector<std::int64_t> count(1, own);
    sum(count);
    return count[0] > 0;
  }

  double maximum_of(double own)
  {
    std::vector<double> values(1, own);
    maximum(values);
    return values[0];
  }

private:
  template <class T>
  static Bytes as_bytes(const std::vector<T>& values)
  {
    const char* begin = reinterpret_cast<const char*>(values.data());
    return Bytes(begin, begin + values.size() * sizeof(T));
  }

  template <class T>
  static std::vector<T> as_values(const Bytes& bytes)
  {
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty())
      std::memcpy(static_cast<void*>(values.data()), bytes.data(), values.size() * sizeof(T));
    return values;
  }
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_RANKS_H
