# cmake -DARROWS=<declared_arrows.cmake> -DSOURCE=<folder that holds libs/> -P includes.cmake
# A library may include its own headers and those of the libraries that it declares; and its public headers must not pass
# on what is heavy: CGAL, the solvers, the readers and writers.

cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/../CleftArrows.cmake)
include(${ARROWS})

set(faults "")
set(scanned 0)
foreach(library IN LISTS CLEFT_LIBRARIES)
  set(root ${SOURCE}/libs/${library})
  set(allowed ${library} ${CLEFT_DEPENDS_${library}})
  file(GLOB_RECURSE files ${root}/include/*.hpp ${root}/src/*.hpp ${root}/src/*.cpp)
  foreach(file IN LISTS files)
    math(EXPR scanned "${scanned} + 1")
    file(STRINGS ${file} lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
      if(line MATCHES "[\"<]cleft/([^/]+)/")
        set(used ${CMAKE_MATCH_1})
        if(NOT used IN_LIST allowed)
          string(APPEND faults "\n${file}: ${line}: ${library} does not declare ${used}")
        endif()
      endif()
      if(file MATCHES "/include/" AND line MATCHES "[\"<](CGAL|umfpack|cholmod|suitesparse|toml|pugixml|zlib|nlohmann|spdlog|CLI)")
        string(APPEND faults "\n${file}: ${line}: only sources may include ${CMAKE_MATCH_1}")
      endif()
    endforeach()
  endforeach()
endforeach()

if(faults)
  message(FATAL_ERROR "includes against the arrows:${faults}")
endif()
if(scanned EQUAL 0)
  message(FATAL_ERROR "no sources below ${SOURCE}/libs")
endif()
message(STATUS "${scanned} files follow the arrows")
