# Script: "Files touched" of a page names the files that the page makes, no more and no less.
#   PAGE, FILES (those it makes, separated by |), SOURCE_DIR
#
# Studies are input, not files of a component. What is listed beyond the page's own blocks is either a file that nodal
# has, or one of the page's sources in another folder.
cmake_minimum_required(VERSION 3.25)
file(STRINGS "${PAGE}" bullets ENCODING UTF-8 REGEX "^- `[^`]+`: ")
set(listed "")
foreach(bullet IN LISTS bullets)
  string(REGEX REPLACE "^- `([^`]+)`: .*$" "\\1" name "${bullet}")
  list(APPEND listed "${name}")
endforeach()

string(REPLACE "|" ";" made "${FILES}")
list(FILTER made EXCLUDE REGEX "\\.toml$")
set(sources "")
foreach(file IN LISTS made)
  if(NOT file IN_LIST listed)
    message(FATAL_ERROR "${PAGE} makes '${file}', but doesn't list it under \"Files touched\"")
  endif()
  get_filename_component(source "${file}" NAME)
  list(APPEND sources "${source}")
endforeach()
foreach(file IN LISTS listed)
  get_filename_component(source "${file}" NAME)
  if(NOT file IN_LIST made AND NOT EXISTS "${SOURCE_DIR}/${file}" AND NOT source IN_LIST sources)
    message(FATAL_ERROR "${PAGE} lists '${file}' under \"Files touched\", but doesn't make it")
  endif()
endforeach()
if(listed STREQUAL "")
  message(FATAL_ERROR "${PAGE} lists no files")
endif()
