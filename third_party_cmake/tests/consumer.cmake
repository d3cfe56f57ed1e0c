# cmake -DBUILD=<build tree> -DWORK=<scratch folder> -DSCENE=<scene file> -DGENERATOR= -DCOMPILER= -DBUILD_TYPE= -DFLAGS=
#   -P consumer.cmake
# Installs the build tree, then configures, builds and runs the project `consumer` on what was installed, as on a
# machine without Ceres, which only a library of the program needs.

cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${WORK}/build -G ${GENERATOR}
  -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_DISABLE_FIND_PACKAGE_Ceres=ON
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DCMAKE_CXX_FLAGS=${FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer ${SCENE})
run(${WORK}/build/by_hand)
