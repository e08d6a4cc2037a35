# What of the driver knows no scene: options, shapes, files and their words, the reduction of records. Compiled once for programs of all
# widths of registers, and for tests/ffp.
if(TARGET arenite_ffp_parts)
  return()
endif()
file(GLOB parts CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*/*.cpp)
list(FILTER parts EXCLUDE REGEX "/(drop/drop_[a-z]+|drop/error_bar|push/push_[a-z_]+|paper/paper|reduce/reduce|ranks/main|launch/main).cpp$")
add_library(arenite_ffp_parts OBJECT ${parts})
set_target_properties(arenite_ffp_parts PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 15)
target_compile_definitions(arenite_ffp_parts PRIVATE ARENITE_FFP_SOURCE="${CMAKE_CURRENT_LIST_DIR}/scripts")
target_link_libraries(arenite_ffp_parts PUBLIC arenite_developer nlohmann_json::nlohmann_json)
target_compile_options(arenite_ffp_parts PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O1>)  # options and tables: no hurry
