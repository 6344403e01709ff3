# Script: compiles every public header alone, in the build BUILD_DIR, and looks whether none was left out: neither one that
# is installed in PREFIX, nor one that stands below an include/nodal of SOURCE_DIR.
cmake_minimum_required(VERSION 3.25)
set(config "")
if(CONFIG)
  set(config --config "${CONFIG}")
endif()
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${BUILD_DIR}" ${config} --target all_verify_interface_header_sets
                COMMAND_ERROR_IS_FATAL ANY)

# CMake compiles each header by a source of its own: …_verify_interface_header_sets/nodal/meter.h.cxx.
file(GLOB_RECURSE sources RELATIVE "${BUILD_DIR}" "${BUILD_DIR}/*.h.cxx")
list(FILTER sources INCLUDE REGEX "^[^.]*_verify_interface_header_sets/")
list(TRANSFORM sources REPLACE "^.*_verify_interface_header_sets/(.*)\\.cxx$" "\\1" OUTPUT_VARIABLE verified)

file(GLOB_RECURSE installed RELATIVE "${PREFIX}/include" "${PREFIX}/include/*.h")
set(missing ${installed})
list(REMOVE_ITEM missing ${verified})
if(missing OR NOT installed)
  message(FATAL_ERROR "installed, but not compiled alone: ${missing} (of ${installed})")
endif()
foreach(folder IN ITEMS lib problems optimizers bench)
  file(GLOB_RECURSE headers "${SOURCE_DIR}/${folder}/*.h")
  list(FILTER headers INCLUDE REGEX "/include/nodal/")
  foreach(header IN LISTS headers)
    string(REGEX REPLACE "^.*/include/(nodal/.*)$" "\\1" header "${header}")
    if(NOT header IN_LIST installed)
      message(FATAL_ERROR "${header} is a public header, but no library names it among its HEADERS")
    endif()
  endforeach()
endforeach()
list(LENGTH installed count)
message(STATUS "${count} public headers compile alone")
