// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_PETSC_RANKS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_PETSC_RANKS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The processes of an MPI communicator, which exchange values by PETSc's star forests. Only programs that are
// linked with PETSc include it.

#include <CGAL/Hex_mesh_optimization/internal/parts/Ranks.h>

#include <petscsf.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Petsc_ranks : public Ranks
{
public:
  // PETSc must be initialized.
  explicit Petsc_ranks(MPI_Comm communicator) : communicator_(communicator)
  {
    MPI_Comm_rank(communicator, &rank_);
    MPI_Comm_size(communicator, &size_);
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  MPI_Comm communicator() const { return communicator_; }

  void fetch_bytes(Global_index n, const char* block, std::size_t size_of_item, const std::vector<Global_index>& items,
                   char* values) override
  {
    const Forest forest(*this, n, items, size_of_item);
    check(PetscSFBcastBegin(forest.sf, forest.type, block, values, MPI_REPLACE));
    check(PetscSFBcastEnd(forest.sf, forest.type, block, values, MPI_REPLACE));
  }

  void store_bytes(Global_index n, char* block, std::size_t size_of_item, const std::vector<Global_index>& items,
                   const char* values) override
  {
    const Forest forest(*this, n, items, size_of_item);
    check(PetscSFReduceBegin(forest.sf, forest.type, values, block, MPI_REPLACE));
    check(PetscSFReduceEnd(forest.sf, forest.type, values, block, MPI_REPLACE));
  }

  std::vector<Bytes> exchange(std::vector<Bytes> to_ranks) override
  {
    std::vector<std::int64_t> sent(size_), received(size_);
    for (int r = 0; r < size_; ++r)
      sent[r] = static_cast<std::int64_t>(to_ranks[r].size());
    check(MPI_Alltoall(sent.data(), 1, MPI_INT64_T, received.data(), 1, MPI_INT64_T, communicator_));
    std::vector<Bytes> result(size_);
    std::vector<MPI_Request> requests;
    // in pieces that a count of MPI can tell
    const auto in_pieces = [&](Bytes& bytes, const auto& pass) {
      for (std::size_t begin = 0; begin < bytes.size(); begin += most_bytes) {
        requests.emplace_back();
        const auto count = static_cast<int>((std::min)(most_bytes, bytes.size() - begin));
        check(pass(bytes.data() + begin, count, &requests.back()));
      }
    };
    for (int r = 0; r < size_; ++r)
      if (r != rank_) {
        result[r].resize(static_cast<std::size_t>(received[r]));
        in_pieces(result[r], [&](char* bytes, int count, MPI_Request* request) {
          return MPI_Irecv(bytes, count, MPI_BYTE, r, tag, communicator_, request);
        });
      }
    for (int r = 0; r < size_; ++r)
      if (r != rank_)
        in_pieces(to_ranks[r], [&](char* bytes, int count, MPI_Request* request) {
          return MPI_Isend(bytes, count, MPI_BYTE, r, tag, communicator_, request);
        });
    result[rank_] = std::move(to_ranks[rank_]);
    check(MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE));
    return result;
  }

  Bytes gather(Bytes own) override
  {
    const auto size = static_cast<std::int64_t>(own.size());
    std::vector<std::int64_t> sizes(size_);
    check(MPI_Allgather(&size, 1, MPI_INT64_T, sizes.data(), 1, MPI_INT64_T, communicator_));
    std::size_t sum = 0;
    for (std::int64_t s : sizes)
      sum += static_cast<std::size_t>(s);
    Bytes all(sum);
    std::size_t begin = 0;
    for (int r = 0; r < size_; ++r) {
      const auto end = begin + static_cast<std::size_t>(sizes[r]);
      if (r == rank_)
        std::copy(own.begin(), own.end(), all.begin() + static_cast<std::ptrdiff_t>(begin));
      for (; begin < end; begin = (std::min)(end, begin + most_bytes))
        check(MPI_Bcast(all.data() + begin, static_cast<int>((std::min)(most_bytes, end - begin)), MPI_BYTE, r,
                        communicator_));
    }
    return all;
  }

  void sum(std::vector<std::int64_t>& values) override
  {
    check(
      MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_INT64_T, MPI_SUM, communicator_));
  }

  void maximum(std::vector<double>& values) override
  {
    check(
      MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX, communicator_));
  }

  static void check(int error)
  {
    if (error != 0)
      throw std::runtime_error("MPI or PETSc has failed with error " + std::to_string(error));
  }

private:
  static constexpr std::size_t most_bytes = std::size_t(1) << 30;
  static constexpr int tag = 45;

  // The items are leaves, the blocks roots.
  struct Forest
  {
    Forest(const Petsc_ranks& ranks, Global_index n, const std::vector<Global_index>& items, std::size_t size_of_item)
    {
      if (items.size() > std::size_t((std::numeric_limits<PetscInt>::max)()))
        throw std::runtime_error("a rank has more vertices than PETSc counts: more ranks are needed");
      std::vector<PetscSFNode> roots(items.size());
      for (std::size_t i = 0; i < items.size(); ++i) {
        const int owner = ranks.owner(n, items[i]);
        roots[i] = {owner, static_cast<PetscInt>(items[i] - ranks.first_of_block(n, owner))};
      }
      check(PetscSFCreate(ranks.communicator_, &sf));
      check(PetscSFSetGraph(sf, static_cast<PetscInt>(ranks.last(n) - ranks.first(n)),
                            static_cast<PetscInt>(items.size()), nullptr, PETSC_COPY_VALUES, roots.data(),
                            PETSC_COPY_VALUES));
      check(MPI_Type_contiguous(static_cast<int>(size_of_item), MPI_BYTE, &type));
      check(MPI_Type_commit(&type));
    }
    Forest(const Forest&) = delete;
    Forest& operator=(const Forest&) = delete;
    ~Forest()
    {
      MPI_Type_free(&type);
      PetscSFDestroy(&sf);
    }

    PetscSF sf = nullptr;
    MPI_Datatype type = MPI_DATATYPE_NULL;
  };

  const MPI_Comm communicator_;
  int rank_ = 0, size_ = 1;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_PETSC_RANKS_H
