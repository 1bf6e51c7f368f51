# What the engine and the public headers are to be free of: hex_mesh_optimization_all_warnings.
set(hex_mesh_optimization_all_warnings "")
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(hex_mesh_optimization_all_warnings -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    list(APPEND hex_mesh_optimization_all_warnings -Wno-sign-conversion) # which GCC does not count among conversions
  endif()
endif()
