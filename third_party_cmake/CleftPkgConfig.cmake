# cleft.pc for pkg-config, made from the targets that find_package(cleft) has.

# -lNAME for the file of a library, with its folder unless every linker looks there; other files as they are.
function(cleft_link_flags path out)
  get_filename_component(folder ${path} DIRECTORY)
  get_filename_component(name ${path} NAME)
  set(flags ${path})
  if(name MATCHES "^lib(.+)\\.(a|so)[.0-9]*$")
    set(flags -l${CMAKE_MATCH_1})
    if(NOT folder IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES)
      list(PREPEND flags -L${folder})
    endif()
  endif()
  set(${out} ${flags} PARENT_SCOPE)
endfunction()

# The file of an imported target, in whatever configuration there is one; empty if there is none.
function(cleft_location target out)
  get_target_property(configurations ${target} IMPORTED_CONFIGURATIONS)
  set(location "")
  foreach(property IN ITEMS "" ${configurations})
    string(JOIN "_" property IMPORTED_LOCATION ${property})
    get_target_property(value ${target} ${property})
    if(value)
      set(location ${value})
    endif()
  endforeach()
  set(${out} "${location}" PARENT_SCOPE)
endfunction()

# Adds what an imported target, and all below it, asks of the linker to the global property CLEFT_PC_LIBS, and if the
# headers of cleft use it its folders of headers to CLEFT_PC_CFLAGS. Shared libraries know themselves what they need.
function(cleft_collect_imported target in_headers)
  cleft_location(${target} location)
  if(location)
    cleft_link_flags(${location} flags)
    set_property(GLOBAL APPEND PROPERTY CLEFT_PC_LIBS ${flags})
  endif()
  get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
  if(in_headers AND folders)
    list(TRANSFORM folders PREPEND -I)
    set_property(GLOBAL APPEND PROPERTY CLEFT_PC_CFLAGS ${folders})
  endif()
  get_target_property(type ${target} TYPE)
  get_target_property(below ${target} INTERFACE_LINK_LIBRARIES)
  if(below AND NOT type STREQUAL SHARED_LIBRARY)
    cleft_collect(${in_headers} ${below})
  endif()
endfunction()

# What INTERFACE_LINK_LIBRARIES may hold: targets, files, flags and names. Other libraries of cleft are passed over.
function(cleft_collect in_headers)
  foreach(item IN LISTS ARGN)
    set(headers ${in_headers})
    if(item MATCHES "LINK_ONLY:(.*)>$")
      set(item ${CMAKE_MATCH_1})
      set(headers FALSE)
    endif()
    if(item MATCHES "^cleft::" OR item MATCHES "\\$<")
      continue()
    elseif(TARGET ${item})
      cleft_collect_imported(${item} ${headers})
    elseif(IS_ABSOLUTE ${item})
      cleft_link_flags(${item} flags)
      set_property(GLOBAL APPEND PROPERTY CLEFT_PC_LIBS ${flags})
    elseif(item MATCHES "^-")
      set_property(GLOBAL APPEND PROPERTY CLEFT_PC_LIBS ${item})
    else()
      set_property(GLOBAL APPEND PROPERTY CLEFT_PC_LIBS -l${item})
    endif()
  endforeach()
endfunction()

# Static libraries: whoever uses another stands before it.
set(own "")
get_property(exported GLOBAL PROPERTY CLEFT_EXPORTED)
foreach(library IN LISTS exported)
  get_target_property(type cleft_${library} TYPE)
  if(type STREQUAL STATIC_LIBRARY)
    list(PREPEND own -lcleft_${library})
  endif()
  get_target_property(below cleft_${library} INTERFACE_LINK_LIBRARIES)
  cleft_collect(TRUE ${below})
endforeach()
foreach(kind libs cflags)
  string(TOUPPER ${kind} property)
  get_property(${kind} GLOBAL PROPERTY CLEFT_PC_${property})
  list(REVERSE ${kind})  # what several need stands behind the last of them
  list(REMOVE_DUPLICATES ${kind})
  list(REVERSE ${kind})
  list(JOIN ${kind} " " ${kind})
endforeach()
list(JOIN own " " own)

set(folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH up /${folder} /)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/cleft.pc @ONLY CONTENT [[
prefix=${pcfiledir}/@up@
Name: @PROJECT_NAME@
Description: @PROJECT_DESCRIPTION@
Version: @PROJECT_VERSION@
Cflags: -std=c++20 -I${prefix}/@CMAKE_INSTALL_INCLUDEDIR@ @cflags@
Libs: -L${prefix}/@CMAKE_INSTALL_LIBDIR@ @own@ @libs@
]])
install(FILES ${PROJECT_BINARY_DIR}/cleft.pc DESTINATION ${folder})
