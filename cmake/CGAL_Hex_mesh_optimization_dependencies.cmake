# Finds what the headers need and attaches the optional part of it to the target.
# The project's own build and an installed package both include this file, so
# that a program is always compiled with what its own machine offers.

include(CMakeFindDependencyMacro)

# The version is checked afterwards: the top folder of an unpacked CGAL has no
# version file, and CMake would silently pass over it for one that has.
find_dependency(CGAL)
if(DEFINED CGAL_MAJOR_VERSION AND "${CGAL_MAJOR_VERSION}.${CGAL_MINOR_VERSION}" VERSION_LESS 5.5)
  message(FATAL_ERROR "Hex_mesh_optimization needs CGAL 5.5 or newer; this is "
                      "${CGAL_MAJOR_VERSION}.${CGAL_MINOR_VERSION} (${CGAL_DIR})")
endif()
# CONFIG: the FindEigen3 module that CGAL puts on the path defines no target on a second run
find_dependency(Eigen3 CONFIG)
find_dependency(Boost)

option(CGAL_HEX_MESH_OPTIMIZATION_WITH_TBB "Run in several threads with TBB where it is found" ON)
option(CGAL_HEX_MESH_OPTIMIZATION_WITH_ZLIB "Read compressed .vtu files with zlib where it is found" ON)
mark_as_advanced(CGAL_HEX_MESH_OPTIMIZATION_WITH_TBB CGAL_HEX_MESH_OPTIMIZATION_WITH_ZLIB)

if(CGAL_HEX_MESH_OPTIMIZATION_WITH_TBB)
  find_package(TBB QUIET)
  include(CGAL_TBB_support)
endif()
if(CGAL_HEX_MESH_OPTIMIZATION_WITH_ZLIB)
  find_package(ZLIB QUIET)
endif()

function(cgal_hex_mesh_optimization_link_optional target)
  if(CGAL_HEX_MESH_OPTIMIZATION_WITH_TBB AND TARGET CGAL::TBB_support)
    target_link_libraries(${target} INTERFACE $<BUILD_INTERFACE:CGAL::TBB_support>)
  endif()
  if(CGAL_HEX_MESH_OPTIMIZATION_WITH_ZLIB AND TARGET ZLIB::ZLIB)
    target_link_libraries(${target} INTERFACE $<BUILD_INTERFACE:ZLIB::ZLIB>)
    target_compile_definitions(${target} INTERFACE
      $<BUILD_INTERFACE:CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB=1>)
  endif()
endfunction()

# For programs that read all files of solvers: netCDF for Exodus, HDF5 for MED, where they are found. All sources of a
# program must be compiled with the same.
function(cgal_hex_mesh_optimization_link_file_libraries target)
  find_package(netCDF QUIET CONFIG)
  if(TARGET netCDF::netcdf)
    target_link_libraries(${target} PUBLIC netCDF::netcdf)
    target_compile_definitions(${target} PUBLIC CGAL_HEX_MESH_OPTIMIZATION_USE_NETCDF=1)
  else()
    message(STATUS "netCDF was not found (Debian: libnetcdf-dev): files of Exodus are refused.")
  endif()
  enable_language(C) # FindHDF5 compiles with it
  find_package(HDF5 QUIET COMPONENTS C)
  if(HDF5_FOUND)
    target_include_directories(${target} SYSTEM PUBLIC ${HDF5_C_INCLUDE_DIRS})
    target_link_libraries(${target} PUBLIC ${HDF5_C_LIBRARIES})
    target_compile_definitions(${target} PUBLIC CGAL_HEX_MESH_OPTIMIZATION_USE_HDF5=1)
  else()
    message(STATUS "HDF5 was not found (Debian: libhdf5-dev): files of MED are refused.")
  endif()
endfunction()
