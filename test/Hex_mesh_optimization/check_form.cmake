# Fails where a file lacks what CGAL asks of its packages: cmake -DPACKAGE=<top folder> -P check_form.cmake

cmake_minimum_required(VERSION 3.15)

function(complain message)
  message(SEND_ERROR "${message}")
endfunction()

# Each header: copyright, license, author, the two lines that CGAL's releases fill in, and the check of the license
file(GLOB_RECURSE headers RELATIVE ${PACKAGE} ${PACKAGE}/include/*.h ${PACKAGE}/STL_Extension/*.h ${PACKAGE}/src/*.cpp)
list(LENGTH headers number_of_headers)
if(number_of_headers EQUAL 0)
  message(FATAL_ERROR "no headers in ${PACKAGE}")
endif()
foreach(header IN LISTS headers)
  file(READ ${PACKAGE}/${header} text LIMIT 1000)
  if(NOT text MATCHES
     "^// Copyright \\(c\\) [^\n]*\n// All rights reserved.\n//\n// \\$URL\\$\n// \\$Id\\$\n// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial\n//\n// Author\\(s\\)     : ")
    complain("${header} does not begin with copyright, $URL$, $Id$, license and author")
  endif()
  if(header MATCHES "^include/" AND NOT header MATCHES "/license/" AND
     NOT text MATCHES "#include <CGAL/license/Hex_mesh_optimization.h>")
    complain("${header} does not include CGAL/license/Hex_mesh_optimization.h")
  endif()
endforeach()

# The reference manual lists what is declared outside of namespaces internal
file(GLOB public_headers RELATIVE ${PACKAGE} ${PACKAGE}/include/CGAL/*.h ${PACKAGE}/include/CGAL/Hex_mesh_optimization/*.h
  ${PACKAGE}/include/CGAL/Hex_mesh_optimization/IO/*.h)
file(READ ${PACKAGE}/doc/Hex_mesh_optimization/PackageDescription.txt description)
set(number_of_names 0)
foreach(header IN LISTS public_headers)
  file(READ ${PACKAGE}/${header} text)
  while(text MATCHES "\nnamespace ([A-Za-z_:]*internal[A-Za-z_:]*) {")
    set(namespace ${CMAKE_MATCH_1})
    string(FIND "${text}" "\nnamespace ${namespace} {" begin)
    string(SUBSTRING "${text}" 0 ${begin} before)
    string(SUBSTRING "${text}" ${begin} -1 rest)
    string(FIND "${rest}" "\n} // namespace ${namespace}" end)
    if(end LESS 0)
      message(FATAL_ERROR "${header}: namespace ${namespace} does not end with its name")
    endif()
    math(EXPR end "${end} + 5") # with the brace
    string(SUBSTRING "${rest}" ${end} -1 rest)
    set(text "${before}${rest}")
  endwhile()
  string(REGEX REPLACE "[][;]" "" text "${text}")
  string(REGEX MATCHALL "\n(struct|class|enum class) [A-Za-z_]+\n|\n(struct|class|enum class) [A-Za-z_]+ |\n[A-Za-z][A-Za-z_:<>* ]* [a-z_]+\\(" declarations "${text}")
  foreach(declaration IN LISTS declarations)
    string(STRIP "${declaration}" declaration)
    string(REGEX REPLACE ".* ([A-Za-z_]+)(\\(?)$" "\\1" name "${declaration}")
    if(NOT description MATCHES "::${name}(\\(\\))?`")
      complain("${header}: PackageDescription.txt does not list ${name}")
    endif()
    math(EXPR number_of_names "${number_of_names} + 1")
  endforeach()
endforeach()
if(number_of_names LESS 50)
  message(FATAL_ERROR "only ${number_of_names} public names were found")
endif()

# What the packages of CGAL say of themselves
foreach(file copyright dependencies description.txt license.txt long_description.txt maintainer)
  if(NOT EXISTS ${PACKAGE}/package_info/Hex_mesh_optimization/${file})
    complain("package_info/Hex_mesh_optimization/${file} is missing")
  endif()
endforeach()
