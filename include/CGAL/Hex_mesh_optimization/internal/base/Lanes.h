// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_LANES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_LANES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Several numbers that one instruction works on, and the functions that formulas
// written for them and for double alike need.

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace CGAL::Hex_mesh_optimization::internal {

#if defined(__GNUC__)

// As wide as the registers are, so that it is passed in them.
#if defined(__AVX512F__)
constexpr int number_of_lanes = 16;
#elif defined(__AVX__)
constexpr int number_of_lanes = 8;
#else
constexpr int number_of_lanes = 4;
#endif
using Lanes = float __attribute__((vector_size(4 * number_of_lanes)));

inline void set_lane(Lanes& x, int lane, float value) { x[lane] = value; }
inline float lane(const Lanes& x, int lane) { return x[lane]; }

namespace lanes {

using Array = Eigen::Array<float, number_of_lanes, 1>;
using Map = Eigen::Map<Array, sizeof(Lanes)>; // aligned to its size
using Const_map = Eigen::Map<const Array, sizeof(Lanes)>;
using Bits = int __attribute__((vector_size(4 * number_of_lanes)));

inline Const_map map(const Lanes& x) { return Const_map(reinterpret_cast<const float*>(&x)); }
inline Map map(Lanes& x) { return Map(reinterpret_cast<float*>(&x)); }

} // namespace lanes

inline Lanes square_root(const Lanes& x)
{
  Lanes result;
  lanes::map(result) = lanes::map(x).sqrt();
  return result;
}

inline Lanes logarithm(const Lanes& x)
{
  Lanes result;
  lanes::map(result) = lanes::map(x).log();
  return result;
}

// x^-⅓ of normal numbers, by Newton's method from a third of the exponent.
inline Lanes inverse_cube_root(const Lanes& x)
{
  const Lanes third = __builtin_convertvector(reinterpret_cast<lanes::Bits>(x), Lanes) * (1 / 3.f);
  const lanes::Bits bits = 0x54a21d2a - __builtin_convertvector(third, lanes::Bits);
  Lanes y = reinterpret_cast<Lanes>(bits);
  for (int i = 0; i < 3; ++i) // relative errors: .03, .002, 1e-5, below rounding
    y *= 4 / 3.f - 1 / 3.f * x * y * y * y;
  return y;
}

inline Lanes larger(const Lanes& x, const Lanes& y) { return x > y ? x : y; }
inline Lanes smaller(const Lanes& x, const Lanes& y) { return x < y ? x : y; }

// a where x > 0, else b.
inline Lanes if_positive(const Lanes& x, const Lanes& a, const Lanes& b) { return x > 0 ? a : b; }

#else

constexpr int number_of_lanes = 1;
using Lanes = float;

inline void set_lane(Lanes& x, int, float value) { x = value; }
inline float lane(const Lanes& x, int) { return x; }

inline float square_root(float x) { return std::sqrt(x); }
inline float logarithm(float x) { return std::log(x); }
inline float inverse_cube_root(float x) { return 1 / std::cbrt(x); }
inline float larger(float x, float y) { return x > y ? x : y; }
inline float smaller(float x, float y) { return x < y ? x : y; }
inline float if_positive(float x, float a, float b) { return x > 0 ? a : b; }

#endif

inline double lane(double x, int) { return x; }
inline double square_root(double x) { return std::sqrt(x); }
inline double logarithm(double x) { return std::log(x); }
inline double inverse_cube_root(double x) { return 1 / std::cbrt(x); }
inline double larger(double x, double y) { return x > y ? x : y; }
inline double smaller(double x, double y) { return x < y ? x : y; }
inline double if_positive(double x, double a, double b) { return x > 0 ? a : b; }

// What a lane holds: constants in formulas have to be of this type.
template <class Real>
struct Lane
{
  using type = Real;
};

#if defined(__GNUC__)
template <>
struct Lane<Lanes>
{
  using type = float;
};
#endif

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_LANES_H
