# SuiteSparse::UMFPACK and SuiteSparse::CHOLMOD
find_path(SuiteSparse_INCLUDE_DIR umfpack.h PATH_SUFFIXES suitesparse)
find_library(SuiteSparse_UMFPACK_LIBRARY umfpack)
find_library(SuiteSparse_CHOLMOD_LIBRARY cholmod)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SuiteSparse REQUIRED_VARS SuiteSparse_INCLUDE_DIR SuiteSparse_UMFPACK_LIBRARY
                                                            SuiteSparse_CHOLMOD_LIBRARY)
foreach(part UMFPACK CHOLMOD)
  if(SuiteSparse_FOUND AND NOT TARGET SuiteSparse::${part})
    add_library(SuiteSparse::${part} UNKNOWN IMPORTED)
    set_target_properties(SuiteSparse::${part} PROPERTIES IMPORTED_LOCATION ${SuiteSparse_${part}_LIBRARY}
                                                          INTERFACE_INCLUDE_DIRECTORIES ${SuiteSparse_INCLUDE_DIR})
  endif()
endforeach()
mark_as_advanced(SuiteSparse_INCLUDE_DIR SuiteSparse_UMFPACK_LIBRARY SuiteSparse_CHOLMOD_LIBRARY)
