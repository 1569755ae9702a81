# Writes the public headers: each is some headers of the project, in the order of their includes,
# with the private ones that they need and no public header before it has.
#
#   cmake -DSOURCE=<project> -DOUTPUT=<folder> -P public_headers.cmake
#
# An include of what another public header has becomes one of that header; one of a hidden header
# is left out.

cmake_minimum_required(VERSION 3.25)

set(public
  mechanism scene files cases model settings summary observer formulation assessment certificate live_run range
  generated_code reference)
set(scene_h cases/mechanism/motion.h cases/mechanism/scene.h)
set(mechanism_h cases/mechanism/mechanism.h cases/mechanism/builder.h)
set(files_h cases/io/files.h)
set(cases_h cases/generators/cases.h cases/library/library.h)
set(model_h formulations/model/model.h formulations/modelling/modelling.h formulations/planning/plan.h)
set(settings_h formulations/base/settings.h)
set(summary_h formulations/base/summary.h)
set(observer_h formulations/base/observer.h)
set(formulation_h formulations/formulation.h formulations/variants.h formulations/id.h)
set(assessment_h formulations/verification/monitor/monitored_run.h)
set(certificate_h formulations/verification/certificate/certificate.h)
set(live_run_h formulations/verification/monitor/live_run.h)
set(range_h formulations/verification/range/driver_range.h)
set(generated_code_h formulations/runtime/own_kernels.h)
set(reference_h formulations/verification/condition.h formulations/verification/error.h
  formulations/verification/reference/reference.h)
# Headers of what users do not see: public ones name it at most.
set(hidden
  formulations/base/part.h formulations/constraints/constraints.h formulations/parts/profile.h
  formulations/equations/kernel_table.h formulations/structure/defined_part.h formulations/structure/partition.h)

file(REMOVE_RECURSE ${OUTPUT}/desmo)
foreach(name IN LISTS public)
  foreach(header IN LISTS ${name}_h)
    set_property(GLOBAL PROPERTY "owner ${header}" ${name})
  endforeach()
endforeach()

# Appends a header to the text of a public one, after what it includes.
function(append_header header name)
  if(header IN_LIST hidden)
    return()
  endif()
  get_property(owner GLOBAL PROPERTY "owner ${header}")
  if(owner AND NOT owner STREQUAL name)
    set_property(GLOBAL APPEND PROPERTY "includes ${name}" ${owner})
    return()
  endif()
  get_property(done GLOBAL PROPERTY "done ${header}")
  if(done)
    return()
  endif()
  set_property(GLOBAL PROPERTY "done ${header}" TRUE)
  set_property(GLOBAL PROPERTY "owner ${header}" ${name})
  file(READ ${SOURCE}/${header} text)
  string(REGEX MATCHALL "#include \"[^\"]+\"" includes "${text}")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "#include \"(.*)\"" "\\1" include "${include}")
    append_header(${include} ${name})
  endforeach()
  string(REGEX REPLACE "#include \"[^\"]+\"\n" "" text "${text}")
  string(REPLACE "#pragma once\n" "" text "${text}")
  set_property(GLOBAL APPEND_STRING PROPERTY "text ${name}" "${text}\n")
endfunction()

foreach(name IN LISTS public)
  foreach(header IN LISTS ${name}_h)
    append_header(${header} ${name})
  endforeach()
  get_property(includes GLOBAL PROPERTY "includes ${name}")
  list(REMOVE_DUPLICATES includes)
  list(SORT includes)
  set(text "#pragma once\n\n")
  foreach(include IN LISTS includes)
    string(APPEND text "#include \"desmo/${include}.h\"\n")
  endforeach()
  get_property(body GLOBAL PROPERTY "text ${name}")
  string(REGEX REPLACE "\n\n\n+" "\n\n" body "${body}")
  file(CONFIGURE OUTPUT ${OUTPUT}/desmo/${name}.h CONTENT "${text}${body}" @ONLY)
endforeach()
