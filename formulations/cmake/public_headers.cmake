# Installs headers in their folders below include/desmo. For each concept NAME, adds a header
# <desmo/NAME.h> that includes the headers NAME_h.

set(mechanism_h cases/mechanism/mechanism.h cases/mechanism/builder.h)
set(scene_h cases/mechanism/motion.h cases/mechanism/scene.h)
set(files_h cases/io/files.h)
set(cases_h cases/generators/cases.h cases/library/library.h)
set(model_h formulations/model/model.h formulations/modelling/modelling.h
  formulations/modelling/measures/measures.h formulations/model/plan.h)
set(settings_h formulations/base/settings.h)
set(summary_h formulations/base/summary.h)
set(observer_h formulations/base/observer.h)
set(formulation_h formulations/formulation.h formulations/variants.h formulations/id.h)
set(checked_run_h formulations/verification/run/checked_run.h)
set(certificate_h formulations/verification/certificate/certificate.h)
set(live_run_h formulations/verification/run/live_run.h)
set(range_h formulations/verification/range/driver_range.h)
set(generated_code_h formulations/runtime/generated_code.h)
set(reference_h formulations/verification/condition.h formulations/verification/error.h
  formulations/verification/reference/reference.h)
# Further headers, which the ones above include.
set(installed_headers cases/io/input_error.h cases/io/units.h cases/mechanism/level.h
  cases/numbers/derived.h formulations/base/live_row.h formulations/base/output.h
  formulations/base/per_level.h formulations/base/reference_instant.h
  formulations/model/misfit.h formulations/model/scales.h
  formulations/verification/branch/followed_step.h formulations/verification/branch/start.h
  formulations/verification/range/range_limits.h formulations/verification/run/check_options.h
  formulations/verification/run/table_lock.h)

set(include_directory ${CMAKE_INSTALL_INCLUDEDIR}/desmo)
foreach(name mechanism scene files cases model settings summary observer formulation
    checked_run certificate live_run range generated_code reference)
  list(APPEND installed_headers ${${name}_h})
  list(JOIN ${name}_h "\"\n#include \"" includes)
  set(header ${PROJECT_BINARY_DIR}/include/desmo/${name}.h)
  file(CONFIGURE OUTPUT ${header} CONTENT "#pragma once\n\n#include \"${includes}\"\n" @ONLY)
  install(FILES ${header} DESTINATION ${include_directory})
endforeach()
foreach(header IN LISTS installed_headers)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${include_directory}/${folder})
endforeach()
