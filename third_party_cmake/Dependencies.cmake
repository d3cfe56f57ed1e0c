# The packages that the installed libraries are built on, with the least version: for the build and, as they are static,
# for whoever links them.
set(CLEFT_PACKAGES
  "Eigen3 3.4"
  "fmt 9"
  "spdlog 1.10"
  "CGAL 5.5"
  "SuiteSparse 5"
  "MUMPS 5"
  "METIS 5"
  "tomlplusplus 3.3"
  "pugixml 1.13"
  "ZLIB"
  "nlohmann_json 3.11")

# SuiteSparse, MUMPS and METIS have find modules of ours, beside this file.
list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
# CGAL warns about every build type but Release; a development build is meant to be one.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
