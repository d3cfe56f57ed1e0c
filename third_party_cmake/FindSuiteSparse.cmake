# Finds UMFPACK of SuiteSparse 5, whose packages bring no CMake files:
#   SuiteSparse::UMFPACK   imported target
#   SuiteSparse_FOUND, SuiteSparse_VERSION

find_path(SuiteSparse_INCLUDE_DIR umfpack.h PATH_SUFFIXES suitesparse)
find_library(SuiteSparse_UMFPACK_LIBRARY umfpack)
mark_as_advanced(SuiteSparse_INCLUDE_DIR SuiteSparse_UMFPACK_LIBRARY)

if(SuiteSparse_INCLUDE_DIR)
  file(STRINGS ${SuiteSparse_INCLUDE_DIR}/SuiteSparse_config.h lines REGEX "^#define SUITESPARSE_[A-Z]+_VERSION +[0-9]+")
  foreach(part MAIN SUB SUBSUB)
    string(REGEX MATCH "SUITESPARSE_${part}_VERSION +([0-9]+)" ignored "${lines}")
    list(APPEND SuiteSparse_VERSION ${CMAKE_MATCH_1})
  endforeach()
  list(JOIN SuiteSparse_VERSION "." SuiteSparse_VERSION)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SuiteSparse
  REQUIRED_VARS SuiteSparse_UMFPACK_LIBRARY SuiteSparse_INCLUDE_DIR
  VERSION_VAR SuiteSparse_VERSION)

if(SuiteSparse_FOUND AND NOT TARGET SuiteSparse::UMFPACK)
  add_library(SuiteSparse::UMFPACK UNKNOWN IMPORTED)
  set_target_properties(SuiteSparse::UMFPACK PROPERTIES
    IMPORTED_LOCATION ${SuiteSparse_UMFPACK_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${SuiteSparse_INCLUDE_DIR})
endif()
