# cmake -DBUILD=<build tree> -DWORK=<scratch folder> -DVERSION= -P debian.cmake
# Packs the build tree for Debian, unpacks the package into an empty root, and uses what is there.

cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

# demand(TEXT PATTERN...): every pattern is somewhere in the text.
function(demand text)
  foreach(pattern IN LISTS ARGN)
    if(NOT text MATCHES "${pattern}")
      message(FATAL_ERROR "'${pattern}' is not in:\n${text}")
    endif()
  endforeach()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_CPACK_COMMAND} -G DEB --config ${BUILD}/CPackConfig.cmake -B ${WORK})
file(GLOB package ${WORK}/*.deb)
answer(control dpkg-deb -I ${package})
demand("${control}" "Package: cleft" "Version: ${VERSION}" "Depends: [^\n]*libc6" "Depends: [^\n]*libumfpack"
  "Depends: [^\n]*libdmumps|Depends: [^\n]*libmumps" "Depends: [^\n]*libspdlog" "Recommends: gnuplot-nox"
  "Suggests: [^\n]*libeigen3-dev")

if(control MATCHES "Suggests: [^\n]*libceres")
  message(FATAL_ERROR "whoever links the libraries is told to install Ceres:\n${control}")
endif()

set(root ${WORK}/root)
run(dpkg-deb -x ${package} ${root})
answer(version ${root}/usr/bin/cleft --version)
demand("${version}" "^${VERSION}$")
run(${root}/usr/bin/cleft init ${WORK}/scene.toml)
answer(told ${root}/usr/bin/cleft run ${WORK}/scene.toml -o ${WORK}/results)
demand("${told}" "done at load 1")
answer(installed dpkg-deb -c ${package})
demand("${installed}" "bin/cleft\n" "libcleft_scene\\.a\n" "include/cleft/simulation/run\\.hpp\n" "pkgconfig/cleft\\.pc\n"
  "cleft-targets\\.cmake\n" "doc/cleft/copyright\n" "doc/cleft/CHANGELOG\\.md\n" "scenes/block\\.toml\n")

file(READ ${root}/usr/share/man/man1/cleft.1 manual)
foreach(verb init scene run check converge newton tangent report)
  demand("${manual}" "\n\\.SS cleft ${verb}\n")
endforeach()
demand("${manual}" "\\\\-\\\\-resume" "mesh\\.cells" "cleft ${VERSION}")

# bash completes verbs, options and keys, those of cracks by their names in the scene on the line
set(ENV{PATH} ${root}/usr/bin:$ENV{PATH})
function(completes line expected)
  answer(words bash ${CMAKE_CURRENT_LIST_DIR}/completes.sh ${root}/usr/share/bash-completion/completions/cleft ${line})
  if(NOT words STREQUAL expected)
    message(FATAL_ERROR "'${line}' is completed to '${words}', not to '${expected}'")
  endif()
endfunction()
completes("cleft che" "check")
completes("cleft run --re" "--resume")
completes("cleft run scene.toml --set mesh.ce" "mesh.cells=")
completes("cleft run ${WORK}/scene.toml --set crack.fault.fr" "crack.fault.friction=")
completes("cleft run ${WORK}/scene.toml --set boundary.top.u" "boundary.top.ux= boundary.top.uy=")
completes("cleft check ${WORK}/sc" "${WORK}/scene.toml")
