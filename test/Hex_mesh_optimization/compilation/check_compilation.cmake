# Compiles a file without making an object, and fails unless the compiler says what it is to say:
#
#   cmake -DCOMPILER=<c++> -DFLAGS=<flags> -DPACKAGE_DIRS=<folders> -DINCLUDE_DIRS=<folders> -DIMPLICIT_DIRS=<folders>
#     [-DWITHOUT=<name>] [-DNOT_INCLUDED=<expression>] -DSOURCE=<file> -P <this>
#
# <flags> and <folders> are lists with | between their elements. Folders of the package are for -I, but for one of the name
# that is to be left out; others that the compiler does not know by itself for -isystem.
#
# For each line of the file that ends with "// error: <text>" there must be one error, in which the text occurs. There
# must be no other error, and no warning. With an expression, it only fails if a header that matches it is included.

cmake_minimum_required(VERSION 3.15)
string(REPLACE "|" ";" flags "${FLAGS}")
string(REPLACE "|" ";" package_dirs "${PACKAGE_DIRS}")
string(REPLACE "|" ";" include_dirs "${INCLUDE_DIRS}")
string(REPLACE "|" ";" implicit_dirs "${IMPLICIT_DIRS}")
foreach(dir IN LISTS package_dirs)
  if(NOT WITHOUT OR NOT dir MATCHES "/${WITHOUT}(/|$)")
    list(APPEND flags -I${dir})
  endif()
endforeach()
foreach(dir IN LISTS include_dirs)
  if(NOT dir IN_LIST package_dirs AND NOT dir IN_LIST implicit_dirs)
    list(APPEND flags -isystem ${dir})
  endif()
endforeach()

if(NOT_INCLUDED)
  execute_process(COMMAND ${COMPILER} -M ${flags} ${SOURCE} RESULT_VARIABLE result OUTPUT_VARIABLE headers)
  string(REGEX MATCH "[^ ]*(${NOT_INCLUDED})[^ ]*" found "${headers}")
  if(found OR NOT result EQUAL 0)
    message(FATAL_ERROR "included: ${found}")
  endif()
  return()
endif()

execute_process(COMMAND ${COMPILER} -fsyntax-only ${flags} ${SOURCE} RESULT_VARIABLE result ERROR_VARIABLE output)

# Neither brackets nor semicolons, which lists of CMake cannot hold
function(plain text variable)
  string(REGEX REPLACE "[][;]" "" text "${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

plain("${output}" output)
# with their place: some compilers quote the line of the call, with what it expects
string(REGEX MATCHALL ":[0-9]+: (fatal )?(warning|error): [^\n]*" complaints "${output}")
file(STRINGS ${SOURCE} lines REGEX "// error: ")
set(expected "")
foreach(line IN LISTS lines)
  string(REGEX REPLACE ".*// error: " "" text "${line}")
  plain("${text}" text)
  list(APPEND expected "${text}")
endforeach()

list(LENGTH expected number_of_expected)
list(LENGTH complaints number_of_complaints)
if(NOT number_of_complaints EQUAL number_of_expected OR (number_of_expected EQUAL 0 AND NOT result EQUAL 0))
  message(FATAL_ERROR "${number_of_complaints} errors or warnings, ${number_of_expected} expected:\n${output}")
endif()
foreach(text IN LISTS expected)
  string(FIND "${complaints}" "${text}" place)
  if(place LESS 0)
    message(FATAL_ERROR "no error says \"${text}\":\n${output}")
  endif()
endforeach()
