# What generated kernels include, as text in the program, and a digest of all that decides about the
# text of such kernels.
set(DESMO_EMBEDDED_TEXTS "")
set(DESMO_HEADER_TABLE "")
foreach(header IN ITEMS cases/mechanism/level.h formulations/constraints/table.h
    formulations/equations/kernel.h
    formulations/equations/explicit_kernel.h formulations/equations/lane_kernel.h
    formulations/equations/kernel_library.h formulations/equations/elementary.h
    formulations/equations/turned_angle.h formulations/equations/lanes.h)
  get_filename_component(name ${header} NAME_WE)
  desmo_embed(${name}_header ${PROJECT_SOURCE_DIR}/${header})
  string(APPEND DESMO_HEADER_TABLE "    {${name}_header, sizeof ${name}_header},\n")
endforeach()

file(GLOB_RECURSE decisive CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/formulations/constraints/*.h
  ${PROJECT_SOURCE_DIR}/cases/mechanism/level.h
  ${PROJECT_SOURCE_DIR}/formulations/equations/*.h
  ${PROJECT_SOURCE_DIR}/formulations/codegen/*/*.h ${PROJECT_SOURCE_DIR}/formulations/codegen/*/*.cpp
  ${PROJECT_SOURCE_DIR}/formulations/model/part_type.*)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${decisive})
set(digests "")
foreach(source IN LISTS decisive)
  file(SHA256 ${source} digest)
  string(APPEND digests ${digest})
endforeach()
string(SHA256 DESMO_GENERATOR_DIGEST "${digests}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/kernel_headers.cpp.in
  ${CMAKE_CURRENT_BINARY_DIR}/kernel_headers.cpp @ONLY)
