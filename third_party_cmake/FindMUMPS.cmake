# Finds MUMPS for real numbers in double precision, the sequential build (it brings an MPI of its own with one process):
#   MUMPS::DMUMPS   imported target
#   MUMPS_FOUND, MUMPS_VERSION

find_path(MUMPS_INCLUDE_DIR dmumps_c.h)
set(MUMPS_LIBRARIES)
foreach(part dmumps mumps_common mpiseq)
  find_library(MUMPS_${part}_LIBRARY ${part}_seq)
  mark_as_advanced(MUMPS_${part}_LIBRARY)
endforeach()
mark_as_advanced(MUMPS_INCLUDE_DIR)

if(MUMPS_INCLUDE_DIR)
  file(STRINGS ${MUMPS_INCLUDE_DIR}/dmumps_c.h line REGEX "^#define MUMPS_VERSION ")
  string(REGEX MATCH "[0-9]+(\\.[0-9]+)+" MUMPS_VERSION "${line}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MUMPS
  REQUIRED_VARS MUMPS_dmumps_LIBRARY MUMPS_mumps_common_LIBRARY MUMPS_mpiseq_LIBRARY MUMPS_INCLUDE_DIR
  VERSION_VAR MUMPS_VERSION)

if(MUMPS_FOUND AND NOT TARGET MUMPS::DMUMPS)
  add_library(MUMPS::DMUMPS UNKNOWN IMPORTED)
  set_target_properties(MUMPS::DMUMPS PROPERTIES
    IMPORTED_LOCATION ${MUMPS_dmumps_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${MUMPS_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES "${MUMPS_mumps_common_LIBRARY};${MUMPS_mpiseq_LIBRARY}")
endif()
