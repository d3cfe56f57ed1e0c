# cleft_library(NAME
#   [INTERNAL]
#   DEPENDS <libraries of cleft below this one>
#   PUBLIC  <imported targets that its headers need>
#   PRIVATE <imported targets that only its sources need>
#   TEST    <imported targets that only its tests and benchmarks need>
#   SLOW    <patterns of its tests that take long: see cleft_tests>)
#
# declares library NAME in the folder libs/NAME, with its include/, src/, tests/ and benchmarks/:
#   cleft_NAME, alias cleft::NAME   static library (interface library without sources), installed and
#                                   exported unless it is INTERNAL: then only the program of this tree links it
#   test_NAME                       tests, if CLEFT_TESTS; they see src/ as well, for the private headers. They are labelled
#                                   `library`, and the target library_tests builds those of all libraries
#   bench_NAME                      benchmarks, if CLEFT_BENCHMARKS; likewise
# A dependency outside the table of CleftArrows.cmake stops the configuration.

include(${CMAKE_CURRENT_LIST_DIR}/CleftArrows.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/CleftTarget.cmake)

function(cleft_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "INTERNAL" "" "DEPENDS;PUBLIC;PRIVATE;TEST;SLOW")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "cleft_library: ${name}: unknown argument ${arg_UNPARSED_ARGUMENTS}")
  endif()
  cleft_check_arrows(${name} ${arg_DEPENDS})
  set_property(GLOBAL PROPERTY CLEFT_DEPENDS_${name} "${arg_DEPENDS}")

  set(here ${CMAKE_CURRENT_SOURCE_DIR})
  set(library cleft_${name})
  list(TRANSFORM arg_DEPENDS PREPEND cleft:: OUTPUT_VARIABLE lower)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${here}/src/*.cpp)
  if(sources)
    add_library(${library} STATIC ${sources})
    cleft_target_defaults(${library})
    target_link_libraries(${library} PRIVATE ${arg_PRIVATE})
    set(scope PUBLIC)
  else()
    add_library(${library} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(cleft::${name} ALIAS ${library})
  target_include_directories(${library} ${scope} $<BUILD_INTERFACE:${here}/include>)
  target_link_libraries(${library} ${scope} ${lower} ${arg_PUBLIC})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})

  if(NOT arg_INTERNAL)
    set_property(GLOBAL APPEND PROPERTY CLEFT_EXPORTED ${name})
    install(TARGETS ${library} EXPORT cleft INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    if(EXISTS ${here}/include)
      install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    endif()
  endif()

  cleft_tests(${name} ${library} ${arg_TEST} LABELS library SLOW ${arg_SLOW})
  if(TARGET test_${name})
    if(NOT TARGET library_tests)
      add_custom_target(library_tests)
    endif()
    add_dependencies(library_tests test_${name})
    target_include_directories(test_${name} PRIVATE ${here}/src)
  endif()
  if(CLEFT_BENCHMARKS)
    cleft_executable(bench_${name} ${here}/benchmarks benchmarks ${library} ${arg_PRIVATE} ${arg_TEST} benchmark::benchmark_main)
    if(TARGET bench_${name})
      target_include_directories(bench_${name} PRIVATE ${here}/src ${PROJECT_SOURCE_DIR}/libs)
    endif()
  endif()
endfunction()
