# The target `consumer`, as a user would have it who asks more of the compiler than we do: our headers must not show in its warnings.
add_executable(consumer ${CMAKE_CURRENT_LIST_DIR}/consumer.cpp)
target_link_libraries(consumer PRIVATE arenite::arenite)
target_compile_options(consumer PRIVATE -Wall -Wextra -Wconversion -Wold-style-cast -Werror)
