# When a test runs. ARENITE_TEST_SCOPE is one of these, and brings those before it:
#   quick    what tests/run.sh builds and runs where nothing is asked for: each room's core, one scene of a family, driver, Python
#   change   what a change may break: all tests of g++ but the long ones; under the sanitizers what owns memory or reads files
#   nightly  the rest: long tests, each header by itself, benchmarks, all tests under the sanitizers, the second compiler
# Each ctest test has its scope as a label.
set(ARENITE_TEST_SCOPE nightly CACHE STRING "Tests to build: quick, change (and quick) or nightly (all)")
set_property(CACHE ARENITE_TEST_SCOPE PROPERTY STRINGS quick change nightly)
set(scopes quick change nightly)
if(NOT ARENITE_TEST_SCOPE IN_LIST scopes)
  message(FATAL_ERROR "ARENITE_TEST_SCOPE=${ARENITE_TEST_SCOPE}: must be quick, change or nightly")
endif()

# arenite_in_scope(SCOPE VARIABLE): whether tests of SCOPE are asked for.
function(arenite_in_scope scope variable)
  list(FIND scopes ${scope} this)
  list(FIND scopes ${ARENITE_TEST_SCOPE} asked)
  set(${variable} FALSE PARENT_SCOPE)
  if(this LESS_EQUAL asked)
    set(${variable} TRUE PARENT_SCOPE)
  endif()
endfunction()

# Test files of tests/, without their ending, as regular expressions: the scope before that of all others of their build.
if(CMAKE_BUILD_TYPE STREQUAL "Debug")  # under the sanitizers
  set(scope_of_files change)
  set(scope_of_others nightly)
  set(files_first
      core/.* simd/.* parallel/.* fill/.* particles/.* io/.* geometry/.* mesh/.* error_bar/.* host/.* law/histories law/with_deviatoric_strain
      boundary/walls contact/exchange run/saved_state run/every rigid/free_body
      scene/insert_remove scene/own_parts shape/ugimp transfer/g2p transfer/own_channels)
else()
  set(scope_of_files quick)
  set(scope_of_others change)
  set(files_first
      core/.* simd/.* parallel/.* fill/.* shape/.* mesh/.* particles/.* geometry/.* io/.* error_bar/.* host/.* ffp/.* contact/coulomb contact/mass_gradient
      law/elastic law/mohr_coulomb law/drucker_prager law/friction law/neo_hookean law/newtonian_fluid law/sand law/histories
      boundary/walls load/loads observe/energy run/saved_state rigid/rigid_body rigid/point_contact
      physics/bar physics/column physics/conservation physics/oedometer scene/state transfer/affine transfer/conservation_.* transfer/g2p
      transfer/velocity)
endif()
list(JOIN files_first "|" files_first)

# arenite_scope_of(SOURCE VARIABLE): the scope of a test file.
function(arenite_scope_of source variable)
  string(REGEX REPLACE "\\.cpp$" "" path ${source})
  if(path MATCHES "_heavy$")
    set(${variable} nightly PARENT_SCOPE)
  elseif(path MATCHES "^(${files_first})$")
    set(${variable} ${scope_of_files} PARENT_SCOPE)
  else()
    set(${variable} ${scope_of_others} PARENT_SCOPE)
  endif()
endfunction()

# arenite_label(SCOPE TESTS..): adds the scope to the labels of tests.
function(arenite_label scope)
  foreach(test IN LISTS ARGN)
    set_property(TEST ${test} APPEND PROPERTY LABELS ${scope})
  endforeach()
endfunction()
