# Imported targets SuiteSparse::KLU, SuiteSparse::CXSPARSE, SuiteSparse::UMFPACK,
# SuiteSparse::CHOLMOD and SuiteSparse::SPQR, for installations of SuiteSparse that bring no CMake
# package of their own.
#   find_package(SuiteSparse COMPONENTS KLU CXSPARSE [UMFPACK] [CHOLMOD] [SPQR])

set(_suitesparse_required "")
foreach(component IN LISTS SuiteSparse_FIND_COMPONENTS)
  string(TOLOWER ${component} name)
  set(header ${name}.h)
  if(component STREQUAL CXSPARSE)
    set(header cs.h)
  elseif(component STREQUAL SPQR)
    set(header SuiteSparseQR.hpp)
  endif()
  find_path(SuiteSparse_${component}_INCLUDE_DIR ${header} PATH_SUFFIXES suitesparse)
  find_library(SuiteSparse_${component}_LIBRARY ${name})
  mark_as_advanced(SuiteSparse_${component}_INCLUDE_DIR SuiteSparse_${component}_LIBRARY)
  if(SuiteSparse_${component}_INCLUDE_DIR AND SuiteSparse_${component}_LIBRARY)
    set(SuiteSparse_${component}_FOUND TRUE)
    if(NOT TARGET SuiteSparse::${component})
      add_library(SuiteSparse::${component} UNKNOWN IMPORTED)
      set_target_properties(SuiteSparse::${component} PROPERTIES
        IMPORTED_LOCATION "${SuiteSparse_${component}_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${SuiteSparse_${component}_INCLUDE_DIR}")
    endif()
  endif()
  list(APPEND _suitesparse_required
    SuiteSparse_${component}_LIBRARY SuiteSparse_${component}_INCLUDE_DIR)
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SuiteSparse
  REQUIRED_VARS ${_suitesparse_required} HANDLE_COMPONENTS)
