# Where pip builds the package, Eigen and nlohmann-json may be build requirements, cmeel-eigen and nlohmann-json, instead of the
# system's. The second has headers alone: `nlohmann_json_headers` is their folder.
find_package(Python COMPONENTS Interpreter REQUIRED)
function(arenite_folder_of_pip variable package folder)
  execute_process(COMMAND ${Python_EXECUTABLE} -c "import importlib.metadata as m; print(m.distribution('${package}').locate_file('${folder}'))"
                  OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  set(${variable} "${found}" PARENT_SCOPE)
endfunction()
arenite_folder_of_pip(eigen_prefix cmeel-eigen cmeel.prefix)
if(eigen_prefix)
  list(APPEND CMAKE_PREFIX_PATH ${eigen_prefix})
endif()
arenite_folder_of_pip(nlohmann_json_headers nlohmann-json nlohmann_json/include)
