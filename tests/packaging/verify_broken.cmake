# Script: the project SOURCE builds, but the verification of its public header fails at that header.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${BUILD}")
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${SOURCE}" -B "${BUILD}" -G "${GENERATOR}"
                        "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
                        "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DNODAL_CMAKE_DIR=${NODAL_CMAKE_DIR}"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${BUILD}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${BUILD}" --target all_verify_interface_header_sets
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(result EQUAL 0)
  message(FATAL_ERROR "a public header that lacks an include passed")
endif()
if(NOT output MATCHES "broken\\.h:[0-9:]+ error")
  message(FATAL_ERROR "the verification failed, but not at the broken header:\n${output}")
endif()
