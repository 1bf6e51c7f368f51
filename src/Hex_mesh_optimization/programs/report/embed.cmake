# Puts the page together, with all that it needs, and writes it as the source of embedded_report_page():
# cmake -DOUTPUT=<file> [-DTHREE=<folder of three.js>] -P embed.cmake
cmake_minimum_required(VERSION 3.15)

if(NOT THREE)
  file(WRITE ${OUTPUT} "#include \"embedded_report_page.h\"\n\nstd::string embedded_report_page()\n{\n  return {};\n}\n")
  return()
endif()

file(READ ${CMAKE_CURRENT_LIST_DIR}/page.html page)
foreach(part page.css Mesh.js Viewer.js charts.js page.js)
  file(READ ${CMAKE_CURRENT_LIST_DIR}/${part} text)
  string(REPLACE "@${part}@" "${text}" page "${page}")
endforeach()
# last: what is in them is not looked through for places
foreach(part build/three.min.js examples/js/controls/OrbitControls.js)
  file(READ ${THREE}/${part} text)
  string(REPLACE "@${part}@" "${text}" page "${page}")
endforeach()

# No compiler takes a literal of any length.
string(LENGTH "${page}" length)
set(source "#include \"embedded_report_page.h\"\n\nstd::string embedded_report_page()\n{\n  static const char* const parts[] = {\n")
foreach(begin RANGE 0 ${length} 8000)
  string(SUBSTRING "${page}" ${begin} 8000 part)
  string(APPEND source "R\"__(${part})__\",\n")
endforeach()
string(APPEND source "  };\n  std::string page;\n  for (const char* part : parts)\n    page += part;\n  return page;\n}\n")
file(WRITE ${OUTPUT} "${source}")
