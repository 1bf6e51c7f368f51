// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MPI_VTU_SLICES_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MPI_VTU_SLICES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A .vtu file of which each rank reads its slices, and writes its points, by MPI-IO.

#include <CGAL/Hex_mesh_optimization/IO/internal/Replaced_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Vtu_slices.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Petsc_ranks.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Mpi_vtu_slices : public Vtu_slices
{
public:
  Mpi_vtu_slices(const std::string& input, const std::string& output, const std::string& label_array,
                 Petsc_ranks& ranks)
    : Vtu_slices(input, output, label_array)
    , ranks_(ranks)
  {
    // each for itself: what one alone finds wrong closes the file on that one alone
    if (MPI_File_open(MPI_COMM_SELF, input.c_str(), MPI_MODE_RDONLY, MPI_INFO_NULL, &file_) != MPI_SUCCESS)
      fail("cannot open the file for reading");
  }

  ~Mpi_vtu_slices() override
  {
    if (file_ != MPI_FILE_NULL)
      MPI_File_close(&file_);
  }

  // Collective. The first rank copies the file, and renames it when all have written.
  void write_points(Global_index first, Global_index last, const std::array<double, 3>* points) override
  {
    MPI_File_close(&file_); // it may be written to
    std::unique_ptr<Replaced_file> file;
    Bytes name;
    if (ranks_.rank() == 0) {
      file = std::make_unique<Replaced_file>(output());
      copy_to(file->written());
      const std::string written = file->written().string();
      name.assign(written.begin(), written.end());
    }
    name = ranks_.gather(name);
    MPI_File out;
    const std::string written(name.begin(), name.end());
    if (MPI_File_open(ranks_.communicator(), written.c_str(), MPI_MODE_WRONLY, MPI_INFO_NULL, &out) != MPI_SUCCESS)
      throw CGAL::IO::Hex_mesh_file_error(output(), 0, "cannot open the file for writing");
    bool is_written = true;
    Vtu_slices::write_points(first, last, points, [&](std::uint64_t offset, const char* bytes, std::size_t size) {
      is_written = is_written && MPI_File_write_at(out, static_cast<MPI_Offset>(offset), bytes, static_cast<int>(size),
                                                   MPI_BYTE, MPI_STATUS_IGNORE) == MPI_SUCCESS;
    });
    is_written = MPI_File_close(&out) == MPI_SUCCESS && is_written;
    if (ranks_.any(!is_written))
      throw CGAL::IO::Hex_mesh_file_error(output(), 0, "cannot write the file");
    if (file)
      file->commit();
    ranks_.any(false); // nobody goes on before
  }

private:
  void read(std::uint64_t offset, char* bytes, std::size_t size) override
  {
    MPI_Status status;
    int count = 0;
    if (MPI_File_read_at(file_, static_cast<MPI_Offset>(offset), bytes, static_cast<int>(size), MPI_BYTE, &status) !=
          MPI_SUCCESS ||
        MPI_Get_count(&status, MPI_BYTE, &count) != MPI_SUCCESS || static_cast<std::size_t>(count) != size)
      fail("the appended data are incomplete");
  }

  Petsc_ranks& ranks_;
  MPI_File file_ = MPI_FILE_NULL;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MPI_VTU_SLICES_H
