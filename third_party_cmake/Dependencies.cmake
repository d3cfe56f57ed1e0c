# Everything from outside, for the build tree and for the installed package alike. C is needed by the checks of some packages.
include(CMakeFindDependencyMacro)
list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_dependency(Eigen3 3.4)
find_dependency(fmt)
find_dependency(spdlog)
find_dependency(SuiteSparse MODULE)
find_dependency(pugixml)
find_dependency(ZLIB)
find_dependency(nlohmann_json)
if(NOT TARGET cleft::tomlplusplus)
  # Debian ships toml++ as a header with a compiled half; there is no CMake package for that half.
  find_path(tomlplusplus_INCLUDE_DIR toml++/toml.h REQUIRED)
  find_library(tomlplusplus_LIBRARY tomlplusplus REQUIRED)
  mark_as_advanced(tomlplusplus_INCLUDE_DIR tomlplusplus_LIBRARY)
  add_library(cleft::tomlplusplus UNKNOWN IMPORTED)
  set_target_properties(
    cleft::tomlplusplus PROPERTIES IMPORTED_LOCATION ${tomlplusplus_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${tomlplusplus_INCLUDE_DIR}
                                   INTERFACE_COMPILE_DEFINITIONS "TOML_HEADER_ONLY=0;TOML_SHARED_LIB=1")
endif()
