# cmake -DARROWS=<declared_arrows.cmake> -P bad_includes.cmake
# The scan of the includes must find the two faults of the folder bad_includes, and only these.

cmake_minimum_required(VERSION 3.25)

execute_process(
  COMMAND ${CMAKE_COMMAND} -DARROWS=${ARROWS} -DSOURCE=${CMAKE_CURRENT_LIST_DIR}/bad_includes
          -P ${CMAKE_CURRENT_LIST_DIR}/includes.cmake
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
string(REGEX REPLACE "[ \n]+" " " output "${output}")
string(REGEX MATCHALL "contact does not declare constitutive|only sources may include CGAL" faults "${output}")
string(REGEX MATCHALL "#include" all "${output}")
list(LENGTH faults found)
list(LENGTH all reported)
if(result EQUAL 0 OR NOT found EQUAL 2 OR NOT reported EQUAL 2)
  message(FATAL_ERROR "exit code ${result}, found ${found} of 2 faults among ${reported} reported:\n${output}")
endif()
