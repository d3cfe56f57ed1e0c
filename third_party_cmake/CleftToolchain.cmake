# Settings of the whole build that come from options: build type, compiler cache, sanitizers, clang-tidy.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(CLEFT_CCACHE ccache)
  mark_as_advanced(CLEFT_CCACHE)
  if(CLEFT_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CLEFT_CCACHE})
  endif()
endif()

if(CLEFT_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

if(CLEFT_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

if(CLEFT_TIDY)
  find_program(CLEFT_CLANG_TIDY clang-tidy-16)
  if(CLEFT_CLANG_TIDY)
    set(CMAKE_CXX_CLANG_TIDY ${CLEFT_CLANG_TIDY} --quiet)
  else()
    message(WARNING "CLEFT_TIDY: clang-tidy-16 not found (Debian package clang-tidy-16): nothing will be linted")
  endif()
endif()
