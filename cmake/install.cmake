# Installs the headers, a package that `find_package(arenite)` finds and a file for pkg-config, as the component `library`.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/arenite)
set(src_dir ${CMAKE_INSTALL_DATADIR}/arenite/src)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/arenite DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/ DESTINATION ${src_dir} COMPONENT library)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/THIRD_PARTY.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT library)
install(TARGETS arenite EXPORT arenite-targets)
install(EXPORT arenite-targets NAMESPACE arenite:: DESTINATION ${package_dir} COMPONENT library)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/arenite-config.cmake.in ${PROJECT_BINARY_DIR}/arenite-config.cmake
                              INSTALL_DESTINATION ${package_dir} PATH_VARS src_dir CMAKE_INSTALL_INCLUDEDIR)
set(compatibility SameMajorVersion)
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(compatibility SameMinorVersion)  # before 1.0 a minor version may break what came before it
endif()
write_basic_package_version_file(${PROJECT_BINARY_DIR}/arenite-config-version.cmake
                                 COMPATIBILITY ${compatibility} ARCH_INDEPENDENT)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/compiled.cmake ${PROJECT_SOURCE_DIR}/cmake/hdf5.cmake ${PROJECT_SOURCE_DIR}/cmake/mpi.cmake
              ${PROJECT_BINARY_DIR}/arenite-config.cmake ${PROJECT_BINARY_DIR}/arenite-config-version.cmake
        DESTINATION ${package_dir} COMPONENT library)

# Headers alone suit any architecture: share/pkgconfig, not lib.
set(pkgconfig_dir ${CMAKE_INSTALL_DATADIR}/pkgconfig)
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig
           OUTPUT_VARIABLE prefix_from_pkgconfig)
set(pkgconfig_includedir \${prefix}/${CMAKE_INSTALL_INCLUDEDIR})
if(IS_ABSOLUTE ${CMAKE_INSTALL_INCLUDEDIR})
  set(pkgconfig_includedir ${CMAKE_INSTALL_INCLUDEDIR})
endif()
configure_file(${PROJECT_SOURCE_DIR}/cmake/arenite.pc.in ${PROJECT_BINARY_DIR}/arenite.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/arenite.pc DESTINATION ${pkgconfig_dir} COMPONENT library)
