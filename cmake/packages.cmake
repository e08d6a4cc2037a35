# Packages for Debian: `cpack -G DEB` in the build tree makes libarenite-dev, for any architecture, of the component `library`, and
# arenite-ffp of the component `driver` where the driver is built.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_VENDOR "The Arenite authors")
set(CPACK_PACKAGE_CONTACT "The Arenite authors")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS  # whatever the umask
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL library)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libarenite-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS "libhdf5-dev, cmake (>= 3.21)")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "${PROJECT_DESCRIPTION}
Headers, package files for CMake and pkg-config, and the sources of common compositions, which a program may compile once.")

if(TARGET arenite-ffp)
  list(APPEND CPACK_COMPONENTS_ALL driver)
  set(CPACK_DEBIAN_DRIVER_PACKAGE_NAME arenite-ffp)
  set(CPACK_DEBIAN_DRIVER_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_DRIVER_PACKAGE_RECOMMENDS "python3-matplotlib, python3-numpy")  # its pictures
  find_program(dpkg_shlibdeps dpkg-shlibdeps NO_CACHE)
  if(dpkg_shlibdeps)
    set(CPACK_DEBIAN_DRIVER_PACKAGE_SHLIBDEPS ON)
  else()
    set(CPACK_DEBIAN_DRIVER_PACKAGE_DEPENDS "libc6, libstdc++6")
  endif()
  set(CPACK_COMPONENT_DRIVER_DESCRIPTION "Free-fall penetrometers in dry sand
Drops a penetrometer into sand with the material point method, and reduces measured or computed records.")
endif()

include(CPack)
