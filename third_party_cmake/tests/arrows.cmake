# cmake -DWORK=<scratch folder> -P arrows.cmake
# Configures projects that declare one library each: forbidden arrows must be refused by name, allowed ones pass.

cmake_minimum_required(VERSION 3.25)

function(configure name depends)
  file(REMOVE_RECURSE ${WORK})
  execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/arrow -B ${WORK} -DNAME=${name} "-DDEPENDS=${depends}"
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")  # messages are wrapped
  set(result ${result} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_refused name depends message)
  configure(${name} "${depends}")
  string(FIND "${output}" "${message}" at)
  if(result EQUAL 0 OR at EQUAL -1)
    message(FATAL_ERROR "${name} with ${depends}: exit code ${result} where '${message}' was expected:\n${output}")
  endif()
endfunction()

function(expect_accepted name depends)
  configure(${name} "${depends}")
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${name} with ${depends} was refused:\n${output}")
  endif()
endfunction()

expect_refused(support geometry "support must not depend on geometry")                           # upward
expect_refused(contact "support;constitutive" "contact must not depend on constitutive")         # sideways
expect_refused(constitutive geometry "constitutive must not depend on geometry")
expect_refused(assembly "support;assembly" "assembly must not depend on assembly")               # itself
expect_refused(assembly scene "assembly must not depend on scene")
expect_refused(scene spline "scene must not depend on spline")
expect_refused(spline support "spline is not one of the libraries")
expect_accepted(contact "support;geometry;enrichment")
expect_accepted(support "")
