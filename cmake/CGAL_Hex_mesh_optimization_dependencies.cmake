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
