# find_package(cleft): a target for each installed library, cleft::support to cleft::report, with what it needs.
include(CMakeFindDependencyMacro)
include(${CMAKE_CURRENT_LIST_DIR}/Dependencies.cmake)
foreach(cleft_package IN LISTS CLEFT_PACKAGES)
  separate_arguments(cleft_package)
  find_dependency(${cleft_package})
endforeach()
list(POP_FRONT CMAKE_MODULE_PATH)
include(${CMAKE_CURRENT_LIST_DIR}/cleft-targets.cmake)
