# Where pip builds the package, Eigen may be one of its build requirements, cmeel-eigen, instead of the system's.
find_package(Python COMPONENTS Interpreter REQUIRED)
execute_process(COMMAND ${Python_EXECUTABLE} -c
                        "import importlib.metadata as m; print(m.distribution('cmeel-eigen').locate_file('cmeel.prefix'))"
                OUTPUT_VARIABLE eigen_prefix OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(eigen_prefix)
  list(APPEND CMAKE_PREFIX_PATH ${eigen_prefix})
endif()
