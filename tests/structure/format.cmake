# Every source is laid out as .clang-format says. To mend: clang-format -i <file>.
# cmake -D root=<checkout> -D clang_format=<program> -P format.cmake
cmake_minimum_required(VERSION 3.25)

set(patterns)
foreach(part IN ITEMS lib verification apps tests)
  list(APPEND patterns "${root}/${part}/*.h" "${root}/${part}/*.cpp")
endforeach()
file(GLOB_RECURSE files ${patterns})
execute_process(COMMAND "${clang_format}" --dry-run -Werror ${files} RESULT_VARIABLE result ERROR_VARIABLE errors)
if(NOT result EQUAL 0)
  string(REGEX MATCHALL "[^\n]*:[0-9]+:[0-9]+: error" places "${errors}")
  list(TRANSFORM places REPLACE ":[0-9]+:[0-9]+: error" "")
  list(REMOVE_DUPLICATES places)
  list(JOIN places "\n  " places)
  message(FATAL_ERROR "not as .clang-format says:\n  ${places}")
endif()
