# Tests that need Python with the packages of requirements.txt, of two kinds:
# - tests/<folder>/*_meshio.cpp reads what make_meshes.py of its folder wrote; ARENITE_TEST_MESHES names where;
# - tests/<folder>/check_<name>.py runs after the test <folder>.<name>, with that test's working folder as its
#   argument, and checks the files that the test wrote there.
# Without ARENITE_TEST_PYTHON they are left out.
function(arenite_python_tests folder)
  file(GLOB readers CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/${folder} ${folder}/*_meshio.cpp)
  if(readers)
    if(ARENITE_TEST_PYTHON)
      set(meshes ${CMAKE_CURRENT_BINARY_DIR}/meshes/${folder})
      add_test(NAME ${folder}.make_meshes
               COMMAND ${ARENITE_TEST_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/make_meshes.py ${meshes})
      set_tests_properties(${folder}.make_meshes PROPERTIES LABELS ${folder} FIXTURES_SETUP ${folder}.meshes TIMEOUT 120)
    endif()
    foreach(reader IN LISTS readers)
      get_filename_component(name ${reader} NAME_WE)
      set_property(TEST ${folder}.${name} APPEND PROPERTY ENVIRONMENT "ARENITE_TEST_MESHES=${meshes}")
      set_tests_properties(${folder}.${name} PROPERTIES FIXTURES_REQUIRED ${folder}.meshes)
      if(NOT ARENITE_TEST_PYTHON)
        set_tests_properties(${folder}.${name} PROPERTIES DISABLED TRUE)
      endif()
    endforeach()
  endif()

  file(GLOB checks CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/${folder} ${folder}/check_*.py)
  foreach(check IN LISTS checks)
    string(REGEX REPLACE "^check_(.*)\\.py$" "\\1" name ${check})
    if(NOT ARENITE_TEST_PYTHON)
      continue()
    elseif(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${name}.cpp AND NOT TEST ${folder}.${name})
      continue()  # left out
    elseif(NOT TEST ${folder}.${name})
      message(FATAL_ERROR "tests/${folder}/${check} checks what tests/${folder}/${name}.cpp writes, and there is no such file")
    endif()
    set_tests_properties(${folder}.${name} PROPERTIES FIXTURES_SETUP ${folder}.${name}.files)
    add_test(NAME ${folder}.check_${name} COMMAND ${ARENITE_TEST_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${check}
                                                  ${CMAKE_CURRENT_BINARY_DIR}/scratch/${folder}.${name})
    set_tests_properties(${folder}.check_${name} PROPERTIES LABELS ${folder} FIXTURES_REQUIRED ${folder}.${name}.files TIMEOUT 120)
  endforeach()
endfunction()

arenite_python_tests(io)
arenite_python_tests(observe)
