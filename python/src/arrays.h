// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_PYTHON_ARRAYS_H
#define CGAL_HEX_MESH_OPTIMIZATION_PYTHON_ARRAYS_H

// Arrays of numpy as the ranges that the package takes, where they are; and what the package makes as arrays, without a
// copy. The Python part of the module has checked shapes and types.

#include <CGAL/Simple_cartesian.h>

#include <boost/range/adaptor/transformed.hpp>
#include <boost/range/irange.hpp>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
static_assert(sizeof(Kernel::Point_3) == 3 * sizeof(double), "an array of points is an array of numbers");

// A table of numbers in the memory of an array, whatever its strides. It may be read without the lock of the
// interpreter, as long as the array lives.
class Table
{
public:
  explicit Table(const py::array& array)
    : data_(static_cast<const char*>(array.data()))
    , rows_(static_cast<std::size_t>(array.shape(0)))
    , row_stride_(array.strides(0))
    , column_stride_(array.ndim() > 1 ? array.strides(1) : 0)
    , kind_(array.dtype().kind())
    , size_(static_cast<int>(array.itemsize()))
  {}

  std::size_t rows() const { return rows_; }

  double number(std::size_t row, std::size_t column) const { return at<double>(row, column); }

  // Of any integer type; what does not fit becomes negative.
  std::int64_t index(std::size_t row, std::size_t column) const
  {
    const bool is_signed = kind_ == 'i';
    switch (size_) {
    case 1:
      return is_signed ? at<std::int8_t>(row, column) : std::int64_t(at<std::uint8_t>(row, column));
    case 2:
      return is_signed ? at<std::int16_t>(row, column) : std::int64_t(at<std::uint16_t>(row, column));
    case 4:
      return is_signed ? at<std::int32_t>(row, column) : std::int64_t(at<std::uint32_t>(row, column));
    default:
      return at<std::int64_t>(row, column);
    }
  }

private:
  template <class Number>
  Number at(std::size_t row, std::size_t column) const
  {
    Number x;
    std::memcpy(&x, data_ + std::ptrdiff_t(row) * row_stride_ + std::ptrdiff_t(column) * column_stride_, sizeof(x));
    return x;
  }

  const char* data_;
  std::size_t rows_;
  std::ptrdiff_t row_stride_, column_stride_;
  char kind_;
  int size_;
};

struct Point_of_row
{
  Table table;
  Kernel::Point_3 operator()(std::size_t row) const
  {
    return {table.number(row, 0), table.number(row, 1), table.number(row, 2)};
  }
};

template <std::size_t n>
struct Cell_of_row
{
  Table table;
  std::array<std::int64_t, n> operator()(std::size_t row) const
  {
    std::array<std::int64_t, n> result;
    for (std::size_t k = 0; k < n; ++k)
      result[k] = table.index(row, k);
    return result;
  }
};

inline auto point_range(const Table& table)
{
  return boost::irange<std::size_t>(0, table.rows()) | boost::adaptors::transformed(Point_of_row{table});
}

template <std::size_t n>
auto cell_range(const Table& table)
{
  return boost::irange<std::size_t>(0, table.rows()) | boost::adaptors::transformed(Cell_of_row<n>{table});
}

// Throws what Python gets as an Input_error where it would read beyond the points; the optimization does that itself.
void require_vertices(const Table& hexahedra, std::size_t number_of_points);

// Copies, for what takes nothing else.
Points points_of(const py::array& points);
std::vector<std::array<std::size_t, 8>> hexahedra_of(const py::array& hexahedra);

template <class Values>
py::capsule owner_of(Values&& values, const void*& data)
{
  using Vector = std::decay_t<Values>;
  auto* kept = new Vector(std::forward<Values>(values));
  data = kept->data();
  return py::capsule(kept, [](void* pointer) { delete static_cast<Vector*>(pointer); });
}

inline py::array as_array(Points&& points)
{
  const auto size = static_cast<py::ssize_t>(points.size());
  const void* data;
  const py::capsule owner = owner_of(std::move(points), data);
  return py::array_t<double>({size, py::ssize_t(3)}, static_cast<const double*>(data), owner);
}

template <class Index, std::size_t n>
py::array as_array(std::vector<std::array<Index, n>>&& cells)
{
  static_assert(sizeof(Index) == sizeof(std::int64_t), "an array of cells is an array of integers");
  const auto size = static_cast<py::ssize_t>(cells.size());
  const void* data;
  const py::capsule owner = owner_of(std::move(cells), data);
  return py::array_t<std::int64_t>({size, py::ssize_t(n)}, static_cast<const std::int64_t*>(data), owner);
}

template <class Number>
py::array as_array(std::vector<Number>&& numbers)
{
  const auto size = static_cast<py::ssize_t>(numbers.size());
  const void* data;
  const py::capsule owner = owner_of(std::move(numbers), data);
  return py::array_t<Number>(size, static_cast<const Number*>(data), owner);
}

inline py::array as_array(const std::vector<std::size_t>& indices)
{
  return as_array(std::vector<std::int64_t>(indices.begin(), indices.end()));
}

#endif // CGAL_HEX_MESH_OPTIMIZATION_PYTHON_ARRAYS_H
