# The example for Octave or for Julia, run where that is.
# cmake -D language=octave|julia -D examples= -D library= -D header= -D scratch= -P languages.cmake
cmake_minimum_required(VERSION 3.25)

get_filename_component(folder "${library}" DIRECTORY)
set(ENV{LD_LIBRARY_PATH} "${folder}")
file(REMOVE_RECURSE "${scratch}")
file(MAKE_DIRECTORY "${scratch}")
file(COPY "${examples}/reference.m" "${examples}/reference_mex.c" "${examples}/reference.jl" DESTINATION "${scratch}")

# Runs a command in the scratch folder, and looks for a pattern in what it prints.
function(run pattern)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${scratch}" RESULT_VARIABLE code OUTPUT_VARIABLE output
    ERROR_VARIABLE errors)
  if(NOT code EQUAL 0 OR NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "${ARGN}\n${output}${errors}")
  endif()
endfunction()

if(language STREQUAL "octave")
  find_program(OCTAVE NAMES octave-cli octave)
  find_program(MKOCTFILE mkoctfile)
  if(NOT OCTAVE OR NOT MKOCTFILE)
    message(STATUS "Octave with mkoctfile is not here: its example was not run")
    return()
  endif()
  run("" "${MKOCTFILE}" --mex reference_mex.c "-I${header}" "-L${folder}" -lradcert_c)
  run("0\\.43260647644112[67] \\+- [0-9.]+e-1[67], guaranteed: 1\n[^\n]*half_turns: \"2\" is not allowed"
    "${OCTAVE}" --norc --no-history --quiet reference.m)
  run("^0\\.19982489569838[67]\nradcert:arguments: [^\n]*a name, and for each[^\n]*\nradcert:arguments: [^\n]*argument 1\
 is no text\nradcert:arguments: [^\n]*\nradcert:error: [^\n]*\"no_such_name\" is unknown[^\n]*\n1\n"
    "${OCTAVE}" --norc --no-history --quiet "${CMAKE_CURRENT_LIST_DIR}/octave_test.m")
else()
  find_program(JULIA julia)
  if(NOT JULIA)
    message(STATUS "Julia is not here: its example was not run")
    return()
  endif()
  set(ENV{RADCERT_C} "${library}")
  run("0.19982489.*one group sees itself: (1.0|0.99)" "${JULIA}" --startup-file=no reference.jl)
endif()
