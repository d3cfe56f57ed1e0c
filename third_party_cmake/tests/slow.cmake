# cmake -DSLOW=<slow_tests.cmake> -P slow.cmake
# A pattern that names no test any more would let a slow test pass for a fast one, and into the sanitizers.

cmake_minimum_required(VERSION 3.25)

include(${SLOW})

set(lost "")
list(LENGTH CLEFT_SLOW count)
foreach(entry IN LISTS CLEFT_SLOW)
  string(REGEX MATCH "^(.*)\\|(.*)$" ignored "${entry}")
  execute_process(COMMAND ${CMAKE_MATCH_1} --gtest_list_tests "--gtest_filter=${CMAKE_MATCH_2}"
    OUTPUT_VARIABLE tests COMMAND_ERROR_IS_FATAL ANY)
  if(NOT tests MATCHES "\n  [^ ]")
    string(APPEND lost "\n${entry}")
  endif()
endforeach()
if(lost OR count EQUAL 0)
  message(FATAL_ERROR "of ${count} patterns of slow tests these name none:${lost}")
endif()
message(STATUS "${count} patterns name tests")
