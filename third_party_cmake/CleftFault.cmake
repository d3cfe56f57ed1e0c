# cleft_fault(NAME SOURCE OLD NEW)
#
# makes the program `cleft_fault_NAME`: cleft with one mistake in it, OLD replaced by NEW in the source file SOURCE (below
# libs/). The tests prove with it that such a mistake does not go unnoticed. OLD must stand in SOURCE exactly once: the
# configuration stops when the source has moved on. The directory property CLEFT_FAULTS lists the programs.
function(cleft_fault name source old new)
  set(path ${PROJECT_SOURCE_DIR}/libs/${source})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  file(READ ${path} text)
  string(FIND "${text}" "${old}" first)
  string(FIND "${text}" "${old}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "cleft_fault: ${name}: not exactly once in ${source}: ${old}")
  endif()
  string(REPLACE "${old}" "${new}" text "${text}")
  set(faulty ${CMAKE_CURRENT_BINARY_DIR}/faulty_${name}.cpp)
  file(CONFIGURE OUTPUT ${faulty} CONTENT "${text}" @ONLY)

  # The faulty object comes before the libraries, whose own is then not taken out of its archive.
  set(target cleft_fault_${name})
  add_executable(${target} ${faulty} $<TARGET_OBJECTS:cleft_verbs>)
  cleft_target_defaults(${target})
  get_filename_component(folder ${path} DIRECTORY)
  target_include_directories(${target} PRIVATE ${folder})
  target_link_libraries(${target} PRIVATE cleft_verbs)
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/faults)
  set_property(DIRECTORY APPEND PROPERTY CLEFT_FAULTS ${target})
endfunction()
