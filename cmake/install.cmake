# Installs the headers and a package that `find_package(arenite)` finds.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/arenite)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/arenite DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/compositions DESTINATION ${CMAKE_INSTALL_DATADIR}/arenite)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(TARGETS arenite EXPORT arenite-targets)
install(EXPORT arenite-targets NAMESPACE arenite:: DESTINATION ${package_dir})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/arenite-config.cmake.in
                              ${PROJECT_BINARY_DIR}/arenite-config.cmake INSTALL_DESTINATION ${package_dir})
# Before 1.0 a minor version may break what came before it.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/arenite-config-version.cmake
                                 COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/compositions.cmake ${PROJECT_SOURCE_DIR}/cmake/hdf5.cmake
              ${PROJECT_BINARY_DIR}/arenite-config.cmake ${PROJECT_BINARY_DIR}/arenite-config-version.cmake
        DESTINATION ${package_dir})
