# Headers that generated kernels include, embedded as text in the program.
set(DESMO_EMBEDDED_TEXTS "")
set(DESMO_HEADER_TABLE "")
foreach(header IN ITEMS cases/mechanism/level.h formulations/constraints/table.h
    formulations/equations/kernel.h formulations/equations/explicit_kernel.h
    formulations/equations/lane_kernel.h formulations/equations/kernel_library.h
    formulations/equations/elementary.h formulations/equations/turned_angle.h
    formulations/equations/lanes.h)
  get_filename_component(name ${header} NAME_WE)
  desmo_embed(${name}_header ${PROJECT_SOURCE_DIR}/${header})
  string(APPEND DESMO_HEADER_TABLE "    {${name}_header, sizeof ${name}_header},\n")
endforeach()

configure_file(${CMAKE_CURRENT_LIST_DIR}/kernel_headers.cpp.in
  ${CMAKE_CURRENT_BINARY_DIR}/kernel_headers.cpp @ONLY)
