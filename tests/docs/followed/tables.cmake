# Follows the page about adding to the tables of the elastic problem: what it adds, and its lists with the rows of the page,
# are linked ahead of the archive, whose own lists nobody asks for then.
set(layout_page "${PROJECT_SOURCE_DIR}/docs/adding_a_layout.md")
set(layout_folder "${pages}/layout")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${layout_page}")
nodal_write_page("${layout_page}" "${layout_folder}" layout_files)
set(sources ${layout_files} ${layout_files_CHANGED})
list(FILTER sources INCLUDE REGEX "\\.cpp$")
list(GET sources 0 first_source)
if(EXISTS "${PROJECT_SOURCE_DIR}/${first_source}")
  return()  # somebody has followed the page by hand: what is added is tested like any other
endif()

set(lists ${layout_files_CHANGED})
list(TRANSFORM lists PREPEND "${PROJECT_SOURCE_DIR}/" OUTPUT_VARIABLE lists_here)
list(TRANSFORM lists PREPEND "${layout_folder}/" OUTPUT_VARIABLE lists_with_rows)
add_custom_command(OUTPUT ${lists_with_rows}
                   COMMAND ${CMAKE_COMMAND} "-DPAGE=${layout_page}" "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}"
                           "-DFOLDER=${layout_folder}" -P "${here}/change_files.cmake"
                   DEPENDS "${layout_page}" ${lists_here} "${here}/change_files.cmake" "${here}/page.cmake" VERBATIM)

list(TRANSFORM sources PREPEND "${layout_folder}/")
add_library(rows_of_page OBJECT ${sources})
nodal_set_defaults(rows_of_page)
target_include_directories(rows_of_page PRIVATE "${PROJECT_SOURCE_DIR}/problems/elastic/src")
target_link_libraries(rows_of_page PRIVATE nodal::elastic fmt::fmt)

# The program as it would be.
add_executable(nodal_with_rows "${PROJECT_SOURCE_DIR}/bench/nodal.cpp" $<TARGET_OBJECTS:rows_of_page>)
nodal_set_defaults(nodal_with_rows)
target_link_libraries(nodal_with_rows PRIVATE nodal::command_line nodal::components nodal::elastic fmt::fmt)
follow(AddingALayout "${layout_page}" "${layout_folder}" nodal_with_rows ${layout_files} ${layout_files_CHANGED})

# The tests of tables as they would be: the same objects, more listed.
get_target_property(libraries elastic_test LINK_LIBRARIES)
add_executable(elastic_test_with_rows $<TARGET_OBJECTS:elastic_test> $<TARGET_OBJECTS:rows_of_page>)
set_target_properties(elastic_test_with_rows PROPERTIES LINKER_LANGUAGE CXX)
nodal_set_defaults(elastic_test_with_rows)
target_link_libraries(elastic_test_with_rows PRIVATE ${libraries})
gtest_discover_tests(elastic_test_with_rows TEST_PREFIX AddingALayout. NO_PRETTY_VALUES DISCOVERY_MODE PRE_TEST
                     TEST_FILTER Tables.*:Formats.* PROPERTIES TIMEOUT 60)

# What is refused names what the page adds.
function(refused name says)
  add_test(NAME AddingALayout.${name} COMMAND nodal_with_rows ${ARGN} WORKING_DIRECTORY "${layout_folder}")
  set_tests_properties(AddingALayout.${name} PROPERTIES PASS_REGULAR_EXPRESSION "${says}" TIMEOUT 60)
endfunction()
file(WRITE "${layout_folder}/misspelt.toml" "[problem]\nkind = \"elastic\"\npoints = { layout = \"sunflowr\" }\n")
file(WRITE "${layout_folder}/foreign.toml" "[problem]\nkind = \"elastic\"\nsprings = { reach = 1 }\n")
refused(AMisspeltLayoutIsToldOfTheNewOne "did you mean 'sunflower'" evaluate misspelt.toml)
refused(AnOptionOfTheNewTopologyBelongsToIt "'reach' belongs to topology 'within', and this one is 'crossed'" evaluate
        foreign.toml)
refused(AnUnknownEndingIsToldOfTheNewFormat "doesn't end in .json or .csv; what is fitted is written as JSON or CSV of the springs"
        fit sunflower.toml --export fitted.obj)
