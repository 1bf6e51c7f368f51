# Finds what the Python module is built with. Sets hex_mesh_python_lacks to what is not there.

set(hex_mesh_python_lacks "")

# Of several interpreters, as with pyenv before that of the system, the first one that has numpy.
if(NOT Python_EXECUTABLE AND NOT Python_ROOT_DIR)
  foreach(candidate python3 /usr/bin/python3)
    execute_process(COMMAND ${candidate} -c "import numpy, sys; print(sys.executable)"
      OUTPUT_VARIABLE executable OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE result)
    if(result EQUAL 0)
      set(Python_EXECUTABLE ${executable} CACHE FILEPATH "The interpreter that the Python module is for")
      break()
    endif()
  endforeach()
endif()

set(development Development.Module)
if(CMAKE_VERSION VERSION_LESS 3.18)
  set(development Development)
endif()
if(Python_EXECUTABLE OR Python_ROOT_DIR)
  find_package(Python 3.8 QUIET COMPONENTS Interpreter ${development})
  execute_process(COMMAND ${Python_EXECUTABLE} -m pybind11 --cmakedir # where pip has installed it
    OUTPUT_VARIABLE pybind11_folder OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  find_package(pybind11 2.6 CONFIG QUIET HINTS ${pybind11_folder})
  if(NOT Python_FOUND)
    list(APPEND hex_mesh_python_lacks "the headers of Python (Debian: python3-dev)")
  endif()
else()
  list(APPEND hex_mesh_python_lacks "an interpreter with numpy (Debian: python3-numpy)")
endif()
if(NOT pybind11_FOUND)
  list(APPEND hex_mesh_python_lacks "pybind11 (Debian: pybind11-dev)")
endif()
find_package(nlohmann_json QUIET)
if(NOT nlohmann_json_FOUND)
  list(APPEND hex_mesh_python_lacks "JSON for Modern C++ (Debian: nlohmann-json3-dev)")
endif()
string(REPLACE ";" ", " hex_mesh_python_lacks "${hex_mesh_python_lacks}")
