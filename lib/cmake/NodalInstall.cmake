# Install and export: find_package(nodal) gives nodal::nodal, the components, nodal::command_line.
include(CMakePackageConfigHelpers)

get_property(targets GLOBAL PROPERTY NODAL_INSTALLED_TARGETS)
install(TARGETS ${targets} EXPORT nodalTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS nodal RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/nodal)
install(EXPORT nodalTargets NAMESPACE nodal:: DESTINATION ${package_dir})
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/nodalConfig.cmake.in" nodalConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(nodalConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/nodalConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/nodalConfigVersion.cmake"
              "${CMAKE_CURRENT_LIST_DIR}/FindCHOLMOD.cmake" "${CMAKE_CURRENT_LIST_DIR}/FindSPQR.cmake"
        DESTINATION ${package_dir})
install(DIRECTORY bench/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/nodal)
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
