# cmake -DBUILD=<build tree> -DWORK=<scratch folder> -DSCENE=<scene file> -DLIBDIR= -DCOMPILER= -DFLAGS= -DVERSION= -P pkg_config.cmake
# Installs the build tree, then compiles and runs the consumer with nothing but what pkg-config says.

cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
set(ENV{PKG_CONFIG_PATH} ${WORK}/prefix/${LIBDIR}/pkgconfig)
answer(version pkg-config --modversion cleft)
if(NOT version STREQUAL VERSION)
  message(FATAL_ERROR "pkg-config says version ${version}, the project ${VERSION}")
endif()
answer(flags pkg-config --cflags --libs cleft)
if(flags MATCHES "ceres|convergence")
  message(FATAL_ERROR "asks for a library that only the program needs: ${flags}")
endif()
separate_arguments(flags UNIX_COMMAND "${flags}")
separate_arguments(FLAGS UNIX_COMMAND "${FLAGS}")
run(${COMPILER} ${FLAGS} ${CMAKE_CURRENT_LIST_DIR}/consumer/main.cpp -o ${WORK}/consumer ${flags})
run(${WORK}/consumer ${SCENE})
