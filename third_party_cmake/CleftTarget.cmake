# What every target of cleft is made with.

# C++20 without extensions, and our warnings. Headers of imported targets are system headers and so are exempt.
function(cleft_target_defaults target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
endfunction()

# cleft_executable(TARGET SOURCES output library...): executable of the .cpp files below the folder SOURCES, put into folder
# `output` of the build tree; no target if there are no files.
function(cleft_executable target sources output)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${sources}/*.cpp)
  if(NOT files)
    return()
  endif()
  add_executable(${target} ${files})
  cleft_target_defaults(${target})
  target_link_libraries(${target} PRIVATE ${ARGN})
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${output})
endfunction()

# cleft_tests(NAME library...): executable test_NAME of the .cpp files below the folder tests/. Each of its GoogleTest cases
# is a test of ctest, called NAME.Subject.Statement and labelled NAME. rapidcheck is at hand; CLEFT_SOURCE_DIR is the root
# of the sources. What tests of several libraries share is included as "LIBRARY/tests/FILE".
function(cleft_tests name)
  if(NOT CLEFT_TESTS)
    return()
  endif()
  set(target test_${name})
  cleft_executable(${target} ${CMAKE_CURRENT_SOURCE_DIR}/tests tests ${ARGN} GTest::gtest_main rapidcheck_gtest)
  if(TARGET ${target})
    target_compile_definitions(${target} PRIVATE CLEFT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/libs)  # for what tests share
    # Files of the tests (testing::TempDir) stay in the build tree, so that two trees can be tested at a time.
    set(scratch ${PROJECT_BINARY_DIR}/tests/scratch)
    file(MAKE_DIRECTORY ${scratch})
    gtest_discover_tests(${target}
      TEST_PREFIX ${name}. NO_PRETTY_VALUES DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
      PROPERTIES LABELS ${name} TIMEOUT 600 ENVIRONMENT TEST_TMPDIR=${scratch})
  endif()
endfunction()
