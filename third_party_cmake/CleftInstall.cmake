# What is installed: the package that find_package(cleft) finds (the targets were added to the export by
# `cleft_library`), that of pkg-config, the documentation; and Debian's package of it all (cpack -G DEB).
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
include(CleftPkgConfig)

install(FILES README.md tools/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(DIRECTORY verification/scenes DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Who links the libraries needs the -dev packages that the build needs, but for those of the tests, the program and its
# internal libraries.
file(STRINGS tools/packages.txt packages REGEX "-dev$")
list(FILTER packages EXCLUDE REGEX "gtest|rapidcheck|benchmark|cli11|ceres")
list(JOIN packages ", " CPACK_DEBIAN_PACKAGE_SUGGESTS)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_CONTACT "The authors of cleft <cleft@localhost>")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot-nox)  # draws the figures of `cleft report`
if(PROJECT_IS_TOP_LEVEL)
  include(CPack)
endif()
