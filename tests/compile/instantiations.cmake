# Counts the classes that clang++ instantiates for README's scene, which compile time follows: a count, for a time says nothing on a
# machine that does other things. Fails beyond `most`; who goes below it lowers it.
# cmake -D readme=FILE -D most=NUMBER -D folder=FOLDER -P instantiations.cmake -- COMPILER OPTIONS...
include(${CMAKE_CURRENT_LIST_DIR}/command.cmake)
file(READ ${readme} text)
string(REGEX MATCH "```cpp\n([^`]*)```" found "${text}")
file(WRITE ${folder}/scene.cpp "${CMAKE_MATCH_1}")
execute_process(COMMAND ${command} -S -emit-llvm -ftime-trace -ftime-trace-granularity=0 ${folder}/scene.cpp -o ${folder}/scene.ll
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND grep -o "\"name\":\"InstantiateClass\"" ${folder}/scene.json OUTPUT_VARIABLE events)
string(LENGTH "${events}" count)
string(LENGTH "\"name\":\"InstantiateClass\"\n" length)
math(EXPR count "${count} / ${length}")
message("${count} classes")
if(count EQUAL 0 OR count GREATER most)
  message(FATAL_ERROR "README's scene instantiates ${count} classes: must be at most ${most}, and more than none")
endif()
