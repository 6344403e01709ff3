# What a build can be asked for. Every option is prefixed NODAL_.
include(GNUInstallDirs)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()

set(NODAL_NLOPT AUTO CACHE STRING "NLopt's optimizers: AUTO (when found), ON (required) or OFF")
set(NODAL_CERES AUTO CACHE STRING "Ceres' optimizers: AUTO (when found), ON (required) or OFF")
set(NODAL_CGAL AUTO CACHE STRING "Triangulations and Voronoi regions by CGAL: AUTO (when found), ON (required) or OFF")
set_property(CACHE NODAL_NLOPT NODAL_CERES NODAL_CGAL PROPERTY STRINGS AUTO ON OFF)
option(NODAL_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(NODAL_MICRO "Build the micro-benchmarks (Google Benchmark)" ${PROJECT_IS_TOP_LEVEL})
option(NODAL_WERROR "Treat warnings as errors" OFF)
set(NODAL_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. address,undefined")
option(NODAL_PRECOMPILE "Precompile the standard headers: faster without a cache, but hides a source's missing includes" OFF)
option(NODAL_TESTS_BY_PROGRAM "Each test program is one CTest test, or a few: sooner done, less is told apart" OFF)
option(NODAL_UNITY_TESTS "Compile a test program's sources ten at a time: a whole build is faster, one changed test is slower" OFF)
option(NODAL_FUZZ "Instrument for libFuzzer, and build the harnesses of tests/fuzz (Clang only)" OFF)

if(NODAL_FUZZ AND NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "NODAL_FUZZ needs libFuzzer, which comes with Clang: configure with "
                      "-DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_C_COMPILER=clang-14 in a new folder")
endif()
