# The configuration stops at a layer that uses, or includes, what is not declared above it and named, and at one that
# names what it does not include.
# cmake -D root=<checkout> -D scratch=<folder> -D compiler=<c++> -D generator=<name> -P layers.cmake

# Configures a project with the declarations `lines` and a header of layer `layer` that holds `include`, and
# expects `expected` in the complaint, or no complaint at all when that is empty.
function(configure_project name lines layer include expected)
  set(folder "${scratch}/${name}")
  file(WRITE "${folder}/CMakeLists.txt"
    "cmake_minimum_required(VERSION 3.25)\nproject(layers LANGUAGES CXX)\n"
    "include(\"${root}/lib/cmake/layers.cmake\")\n${lines}\n")
  foreach(each IN ITEMS low beside)
    file(WRITE "${folder}/radcert/${each}/${each}.h" "#pragma once\n")
  endforeach()
  file(WRITE "${folder}/radcert/middle/middle.h" "#pragma once\n#include \"radcert/low/low.h\"\n")
  file(WRITE "${folder}/radcert/high/high.h" "#pragma once\n#include \"radcert/middle/middle.h\"\n")
  file(WRITE "${folder}/radcert/${layer}/probe.h" "#pragma once\n\n#include ${include}\n")
  execute_process(
    COMMAND ${CMAKE_COMMAND} -G "${generator}" -S "${folder}" -B "${folder}/build" -D "CMAKE_CXX_COMPILER=${compiler}"
      -D CMAKE_CXX_COMPILER_WORKS=1 -D CMAKE_CXX_ABI_COMPILED=1
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  if(expected STREQUAL "")
    if(NOT result EQUAL 0)
      message(FATAL_ERROR "${name}: refused, though it is right: ${output}")
    endif()
  elseif(result EQUAL 0)
    message(FATAL_ERROR "${name}: configured, though it is wrong")
  else()
    string(FIND "${output}" "${expected}" position)
    if(position EQUAL -1)
      message(FATAL_ERROR "${name}: expected \"${expected}\" in: ${output}")
    endif()
  endif()
endfunction()

file(REMOVE_RECURSE "${scratch}")
set(tower "radcert_layer(low)\nradcert_layer(middle USES low)\nradcert_layer(beside)\nradcert_layer(high USES middle)")

configure_project(right "${tower}" high "\"radcert/middle/middle.h\"" "")
configure_project(includes_through_another "${tower}" high "\"radcert/low/low.h\"" "of layer low")
configure_project(names_what_it_does_not_include "radcert_layer(low)\nradcert_layer(beside USES low)" low "<cmath>"
  "radcert_layer(beside): USES low, but no file includes it")
configure_project(includes_later "${tower}" low "\"radcert/high/high.h\""
  "radcert/low/probe.h:3: layer low includes \"radcert/high/high.h\" of layer high")
configure_project(includes_later_in_brackets "${tower}" low "<radcert/high/high.h>" "of layer high")
configure_project(includes_unnamed "${tower}" high "\"radcert/beside/beside.h\"" "of layer beside")
configure_project(climbs "${tower}" high "\"../beside/beside.h\"" "write #include \"radcert/<layer>/<file>.h\"")
configure_project(uses_later "radcert_layer(low USES high)\nradcert_layer(high)" low "<cmath>"
  "radcert_layer(low): uses high, which is not declared above it")
configure_project(beyond_its_bound "${tower}\nradcert_layer(oracle UP_TO low USES middle)" low "<cmath>"
  "radcert_layer(oracle): uses middle, but may see nothing after low")
