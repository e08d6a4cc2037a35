# Makes the packages of the build tree `build` (that of the driver where the driver is built) with `cpack` in the folder `packages`, and
# checks with `dpkg_deb` what they say and hold.
cmake_minimum_required(VERSION 3.21)
file(REMOVE_RECURSE ${packages})
include(${build}/CPackConfig.cmake)

# check(COMPONENT FILE FIELDS HELD): FILE was made of COMPONENT; each of FIELDS stands among its fields, each of HELD among its files.
# Expressions, as CMake has them.
function(check component file fields held)
  execute_process(COMMAND ${cpack} -G DEB -C ${config} --config ${build}/CPackConfig.cmake -B ${packages} -D CPACK_COMPONENTS_ALL=${component}
                  COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
  file(GLOB made ${packages}/${file})
  execute_process(COMMAND ${dpkg_deb} --field ${made} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${dpkg_deb} --contents ${made} OUTPUT_VARIABLE contents COMMAND_ERROR_IS_FATAL ANY)
  foreach(field IN LISTS fields)
    if(NOT "\n${said}" MATCHES "\n${field}\n")
      message(FATAL_ERROR "${made}: no field ${field} in\n${said}")
    endif()
  endforeach()
  foreach(path IN LISTS held)
    if(NOT contents MATCHES " \\./usr/${path}\n")
      message(FATAL_ERROR "${made} has no ${path}; it has\n${contents}")
    endif()
  endforeach()
endfunction()

string(REPLACE "." "\\." dotted "${version}")
check(library libarenite-dev_${version}_all.deb
      "Package: libarenite-dev;Version: ${dotted};Architecture: all;Depends: libeigen3-dev \\(>= 3\\.4\\)"
      "include/arenite/arenite\\.hpp;share/cmake/arenite/arenite-config\\.cmake;share/pkgconfig/arenite\\.pc;share/arenite/src/cold/cold\\.cpp")
if("driver" IN_LIST CPACK_COMPONENTS_ALL AND EXISTS ${build}/examples/ffp/arenite-ffp)
  check(driver arenite-ffp_${version}_*.deb "Package: arenite-ffp;Version: ${dotted};Depends: [^\n]*libstdc[^\n]*"
        "bin/arenite-ffp;share/arenite/ffp/plot\\.py")
endif()
