# The examples for Octave and Julia, run where these are.
# cmake -D examples= -D library= -D header= -D scratch= -P languages.cmake
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

set(absent)
find_program(OCTAVE NAMES octave-cli octave)
find_program(MKOCTFILE mkoctfile)
if(OCTAVE AND MKOCTFILE)
  run("" "${MKOCTFILE}" --mex reference_mex.c "-I${header}" "-L${folder}" -lradcert_c)
  run("0.4326[0-9]+ .- [^\n]*guaranteed: 1\nhalf_turns: \"2\"" "${OCTAVE}" --no-gui --quiet reference.m)
else()
  list(APPEND absent "Octave is not here")
endif()
find_program(JULIA julia)
if(JULIA)
  set(ENV{RADCERT_C} "${library}")
  run("0.19982489.*one group sees itself: (1.0|0.99)" "${JULIA}" --startup-file=no reference.jl)
else()
  list(APPEND absent "Julia is not here")
endif()
foreach(words IN LISTS absent)
  message(STATUS "${words}: its example was not run")
endforeach()
