# cmake -D nm=NM -D objdump=OBJDUMP -D base=OBJECT -D other=OBJECT -D program=PROGRAM -D everything=BOOL -P symbols.cmake
# Two objects of one source, `other` for a larger instruction set, and a program that has `other` before `base`. The linker keeps the first
# of what both define as weak, so `base` runs on its processor only if that is fit for it. Fails if
# - both define a function of Arenite's, other than of its exceptions, which whoever catches them must know;
# - what the program has of a function that both define holds an instruction that the base set lacks: Arenite's, and with `everything`
#   also those of the standard library and of Eigen.

# weak(OBJECT): the names of its weak symbols, as a text with each on a line, into `OBJECT_weak`.
function(weak object)
  execute_process(COMMAND ${nm} --defined-only ${${object}} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[0-9a-f]+ [WVu] [^\n]*" symbols "${text}")
  list(TRANSFORM symbols REPLACE "^[0-9a-f]+ ([WVu]) " "\\1 ")
  set(${object}_weak "${symbols}" PARENT_SCOPE)
endfunction()
weak(base)
weak(other)
if(NOT base_weak MATCHES "7arenite" OR NOT other_weak MATCHES "7arenite")
  message(FATAL_ERROR "an object defines no weak symbol of Arenite's: nothing was compared")
endif()

# The names that both have: each of one, if the list without those of the other is shorter.
set(only ${other_weak})
list(REMOVE_ITEM only ${base_weak})
set(both ${other_weak})
list(REMOVE_ITEM both ${only})
set(functions ${both})
list(FILTER functions INCLUDE REGEX "^W ")
set(wrong ${functions})
list(FILTER wrong INCLUDE REGEX "7arenite")
list(FILTER wrong EXCLUDE REGEX "^W _ZT|_ZNK?7arenite[0-9]+(run_|output_)?error|7arenite7program|7arenite4test")
if(wrong)
  list(JOIN wrong "\n  " wrong)
  message(FATAL_ERROR "both objects define functions of Arenite's:\n  ${wrong}")
endif()

list(TRANSFORM functions REPLACE "^W " "")
if(NOT everything)
  list(FILTER functions INCLUDE REGEX "7arenite")
endif()
list(LENGTH functions number)
execute_process(COMMAND ${objdump} -d --no-show-raw-insn ${program} OUTPUT_VARIABLE code COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE ";" "," code "${code}")
string(REPLACE "[" "(" code "${code}")
string(REPLACE "]" ")" code "${code}")
set(wrong)
foreach(function IN LISTS functions)
  string(FIND "${code}" "<${function}>:\n" begin)
  if(begin EQUAL -1)
    continue()
  endif()
  string(SUBSTRING "${code}" ${begin} -1 rest)
  string(FIND "${rest}" "\n\n" end)
  string(SUBSTRING "${rest}" 0 ${end} body)
  if(body MATCHES "\t(v[a-z][a-z0-9]+|andn|bextr|blsi|blsr|blsmsk|mulx|rorx|sarx|shlx|shrx|bzhi)[ \n]")  # VEX and EVEX
    string(APPEND wrong "\n  ${function}: ${CMAKE_MATCH_1}")
  endif()
endforeach()
if(wrong)
  message(FATAL_ERROR "of ${number} functions that both objects define, these hold code for a larger set:${wrong}")
endif()
message("${number} functions that both objects define: no code for a larger set")
