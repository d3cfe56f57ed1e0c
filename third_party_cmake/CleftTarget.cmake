# What every target of cleft is compiled with.

# C++20 without extensions, and our warnings. Headers of imported targets are system headers and so are exempt.
function(cleft_target_defaults target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
endfunction()

# Executable `target` made of the .cpp files of a folder and its subfolders; nothing if there is none.
# The caller finds out by if(TARGET ...). Further arguments: libraries to link.
function(cleft_executable target folder output)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(${target} ${sources})
  cleft_target_defaults(${target})
  target_link_libraries(${target} PRIVATE ${ARGN})
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${output})
endfunction()

# Test executable `target` of the .cpp files of a folder, each GoogleTest case (rapidcheck is at hand) a test of ctest
# under the name PREFIX.Subject.Statement.
function(cleft_tests target folder prefix)
  if(NOT CLEFT_TESTS)
    return()
  endif()
  cleft_executable(${target} ${folder} tests ${ARGN} GTest::gtest_main rapidcheck_gtest)
  if(TARGET ${target})
    gtest_discover_tests(${target} TEST_PREFIX ${prefix}. DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60)
  endif()
endfunction()
