# Installs the package that find_package(cleft) finds. The targets were added to the export by `cleft_library`.
include(CMakePackageConfigHelpers)
set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/cleft)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cleft-config-version.cmake COMPATIBILITY SameMinorVersion)
install(EXPORT cleft NAMESPACE cleft:: FILE cleft-targets.cmake DESTINATION ${folder})
install(FILES
  ${PROJECT_BINARY_DIR}/cleft-config-version.cmake
  ${CMAKE_CURRENT_LIST_DIR}/cleft-config.cmake
  ${CMAKE_CURRENT_LIST_DIR}/Dependencies.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindSuiteSparse.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindMUMPS.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindMETIS.cmake
  DESTINATION ${folder})
