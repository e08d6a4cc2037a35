# What is not code and must fit it all the same: presets, recipes, packages for Debian.
add_test(NAME install.presets
         COMMAND ${CMAKE_COMMAND} -D source=${PROJECT_SOURCE_DIR} -D build=${PROJECT_BINARY_DIR} -D scratch=${CMAKE_CURRENT_BINARY_DIR}/presets
                 -D compiler=${CMAKE_CXX_COMPILER} -D Eigen3_DIR=${Eigen3_DIR} -P ${CMAKE_CURRENT_SOURCE_DIR}/presets.cmake)
add_test(NAME install.recipes
         COMMAND ${CMAKE_COMMAND} -D source=${PROJECT_SOURCE_DIR} -D version=${PROJECT_VERSION} -D scratch=${CMAKE_CURRENT_BINARY_DIR}/recipes
                 -P ${CMAKE_CURRENT_SOURCE_DIR}/recipes.cmake)
set_tests_properties(install.presets install.recipes PROPERTIES LABELS "install;change" TIMEOUT 60)

find_program(ARENITE_DPKG_DEB dpkg-deb DOC "Tests the packages for Debian, if found")
if(ARENITE_DPKG_DEB AND PROJECT_IS_TOP_LEVEL AND ARENITE_INSTALL)
  add_test(NAME install.debian
           COMMAND ${CMAKE_COMMAND} -D cpack=${CMAKE_CPACK_COMMAND} -D dpkg_deb=${ARENITE_DPKG_DEB} -D build=${PROJECT_BINARY_DIR}
                   -D config=$<CONFIG> -D version=${PROJECT_VERSION} -D packages=${CMAKE_CURRENT_BINARY_DIR}/debian
                   -P ${CMAKE_CURRENT_SOURCE_DIR}/debian.cmake)
  set_tests_properties(install.debian PROPERTIES LABELS "install;change" TIMEOUT 120)
else()
  arenite_left_out("Test of the packages for Debian" "dpkg-deb")
endif()
