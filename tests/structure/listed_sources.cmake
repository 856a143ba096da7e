# A source that no layer lists is not built, and nobody would notice.
# cmake -D root=<checkout> -D layers=<a,b,...> -D listed=<file with a built source a line> -P listed_sources.cmake
cmake_minimum_required(VERSION 3.25)

string(REPLACE "," ";" layers "${layers}")
file(GLOB folders RELATIVE "${root}/lib/radcert" "${root}/lib/radcert/*")
# Beside the layers: the header that names their stable part.
list(REMOVE_ITEM folders all.h)
foreach(folder IN LISTS folders)
  if(NOT folder IN_LIST layers)
    message(SEND_ERROR "lib/radcert/${folder} is no layer of lib/CMakeLists.txt")
  endif()
endforeach()

file(STRINGS "${listed}" built)
file(GLOB_RECURSE sources "${root}/lib/radcert/*.cpp")
foreach(source IN LISTS sources)
  if(NOT source IN_LIST built)
    message(SEND_ERROR "${source} is in no SOURCES of lib/CMakeLists.txt")
  endif()
endforeach()
