# cmake -D snippet=FILE -D library=HEADER -P check.cmake -- COMPILER FLAGS...
# HEADER includes the library, and was compiled beforehand with the same command.
# The snippet's first line says what must happen:
#   // must compile
#   // must print: SENTENCE        the compiler refuses the snippet, and its first error holds the sentence
#   // must point here, with: WORD  it refuses it, its first error points into the snippet, and it prints the word
# Further lines of the head: `// errors: N`, exactly so many; `// compile with: FLAGS`, added to the command.
include(${CMAKE_CURRENT_LIST_DIR}/command.cmake)

# Not file(STRINGS): brackets and semicolons are CMake's own in a list, and plain text in a sentence.
file(READ ${snippet} text)
string(REGEX MATCH "^[^\n]*" first_line "${text}")
set(flags)
if(text MATCHES "\n// compile with: ([^\n]*)")
  separate_arguments(flags UNIX_COMMAND "${CMAKE_MATCH_1}")  # others than those of the precompiled header
elseif(text MATCHES "^(//[^\n]*\n)*#include <arenite/arenite.hpp>\n")
  set(flags -include ${library})
endif()

# Assembly to nowhere, not -fsyntax-only: templates must be instantiated as in any program.
execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${command} ${flags} -S -o /dev/null ${snippet}
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)

function(fail sentence)
  message("${output}")  # unwrapped, as the compiler wrote it
  message(FATAL_ERROR "${snippet} ${sentence}")
endfunction()

if(first_line STREQUAL "// must compile")
  if(NOT result EQUAL 0)
    fail("must compile, but does not")
  endif()
elseif(result EQUAL 0)
  fail("must be refused, but compiles: ${first_line}")
else()
  # The line of the first error, and how many there are.
  string(REGEX MATCH "[^\n]*[: ]error: [^\n]*" first_error "${output}")
  string(REGEX MATCHALL "[: ]error: " errors "${output}")
  list(LENGTH errors count)
  if(first_line MATCHES "^// must print: (.+)$")
    set(sentence "${CMAKE_MATCH_1}")
    string(FIND "${first_error}" "${sentence}" place)
    if(place EQUAL -1)
      fail("is refused, as it must be, but the first error is another than: ${sentence}")
    endif()
  elseif(first_line MATCHES "^// must point here, with: (.+)$")
    set(word "${CMAKE_MATCH_1}")
    string(FIND "${first_error}" "${snippet}" place)
    if(NOT place EQUAL 0)
      fail("is refused, as it must be, but the first error does not point into it")
    endif()
    string(FIND "${output}" "${word}" place)
    if(place EQUAL -1)
      fail("is refused, as it must be, but the compiler does not print: ${word}")
    endif()
  else()
    fail("must begin with `// must compile`, `// must print: SENTENCE` or `// must point here, with: WORD`")
  endif()
  if(text MATCHES "\n// errors: ([0-9]+)\n" AND NOT count EQUAL CMAKE_MATCH_1)
    fail("is refused, as it must be, but with ${count} errors for ${CMAKE_MATCH_1}")
  endif()
endif()
