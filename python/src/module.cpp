// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The compiled part of the Python module: hex_mesh_optimization._engine. Its functions take arguments that the Python
// part has checked.

#include "mesh_files.h"
#include "optimize.h"
#include "page.h"
#include "quality.h"

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/Input_error.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>
#include <string>

namespace HMO = CGAL::Hex_mesh_optimization;

namespace {

const char* name(HMO::Input_error::Element element)
{
  using Element = HMO::Input_error::Element;
  switch (element) {
  case Element::MESH:
    return "MESH";
  case Element::VERTEX:
    return "VERTEX";
  case Element::HEXAHEDRON:
    return "HEXAHEDRON";
  case Element::REFERENCE_VERTEX:
    return "REFERENCE_VERTEX";
  case Element::REFERENCE_FACE:
    return "REFERENCE_FACE";
  case Element::PARAMETER:
    return "PARAMETER";
  }
  return "";
}

// As the classes of the Python part.
void translate(std::exception_ptr thrown)
{
  const auto raise = [](const char* type, const auto&... arguments) {
    const py::object error = py::module_::import("hex_mesh_optimization._errors").attr(type)(arguments...);
    PyErr_SetObject(py::type::of(error).ptr(), error.ptr());
  };
  try {
    std::rethrow_exception(thrown);
  }
  catch (const HMO::Input_error& error) {
    raise("Input_error", error.what(), std::string(name(error.element())), error.element_index());
  }
  catch (const CGAL::IO::Hex_mesh_file_error& error) {
    raise("Hex_mesh_file_error", std::string(error.what()), error.file(), error.line());
  }
}

} // namespace

PYBIND11_MODULE(_engine, m)
{
  py::register_exception_translator(&translate);
  py::class_<File_content>(m, "File_content");
  m.attr("version") = CGAL_HEX_MESH_OPTIMIZATION_VERSION;
  m.def("optimize", &optimize);
  m.def("make", &make);
  m.def("quality", &quality);
  m.def("invalid", &invalid);
  m.def("statistics", &statistics);
  m.def("read", &read_mesh);
  m.def("read_surface", &read_triangles);
  m.def("write", &write_mesh);
  m.def("write_page", &write_page);
}
