# Installs the module alone and imports it from there.
# cmake -D build= -D prefix= -D folder= -D python= -P installed.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${prefix}")
execute_process(COMMAND ${CMAKE_COMMAND} --install "${build}" --component python --prefix "${prefix}"
  COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env "PYTHONPATH=${prefix}/${folder}" "${python}" -B -c
    "import radcert, sys; sys.exit(not radcert.__file__.startswith('${prefix}') or not radcert.reference('cube_opposite_faces'))"
  COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE others "${prefix}/*")
list(FILTER others EXCLUDE REGEX "/radcert/[^/]+$")
if(others)
  message(FATAL_ERROR "the component python has more than the package: ${others}")
endif()
