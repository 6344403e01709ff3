# Script: does what a page tells to do with a program, and looks whether what it promises is there.
#   PAGE          the page
#   FOLDER        where its files were written; the working folder
#   NAME, PROGRAM commands that begin with this name are run with this program
#
# Each command has to end with 0; every line of a text block after it has to occur in what it prints; every
# `results/…` that the page names has to be there in the end.
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/page.cmake")

# Runs a line of the page, and appends what it prints to `printed`.
macro(run_line line)
  separate_arguments(words UNIX_COMMAND "${line}")
  list(POP_FRONT words)
  execute_process(COMMAND "${PROGRAM}" ${words} WORKING_DIRECTORY "${FOLDER}"
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "'${line}' ended with ${result}\n${output}\n${errors}")
  endif()
  string(APPEND printed "${output}")
  math(EXPR commands_run "${commands_run} + 1")
endmacro()

file(REMOVE_RECURSE "${FOLDER}/results")
nodal_read_page("${PAGE}" block)
math(EXPR last "${block_COUNT} - 1")
set(commands_run 0)
set(printed "")
foreach(i RANGE ${last})
  set(text "${block_${i}_TEXT}")
  if(block_${i}_LANGUAGE STREQUAL "sh")
    set(printed "")
  endif()
  while(NOT text STREQUAL "")
    take_line(text line)
    if(block_${i}_LANGUAGE STREQUAL "sh" AND line MATCHES "^${NAME} ")
      run_line("${line}")
    elseif(block_${i}_LANGUAGE STREQUAL "text" AND NOT printed STREQUAL "")
      string(FIND "${printed}" "${line}\n" position)
      if(position EQUAL -1)
        message(FATAL_ERROR "'${NAME}' does not print\n${line}\nbut\n${printed}")
      endif()
    endif()
  endwhile()
endforeach()
if(commands_run EQUAL 0)
  message(FATAL_ERROR "${PAGE} has no command of '${NAME}'")
endif()

file(READ "${PAGE}" text)
string(REGEX MATCHALL "`results/[^`\n]+`" promised "${text}")
foreach(file IN LISTS promised)
  string(REPLACE "`" "" file "${file}")
  if(NOT EXISTS "${FOLDER}/${file}")
    message(FATAL_ERROR "${PAGE} promises ${file}, but it is not there")
  endif()
endforeach()
