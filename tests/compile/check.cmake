# cmake -D snippet=FILE -P check.cmake -- COMPILER FLAGS...
# The snippet's first line says what must happen: `// must compile`, or `// must print: SENTENCE`, in which case the
# compiler must refuse the snippet and print the sentence. A second line `// compile with: FLAGS` adds flags; then the
# sentence must be the first error.
set(command)
set(after_dashes FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(after_dashes)
    list(APPEND command "${CMAKE_ARGV${i}}")
  elseif(CMAKE_ARGV${i} STREQUAL "--")
    set(after_dashes TRUE)
  endif()
endforeach()

# Not file(STRINGS): brackets and semicolons are CMake's own in a list, and plain text in a sentence.
file(READ ${snippet} text)
string(REGEX MATCH "^[^\n]*" first_line "${text}")
set(flags)
if(text MATCHES "^[^\n]*\n// compile with: ([^\n]*)")
  separate_arguments(flags UNIX_COMMAND "${CMAKE_MATCH_1}")
endif()

# Assembly to nowhere, not -fsyntax-only: templates must be instantiated as in any program.
execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${command} -O0 ${flags} -S -o /dev/null ${snippet}
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)

function(fail sentence)
  message("${output}")  # unwrapped, as the compiler wrote it
  message(FATAL_ERROR "${snippet} ${sentence}")
endfunction()

if(first_line STREQUAL "// must compile")
  if(NOT result EQUAL 0)
    fail("must compile, but does not")
  endif()
elseif(first_line MATCHES "^// must print: (.+)$")
  set(sentence "${CMAKE_MATCH_1}")
  string(FIND "${output}" "${sentence}" place)
  if(result EQUAL 0)
    fail("must be refused, but compiles; it should print: ${sentence}")
  elseif(place EQUAL -1)
    fail("is refused, as it must be, but does not print: ${sentence}")
  endif()
  string(FIND "${output}" "error" first)
  if(flags AND first LESS place)
    string(SUBSTRING "${output}" ${first} ${place} between)
    if(between MATCHES "^[^\n]*\n")
      string(LENGTH "${CMAKE_MATCH_0}" line)
      math(EXPR end "${first} + ${line}")
      if(end LESS place)
        fail("is refused, as it must be, but the first error is another than: ${sentence}")
      endif()
    endif()
  endif()
else()
  fail("must begin with the line `// must compile` or `// must print: SENTENCE`")
endif()
