# The libraries of cleft, lowest first, and for each the libraries that it may use directly. An arrow that is not in
# this table is refused: by `cleft_library` when a library declares it, and by the test `build.Includes.FollowTheDeclaredArrows` when an #include draws it.

set(CLEFT_LIBRARIES
  support geometry enrichment constitutive contact assembly solve problem growth results scene simulation tangent_check plot convergence objectivity report)

set(CLEFT_ALLOWED_support "")
set(CLEFT_ALLOWED_geometry support)
set(CLEFT_ALLOWED_enrichment support geometry)
set(CLEFT_ALLOWED_constitutive support)
set(CLEFT_ALLOWED_contact support geometry enrichment)
set(CLEFT_ALLOWED_assembly support geometry enrichment constitutive contact)
set(CLEFT_ALLOWED_solve support geometry enrichment constitutive contact assembly)
set(CLEFT_ALLOWED_problem support geometry enrichment constitutive contact assembly solve)
set(CLEFT_ALLOWED_growth support geometry enrichment constitutive contact assembly solve problem)
set(CLEFT_ALLOWED_results support geometry enrichment constitutive contact assembly solve growth)
set(CLEFT_ALLOWED_scene support geometry constitutive contact solve problem)
set(CLEFT_ALLOWED_simulation support geometry enrichment constitutive contact assembly solve problem growth results scene)
set(CLEFT_ALLOWED_tangent_check support geometry enrichment constitutive contact assembly solve problem growth results)
set(CLEFT_ALLOWED_plot support)
set(CLEFT_ALLOWED_convergence support problem results scene simulation plot)
set(CLEFT_ALLOWED_objectivity support geometry contact solve problem scene simulation plot convergence)
set(CLEFT_ALLOWED_report support problem scene results plot)

# Stops the configuration unless library `name` may depend directly on each library that follows.
function(cleft_check_arrows name)
  if(NOT name IN_LIST CLEFT_LIBRARIES)
    message(FATAL_ERROR "cleft_library: ${name} is not one of the libraries: ${CLEFT_LIBRARIES}")
  endif()
  foreach(dependency IN LISTS ARGN)
    if(NOT dependency IN_LIST CLEFT_ALLOWED_${name})
      message(FATAL_ERROR "cleft_library: ${name} must not depend on ${dependency}; allowed: ${CLEFT_ALLOWED_${name}}")
    endif()
  endforeach()
endfunction()
