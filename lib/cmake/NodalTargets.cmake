# How targets are made here: nodal_add_library for a library, nodal_add_component for a problem or an optimizer.

# Warnings and sanitizers of our own targets; nothing of it reaches users of the libraries.
function(nodal_set_defaults target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                                           $<$<BOOL:${NODAL_WERROR}>:-Werror>)
  # A product and a sum are fused where the code says so, not where a compiler likes: equal code, equal bits.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)  # false alarms on std::string (GCC bug 105651)
  endif()
  if(NODAL_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${NODAL_SANITIZE} -fno-omit-frame-pointer
                                             -fno-sanitize-recover=undefined)
    # Calls and casts to a wrong type the code has no occasion for, and a pointer that wraps or leaves its object AddressSanitizer
    # finds where it is used. These four cost a good part of the time to compile, five sixths of the lane kernels'.
    target_compile_options(${target} PRIVATE
                           $<$<CXX_COMPILER_ID:Clang>:-fno-sanitize=function,vptr,pointer-overflow,object-size>)
    target_link_options(${target} PUBLIC -fsanitize=${NODAL_SANITIZE})
  endif()
endfunction()

# nodal_precompile(<target> <name> [<library>] HEADERS …): the headers, of the library where they are no standard ones, are
# precompiled once for all targets that name <name>; these must be compiled with the same options. Nothing is done without
# NODAL_PRECOMPILE.
function(nodal_precompile target name)
  if(NOT NODAL_PRECOMPILE)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 2 ARG "" "" "HEADERS")
  set(owner nodal_precompiled_${name})
  if(NOT TARGET ${owner})
    set(source "${CMAKE_CURRENT_BINARY_DIR}/${owner}.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "// Nothing: CMake precompiles headers beside a source.\n")
    add_library(${owner} OBJECT "${source}")
    nodal_set_defaults(${owner})
    get_target_property(options ${target} COMPILE_OPTIONS)
    get_target_property(independent ${target} POSITION_INDEPENDENT_CODE)
    set_target_properties(${owner} PROPERTIES COMPILE_OPTIONS "${options}" POSITION_INDEPENDENT_CODE ${independent})
    target_link_libraries(${owner} PRIVATE ${ARG_UNPARSED_ARGUMENTS})
    target_precompile_headers(${owner} PRIVATE ${ARG_HEADERS})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${owner})
endfunction()

# nodal_add_library(<name> SOURCES … [HEADERS …] [PUBLIC lib …] [PRIVATE lib …])
# Makes the static library nodal_<name>, alias and exported name nodal::<name>. HEADERS are public, below include/; each
# is verified to compile alone.
function(nodal_add_library name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;HEADERS;PUBLIC;PRIVATE")
  set(target nodal_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(nodal::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  nodal_set_defaults(${target})
  if(NODAL_FUZZ)
    # A fuzzer is guided by what is run of the libraries; of the programs it needn't know.
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    target_link_options(${target} PUBLIC -fsanitize=fuzzer-no-link)
  endif()
  nodal_precompile(${target} library HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <fstream> <functional>
                   <map> <memory> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <vector>)
  if(ARG_HEADERS)
    target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${ARG_HEADERS})
    set_target_properties(${target} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
  endif()
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/src" "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  set_property(GLOBAL APPEND PROPERTY NODAL_INSTALLED_TARGETS ${target})
endfunction()

# nodal_add_component(<folder name> SOURCES … [NAMESPACE …] [HEADERS …] [PUBLIC …] [PRIVATE …])
# A library whose `void <namespace>::register_<folder name>(nodal::Registry&)` the program calls. One of SOURCES defines
# it. The namespace is nodal where none is given: what is not nodal's own has one of its own.
function(nodal_add_component name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "NAMESPACE" "SOURCES;HEADERS;PUBLIC;PRIVATE")
  if(NOT ARG_NAMESPACE)
    set(ARG_NAMESPACE nodal)
  endif()
  nodal_add_library(${name} SOURCES ${ARG_SOURCES} HEADERS ${ARG_HEADERS}
                            PUBLIC nodal::nodal ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  set_property(GLOBAL APPEND PROPERTY NODAL_COMPONENTS ${name})
  set_property(GLOBAL PROPERTY NODAL_NAMESPACE_OF_${name} ${ARG_NAMESPACE})
endfunction()

# nodal_add_benchmarks(<component> SOURCES … [PRIVATE lib …])
# Micro-benchmarks of a component that nodal_microbench runs: the objects nodal_<component>_benchmarks.
function(nodal_add_benchmarks component)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;PRIVATE")
  set(target nodal_${component}_benchmarks)
  add_library(${target} OBJECT ${ARG_SOURCES})
  nodal_set_defaults(${target})
  target_link_libraries(${target} PUBLIC nodal::${component} nodal::components benchmark::benchmark ${ARG_PRIVATE})
  set_property(GLOBAL APPEND PROPERTY NODAL_BENCHMARKS ${target})
endfunction()

# Sets <declarations>, <calls> and <libraries> to what registers the components that are named after them.
function(nodal_registering declarations calls libraries)
  set(declared "")
  set(called "")
  set(linked "")
  foreach(component IN LISTS ARGN)
    get_property(namespace GLOBAL PROPERTY NODAL_NAMESPACE_OF_${component})
    string(APPEND declared "namespace ${namespace} {\nvoid register_${component}(nodal::Registry&);\n}\n")
    string(APPEND called "  ${namespace}::register_${component}(registry);\n")
    list(APPEND linked nodal::${component})
  endforeach()
  set(${declarations} "${declared}" PARENT_SCOPE)
  set(${calls} "${called}" PARENT_SCOPE)
  set(${libraries} "${linked}" PARENT_SCOPE)
endfunction()

# Writes register_components(Registry&), which calls every component's register function, into nodal::components.
function(nodal_collect_components)
  get_property(components GLOBAL PROPERTY NODAL_COMPONENTS)
  nodal_registering(declarations calls libraries ${components})
  set(generated "${CMAKE_CURRENT_BINARY_DIR}/generated")
  file(CONFIGURE OUTPUT "${generated}/components.cpp" @ONLY CONTENT
"// Generated by nodal_collect_components from the components of this build.
#include <nodal/components.h>

@declarations@
void nodal::register_components(nodal::Registry& registry) {
@calls@}
")
  file(CONFIGURE OUTPUT "${generated}/include/nodal/components.h" @ONLY CONTENT
"// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Registers every problem and optimizer of this build.

#include <nodal/registry.h>

namespace nodal {
void register_components(Registry& registry);
}  // namespace nodal
")
  add_library(nodal_components STATIC "${generated}/components.cpp")
  add_library(nodal::components ALIAS nodal_components)
  set_target_properties(nodal_components PROPERTIES EXPORT_NAME components POSITION_INDEPENDENT_CODE ON)
  nodal_set_defaults(nodal_components)
  target_sources(nodal_components PUBLIC FILE_SET HEADERS BASE_DIRS "${generated}/include"
                                         FILES "${generated}/include/nodal/components.h")
  set_target_properties(nodal_components PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
  target_link_libraries(nodal_components PUBLIC nodal::nodal PRIVATE ${libraries})
  set_property(GLOBAL APPEND PROPERTY NODAL_INSTALLED_TARGETS nodal_components)
endfunction()
