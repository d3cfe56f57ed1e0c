# cmake -DWORK=<scratch folder> -DGENERATOR= -DCOMPILER= -DBUILD_TYPE= -DFLAGS= -P fault.cmake
# A faulty program must differ from the sound one, and a text that is missing or not unique must stop the configuration.

cmake_minimum_required(VERSION 3.25)

function(configure old new)
  file(REMOVE_RECURSE ${WORK})
  execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/fault -B ${WORK} -G ${GENERATOR} "-DOLD=${old}" "-DNEW=${new}"
      -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DCMAKE_CXX_FLAGS=${FLAGS}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(result ${result} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

foreach(old "no such text" "twice")
  configure(${old} "")
  if(result EQUAL 0 OR NOT output MATCHES "not exactly once in")
    message(FATAL_ERROR "'${old}': exit code ${result} where the configuration should have stopped:\n${output}")
  endif()
endforeach()

configure("return kAnswer" "return 1 + kAnswer")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "a text that stands in the source once was refused:\n${output}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/sound RESULT_VARIABLE sound)
execute_process(COMMAND ${WORK}/faults/cleft_fault_wrong RESULT_VARIABLE faulty)
if(NOT sound EQUAL 0 OR NOT faulty EQUAL 1)
  message(FATAL_ERROR "exit codes ${sound} and ${faulty} where 0 and 1 were expected")
endif()
