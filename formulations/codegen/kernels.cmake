# Generated kernels, a library for each set (see equations/kernel_sets.h), linked by programs alone:
# nothing else waits for them.
set(kernel_files "")
foreach(set cases library)
  foreach(kind kernels explicit_kernels lane_kernels)
    list(APPEND kernel_files ${CMAKE_CURRENT_BINARY_DIR}/${set}_${kind}.cpp)
  endforeach()
endforeach()
set(other_coordinates ${CMAKE_CURRENT_BINARY_DIR}/coordinates_kernels.cpp
  ${CMAKE_CURRENT_BINARY_DIR}/coordinates_explicit_kernels.cpp)
add_custom_command(OUTPUT ${kernel_files}
  COMMAND desmo_generate ${CMAKE_CURRENT_BINARY_DIR} natural DEPENDS desmo_generate
  COMMENT "Generating symbolic equations, eliminations and explicit orders" VERBATIM)
add_custom_command(OUTPUT ${other_coordinates}
  COMMAND desmo_generate ${CMAKE_CURRENT_BINARY_DIR} others DEPENDS desmo_generate
  COMMENT "Generating likewise, in other coordinates" VERBATIM)
add_custom_target(desmo_generated DEPENDS ${kernel_files})

check_cxx_compiler_flag(-march=x86-64-v4 DESMO_HAS_X86_64_V4)
if(DESMO_HAS_X86_64_V3 AND DESMO_HAS_X86_64_V4 AND NOT DESMO_SANITIZE)
  set(wide_lanes ON)
  add_compile_definitions(DESMO_WIDE_LANES)
endif()

# Options for straight-line code: no errno after a square root, no traps, and no pairing of
# neighbouring operations, as registers are full. Results stay those of IEEE arithmetic.
set(straight_line -fno-math-errno -fno-trapping-math -fno-tree-slp-vectorize)

# desmo_kernel_set(SET): the library of a set's kernels, for registers of 256 bits and, where there
# is code for them, of 512 bits.
function(desmo_kernel_set set)
  set(start ${CMAKE_CURRENT_BINARY_DIR}/${set})
  set(straight ${start}_explicit_kernels.cpp ${start}_lane_kernels.cpp)
  set_source_files_properties(${straight} PROPERTIES COMPILE_OPTIONS "${straight_line}")
  desmo_library(${set}_kernels NO_HEADERS FILES ${start}_kernels.cpp ${straight})
  add_dependencies(desmo_${set}_kernels desmo_generated)
  if(DESMO_SANITIZE)  # not for generated code: only its results are tested
    target_compile_options(desmo_${set}_kernels PRIVATE -fno-sanitize=all -Og -g0)
  endif()
  if(NOT wide_lanes)
    return()
  endif()
  # The same kernels for registers of 512 bits, which some processors lack that run all other code.
  # They may contain no copy of an inline function, which a test checks: the linker keeps any one of
  # the copies, and all code might then call the one for 512 bits. Without a red zone, spilled
  # registers are at multiples of 64 bytes from the stack pointer, which takes shorter instructions:
  # a tenth less code.
  set(wide desmo_wide_${set}_kernels)
  add_library(${wide} OBJECT ${start}_lane_kernels.cpp)
  add_dependencies(${wide} desmo_generated)
  target_compile_definitions(${wide} PRIVATE DESMO_LANES=8)
  target_compile_options(${wide} PRIVATE -march=x86-64-v4 -mno-red-zone -fno-exceptions
    -Wno-uninitialized -Wno-maybe-uninitialized)  # intrinsics of GCC 12 read such values on purpose
  target_sources(desmo_${set}_kernels PRIVATE $<TARGET_OBJECTS:${wide}>)
endfunction()
desmo_kernel_set(cases)
desmo_kernel_set(library)

# Scalar kernels of the cases in other coordinates, for programs that compare coordinates.
add_library(desmo_coordinates_kernels STATIC EXCLUDE_FROM_ALL ${other_coordinates})
set_source_files_properties(${other_coordinates} PROPERTIES COMPILE_OPTIONS "${straight_line}")
target_link_libraries(desmo_coordinates_kernels PUBLIC desmo_formulations_core)
