# Installs the library and builds and runs a program that finds it as a package.
# cmake -D root= -D scratch= -D build= -D version= -D compiler= -D generator= -D flags= -P consumer.cmake
cmake_minimum_required(VERSION 3.25)

function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}${errors}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${scratch}")
step(${CMAKE_COMMAND} --install "${build}" --prefix "${scratch}/prefix")
step(${CMAKE_COMMAND} -G "${generator}" -S "${root}/tests/structure/consumer" -B "${scratch}/build"
  -D "CMAKE_CXX_COMPILER=${compiler}" -D CMAKE_CXX_COMPILER_WORKS=1 -D "CMAKE_CXX_FLAGS=${flags}"
  -D "CMAKE_PREFIX_PATH=${scratch}/prefix")
step(${CMAKE_COMMAND} --build "${scratch}/build")
step("${scratch}/build/consumer")
if(NOT output STREQUAL "radcert ${version}\n")
  message(FATAL_ERROR "the program printed: ${output}")
endif()
