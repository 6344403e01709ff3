# Follows the pages about adding a problem and an optimizer: what they add is built against this build's libraries, held to
# the contracts, and raced by the pages' own commands.
if(TARGET nodal_decay OR TARGET nodal_compass)
  return()  # somebody has followed a page by hand: the component is tested like any other
endif()

set(problem_page "${PROJECT_SOURCE_DIR}/docs/adding_a_problem.md")
set(optimizer_page "${PROJECT_SOURCE_DIR}/docs/adding_an_optimizer.md")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${problem_page}" "${optimizer_page}")
nodal_write_page("${problem_page}" "${pages}/problem" problem_files)
nodal_write_page("${optimizer_page}" "${pages}/optimizer" optimizer_files)

# The components of the pages are no part of the program and not installed.
get_property(components GLOBAL PROPERTY NODAL_COMPONENTS)
get_property(installed GLOBAL PROPERTY NODAL_INSTALLED_TARGETS)
set(NODAL_PRECOMPILE OFF)  # they are compiled with the options of tests
add_subdirectory("${pages}/problem/problems" problems)
add_subdirectory("${pages}/optimizer/optimizers" optimizers)
get_property(all_components GLOBAL PROPERTY NODAL_COMPONENTS)
set_property(GLOBAL PROPERTY NODAL_COMPONENTS "${components}")
set_property(GLOBAL PROPERTY NODAL_INSTALLED_TARGETS "${installed}")

# In place of nodal::components: everything of this build, and what the pages add.
nodal_registering(declarations calls libraries ${all_components})
configure_file(components.cpp.in components.cpp @ONLY)
add_library(components_with_pages STATIC "${CMAKE_CURRENT_BINARY_DIR}/components.cpp")
nodal_set_defaults(components_with_pages)
target_include_directories(components_with_pages
  PUBLIC "$<TARGET_PROPERTY:nodal_components,INTERFACE_INCLUDE_DIRECTORIES>")
target_link_libraries(components_with_pages PUBLIC nodal::nodal PRIVATE ${libraries})

# The program as it would be.
add_executable(nodal_with_pages "${PROJECT_SOURCE_DIR}/bench/nodal.cpp")
nodal_set_defaults(nodal_with_pages)
target_link_libraries(nodal_with_pages PRIVATE nodal::command_line components_with_pages)

# The contract tests as they would be: the same objects, more registered.
add_executable(contracts_with_pages $<TARGET_OBJECTS:contracts_test>)
set_target_properties(contracts_with_pages PROPERTIES LINKER_LANGUAGE CXX)
nodal_set_defaults(contracts_with_pages)
target_link_libraries(contracts_with_pages PRIVATE components_with_pages nodal::nodal GTest::gtest_main)
gtest_discover_tests(contracts_with_pages TEST_PREFIX AddingAProblem. NO_PRETTY_VALUES DISCOVERY_MODE PRE_TEST
                     TEST_FILTER Registrations.*:*/decay:*EveryTrial.OnARegisteredProblem* PROPERTIES TIMEOUT 60)
gtest_discover_tests(contracts_with_pages TEST_PREFIX AddingAnOptimizer. NO_PRETTY_VALUES DISCOVERY_MODE PRE_TEST
                     TEST_FILTER */compass_search* PROPERTIES TIMEOUT 60)

follow(AddingAProblem "${problem_page}" "${pages}/problem" nodal_with_pages ${problem_files})
follow(AddingAnOptimizer "${optimizer_page}" "${pages}/optimizer" nodal_with_pages ${optimizer_files})

# For tests/packaging, which builds the programs that the pages make with an installed nodal.
set_property(GLOBAL PROPERTY NODAL_PAGES "${pages}")
