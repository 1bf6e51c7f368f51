# The source tree as a package: -DCGAL_Hex_mesh_optimization_DIR=<this folder>, without an installation. The engine is built
# with the first program that links with it.

include("${CMAKE_CURRENT_LIST_DIR}/cmake/CGAL_Hex_mesh_optimization_dependencies.cmake")
if(NOT TARGET CGAL::Hex_mesh_optimization)
  add_subdirectory("${CMAKE_CURRENT_LIST_DIR}" "${CMAKE_BINARY_DIR}/CGAL_Hex_mesh_optimization" EXCLUDE_FROM_ALL)
  get_directory_property(CGAL_Hex_mesh_optimization_VERSION DIRECTORY "${CMAKE_CURRENT_LIST_DIR}" DEFINITION PROJECT_VERSION)
endif()
set(CGAL_Hex_mesh_optimization_engine_FOUND TRUE)
