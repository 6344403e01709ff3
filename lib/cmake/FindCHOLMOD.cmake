# CHOLMOD::CHOLMOD. SuiteSparse 7 brings a CMake package, which is preferred; Debian 12's 5.12 has none.
#   CHOLMOD_FOUND, CHOLMOD_VERSION, target CHOLMOD::CHOLMOD
find_package(CHOLMOD CONFIG QUIET)
if(TARGET SuiteSparse::CHOLMOD)
  if(NOT TARGET CHOLMOD::CHOLMOD)
    add_library(CHOLMOD::CHOLMOD INTERFACE IMPORTED)
    target_link_libraries(CHOLMOD::CHOLMOD INTERFACE SuiteSparse::CHOLMOD)
  endif()
  set(CHOLMOD_FOUND TRUE)
  return()
endif()

find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
find_library(CHOLMOD_CONFIG_LIBRARY suitesparseconfig)
if(CHOLMOD_INCLUDE_DIR AND EXISTS "${CHOLMOD_INCLUDE_DIR}/cholmod_core.h")
  file(STRINGS "${CHOLMOD_INCLUDE_DIR}/cholmod_core.h" lines
       REGEX "#define CHOLMOD_(MAIN|SUB|SUBSUB)_VERSION +[0-9]+")
  string(REGEX REPLACE "[^0-9]*([0-9]+)[^0-9]*([0-9]+)[^0-9]*([0-9]+).*" "\\1.\\2.\\3" CHOLMOD_VERSION "${lines}")
endif()
# The system's chosen BLAS, by its run-time name, which is there without a -dev package. It is linked by name so that it
# stands before the ATLAS that Debian's Ceres drags into every program, and that is 1.35 times slower.
find_library(CHOLMOD_BLAS_LIBRARY NAMES libblas.so.3 blas)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY CHOLMOD_CONFIG_LIBRARY CHOLMOD_BLAS_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CHOLMOD
  REQUIRED_VARS CHOLMOD_LIBRARY CHOLMOD_CONFIG_LIBRARY CHOLMOD_INCLUDE_DIR
  VERSION_VAR CHOLMOD_VERSION
  REASON_FAILURE_MESSAGE "CHOLMOD solves the equilibria: install SuiteSparse (Debian: libsuitesparse-dev)")
if(CHOLMOD_FOUND AND NOT TARGET CHOLMOD::CHOLMOD)
  add_library(CHOLMOD::CHOLMOD UNKNOWN IMPORTED)
  set_target_properties(CHOLMOD::CHOLMOD PROPERTIES
    IMPORTED_LOCATION "${CHOLMOD_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${CHOLMOD_INCLUDE_DIR}"
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${CHOLMOD_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${CHOLMOD_CONFIG_LIBRARY}")
  if(CHOLMOD_BLAS_LIBRARY)
    set_property(TARGET CHOLMOD::CHOLMOD APPEND PROPERTY INTERFACE_LINK_LIBRARIES
                 "-Wl,--push-state,--no-as-needed,${CHOLMOD_BLAS_LIBRARY},--pop-state")
  endif()
endif()
