# Writes generated/revision.h at every build (only when it changed): revision and dirty flag of the sources, and what
# they are compiled with.
set(generated "${CMAKE_CURRENT_BINARY_DIR}/generated")
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}" flags)
if(NODAL_SANITIZE)
  string(APPEND flags " -fsanitize=${NODAL_SANITIZE}")
endif()
add_custom_target(nodal_revision
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${generated}/revision.h -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
          "-DVERSION=${PROJECT_VERSION}" "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
          "-DFLAGS=${flags}" "-DBUILD_TYPE=${CMAKE_BUILD_TYPE}" -P ${CMAKE_CURRENT_LIST_DIR}/WriteRevision.cmake
  BYPRODUCTS ${generated}/revision.h
  COMMENT "" VERBATIM)
add_dependencies(nodal_nodal nodal_revision)
target_include_directories(nodal_nodal PRIVATE ${generated})
