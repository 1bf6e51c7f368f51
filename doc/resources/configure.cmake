# Writes the Doxyfile of the manual, as CGAL's documentation build would:
# cmake -DOUTPUT=<folder> [-DPACKAGE=<top folder, if not that of this file>] -P configure.cmake

cmake_minimum_required(VERSION 3.15)
set(package Hex_mesh_optimization)
get_filename_component(own_root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
set(root ${own_root})
if(PACKAGE)
  get_filename_component(root ${PACKAGE} ABSOLUTE)
endif()
get_filename_component(OUTPUT_DIRECTORY ${OUTPUT} ABSOLUTE)

# Names of CGAL's build
set(CGAL_DOC_RESOURCE_DIR ${CMAKE_CURRENT_LIST_DIR})
set(CGAL_PACKAGE_DOC_DIR ${root}/doc/${package})
set(CGAL_PACKAGE_INCLUDE_DIR ${root}/include)
set(CGAL_EXAMPLE_DIR ${root}/examples)
set(CGAL_DOC_PACKAGE_DEFAULTS ${OUTPUT_DIRECTORY}/Doxyfile_defaults)
file(STRINGS ${own_root}/CMakeLists.txt version REGEX "^project\\(")
string(REGEX REPLACE ".*VERSION ([0-9.]+).*" "package \\1" CGAL_DOC_VERSION ${version})

configure_file(${CGAL_DOC_RESOURCE_DIR}/Doxyfile_defaults.in ${CGAL_DOC_PACKAGE_DEFAULTS})
configure_file(${CGAL_PACKAGE_DOC_DIR}/Doxyfile.in ${OUTPUT_DIRECTORY}/Doxyfile)
