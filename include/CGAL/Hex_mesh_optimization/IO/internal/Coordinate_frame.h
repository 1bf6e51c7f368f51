// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_COORDINATE_FRAME_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_COORDINATE_FRAME_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The coordinate systems in which solvers let points be given: rectangular, cylindrical, spherical.

#include <array>
#include <cmath>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Coordinate_frame
{
public:
  using Triple = std::array<double, 3>;

  enum class Kind { RECTANGULAR, CYLINDRICAL, SPHERICAL }; // angles in degrees

  Coordinate_frame() = default;

  // `on_axis`: a point of the third axis; `in_plane`: one of the half-plane of the first and the third.
  Coordinate_frame(Kind kind, const Triple& origin, const Triple& on_axis, const Triple& in_plane)
    : kind_(kind)
    , origin_(origin)
  {
    const Triple z = unit(difference(on_axis, origin));
    const Triple y = unit(cross(z, difference(in_plane, origin)));
    axes_ = {{cross(y, z), y, z}};
  }

  Triple to_basic(const Triple& p) const
  {
    Triple local = p;
    constexpr double degree = 3.14159265358979323846 / 180;
    if (kind_ == Kind::CYLINDRICAL)
      local = {{p[0] * std::cos(p[1] * degree), p[0] * std::sin(p[1] * degree), p[2]}};
    else if (kind_ == Kind::SPHERICAL)
      local = {{p[0] * std::sin(p[1] * degree) * std::cos(p[2] * degree),
                p[0] * std::sin(p[1] * degree) * std::sin(p[2] * degree), p[0] * std::cos(p[1] * degree)}};
    Triple result = origin_;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        result[k] += local[i] * axes_[i][k];
    return result;
  }

  Triple from_basic(const Triple& p) const
  {
    const Triple d = difference(p, origin_);
    Triple local;
    for (int i = 0; i < 3; ++i)
      local[i] = dot(axes_[i], d);
    constexpr double degree = 3.14159265358979323846 / 180;
    const double r = std::hypot(local[0], local[1]);
    const double azimuth = std::atan2(local[1], local[0]) / degree;
    if (kind_ == Kind::CYLINDRICAL)
      return {{r, azimuth, local[2]}};
    if (kind_ == Kind::SPHERICAL)
      return {{std::hypot(r, local[2]), std::atan2(r, local[2]) / degree, azimuth}};
    return local;
  }

  // Whether two of its axes fall together.
  bool is_degenerate() const
  {
    for (const Triple& a : axes_)
      if (!(dot(a, a) > .5))
        return true;
    return false;
  }

private:
  static Triple difference(const Triple& a, const Triple& b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }
  static double dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Triple cross(const Triple& a, const Triple& b)
  {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
  }
  static Triple unit(const Triple& a)
  {
    const double length = std::sqrt(dot(a, a));
    return length > 0 ? Triple{{a[0] / length, a[1] / length, a[2] / length}} : Triple{{0, 0, 0}};
  }

  Kind kind_ = Kind::RECTANGULAR;
  Triple origin_ = {{0, 0, 0}};
  std::array<Triple, 3> axes_ = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_COORDINATE_FRAME_H
