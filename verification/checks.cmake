# radcert_checks(<target> EXCEPT <folder>...)
#
# Gives the target the sources of all papers, claims/<key>/**.cpp but those in the folders named, what they share, claims/*.cpp, and the
# definition of radcert::verification::all_checks():
# every function
#   Finding <label>(const Bench& bench) {
# at the start of a line of such a source, in the namespace radcert::verification::<key>, is the check of the claim <label> of
# that paper. A paper with a file second_route.h has a function of that name as well. A new check is a new function, and nothing
# else has to name it.
function(radcert_checks target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "EXCEPT")
  set(folder "${CMAKE_CURRENT_SOURCE_DIR}/claims")
  file(GLOB papers CONFIGURE_DEPENDS RELATIVE "${folder}" "${folder}/*")
  list(SORT papers COMPARE STRING)
  file(GLOB shared CONFIGURE_DEPENDS "${folder}/*.cpp")
  list(SORT shared COMPARE STRING)
  target_sources(${target} PRIVATE ${shared})
  set(declarations)
  set(entries)
  foreach(paper IN LISTS papers)
    if(NOT IS_DIRECTORY "${folder}/${paper}")
      continue()
    endif()
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${folder}/${paper}/*.cpp")
    foreach(other IN LISTS arg_EXCEPT)
      list(FILTER sources EXCLUDE REGEX "^${folder}/${other}/")
    endforeach()
    list(SORT sources COMPARE STRING)
    target_sources(${target} PRIVATE ${sources})
    set(labels)
    foreach(source IN LISTS sources)
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
      file(STRINGS "${source}" lines REGEX "^Finding [a-z0-9_]+\\(const Bench&.*{")
      foreach(line IN LISTS lines)
        string(REGEX REPLACE "^Finding ([a-z0-9_]+)\\(.*" "\\1" label "${line}")
        list(APPEND labels "${label}")
      endforeach()
    endforeach()
    list(SORT labels COMPARE STRING)
    set(checks)
    string(APPEND declarations "namespace ${paper} {\n")
    foreach(label IN LISTS labels)
      string(APPEND declarations "Finding ${label}(const Bench& bench);\n")
      string(APPEND checks "{\"${label}\", ${paper}::${label}},\n")
    endforeach()
    set(route nullptr)
    if(EXISTS "${folder}/${paper}/second_route.h")
      string(APPEND declarations
        "Approximation second_route(const Bench& bench, const Problem& problem, int level, const std::string& figure);\n")
      set(route "${paper}::second_route")
    endif()
    string(APPEND declarations "}  // namespace ${paper}\n")
    string(APPEND entries "{.key = \"${paper}\", .checks = {${checks}}, .second_route = ${route}},\n")
  endforeach()
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/all_checks.cpp" @ONLY CONTENT [[
#include "verification/framework/check.h"

namespace radcert::verification {
@declarations@
std::vector<PaperChecks> all_checks() {
  return {@entries@};
}
}  // namespace radcert::verification
]])
  target_sources(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/all_checks.cpp")
endfunction()
