# SPQR::SPQR, SuiteSparse's rank-revealing sparse QR. SuiteSparse 7 brings a CMake package, which is preferred; Debian
# 12's 5.12 has none. Needs CHOLMOD::CHOLMOD.
#   SPQR_FOUND, target SPQR::SPQR
find_package(SPQR CONFIG QUIET)
if(TARGET SuiteSparse::SPQR)
  if(NOT TARGET SPQR::SPQR)
    add_library(SPQR::SPQR INTERFACE IMPORTED)
    target_link_libraries(SPQR::SPQR INTERFACE SuiteSparse::SPQR CHOLMOD::CHOLMOD)
  endif()
  set(SPQR_FOUND TRUE)
  return()
endif()

find_path(SPQR_INCLUDE_DIR SuiteSparseQR_C.h PATH_SUFFIXES suitesparse)
find_library(SPQR_LIBRARY spqr)
mark_as_advanced(SPQR_INCLUDE_DIR SPQR_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SPQR
  REQUIRED_VARS SPQR_LIBRARY SPQR_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "SPQR finds mechanisms: install SuiteSparse (Debian: libsuitesparse-dev)")
if(SPQR_FOUND AND NOT TARGET SPQR::SPQR)
  add_library(SPQR::SPQR UNKNOWN IMPORTED)
  set_target_properties(SPQR::SPQR PROPERTIES
    IMPORTED_LOCATION "${SPQR_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${SPQR_INCLUDE_DIR}"
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${SPQR_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES CHOLMOD::CHOLMOD)
endif()
