# The layers of the library and the one rule between them: a layer includes only layers declared above it, and USES
# names exactly those. The configuration stops at a layer that names a later one or one that it does not include, and at
# an #include of one that is not named.

include_guard(GLOBAL)

# radcert_layer(<name> [UP_TO <layer>] [USES <layer>...] [SOURCES <file>...] [PRIVATE <target>...])
#
#   UP_TO    the layer may name nothing declared after this one
#   USES     the layers that its files include
#   SOURCES  relative to radcert/<name>/ below the caller's folder; none: a layer of headers alone
#   PRIVATE  third-party targets, seen by the layer's own sources and by nobody else
#
# Makes the static library radcert_<name>, alias radcert::<name>. Headers are written
# #include "radcert/<name>/<file>.h" everywhere.
function(radcert_layer name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "UP_TO" "USES;SOURCES;PRIVATE")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "radcert_layer(${name}): not understood: ${arg_UNPARSED_ARGUMENTS}")
  endif()

  get_property(declared GLOBAL PROPERTY RADCERT_LAYERS)
  if(name IN_LIST declared)
    message(FATAL_ERROR "radcert_layer(${name}): declared twice")
  endif()
  set(visible ${declared})
  if(arg_UP_TO)
    list(FIND declared "${arg_UP_TO}" last)
    if(last EQUAL -1)
      message(FATAL_ERROR "radcert_layer(${name}): UP_TO names ${arg_UP_TO}, which is not declared above")
    endif()
    math(EXPR count "${last} + 1")
    list(SUBLIST declared 0 ${count} visible)
  endif()

  foreach(used IN LISTS arg_USES)
    if(NOT used IN_LIST declared)
      message(FATAL_ERROR "radcert_layer(${name}): uses ${used}, which is not declared above it; "
        "a layer may use only those declared above it and named")
    endif()
    if(NOT used IN_LIST visible)
      message(FATAL_ERROR "radcert_layer(${name}): uses ${used}, but may see nothing after ${arg_UP_TO}")
    endif()
  endforeach()

  set_property(GLOBAL APPEND PROPERTY RADCERT_LAYERS ${name})
  radcert_check_includes(${name} "${CMAKE_CURRENT_SOURCE_DIR}/radcert/${name}" "${arg_USES}")

  set(target radcert_${name})
  if(arg_SOURCES)
    list(TRANSFORM arg_SOURCES PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/radcert/${name}/")
    add_library(${target} STATIC ${arg_SOURCES})
    radcert_for_shared_objects(${target})
    set(scope PUBLIC)
    foreach(third_party IN LISTS arg_PRIVATE)
      # A library of headers alone leaves nothing to link: who uses the installed radcert need not have it.
      get_target_property(type ${third_party} TYPE)
      if(type STREQUAL "INTERFACE_LIBRARY")
        target_link_libraries(${target} PRIVATE "$<BUILD_INTERFACE:${third_party}>")
      else()
        target_link_libraries(${target} PRIVATE ${third_party})
      endif()
    endforeach()
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(radcert::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${target} ${scope} cxx_std_20)
  # The formulas are templates in headers: whoever instantiates them must not contract them either, and must take the
  # registers that the library takes, or a pack would be passed to it in others.
  target_compile_options(${target} INTERFACE -ffp-contract=off)
  if(RADCERT_ARCH)
    if(PROJECT_IS_TOP_LEVEL)
      target_compile_options(${target} INTERFACE "$<INSTALL_INTERFACE:-march=${RADCERT_ARCH}>")
    else()
      target_compile_options(${target} INTERFACE "-march=${RADCERT_ARCH}")
    endif()
  endif()
  target_include_directories(${target} ${scope}
    "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>" "$<INSTALL_INTERFACE:include>")
  foreach(used IN LISTS arg_USES)
    target_link_libraries(${target} ${scope} radcert::${used})
  endforeach()
endfunction()

# radcert_catalogue(<layer> <function> TYPE <type> HEADER <file> [FOLDER <folder>] NAMES <name>...)
#
# Gives the layer the sources <folder>/<name>.cpp, each of which defines
#   <type> radcert::<name>_entry();
# and the definition of `const std::vector<type>& radcert::<function>()`, which is declared in the header: the entries in
# this order. A new name is a new source, and nothing else has to name it.
function(radcert_catalogue layer function)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "TYPE;HEADER;FOLDER" "NAMES")
  set(declarations)
  set(entries)
  foreach(name IN LISTS arg_NAMES)
    cmake_path(APPEND CMAKE_CURRENT_SOURCE_DIR radcert ${layer} ${arg_FOLDER} ${name}.cpp OUTPUT_VARIABLE source)
    target_sources(radcert_${layer} PRIVATE "${source}")
    string(APPEND declarations "${arg_TYPE} ${name}_entry();\n")
    string(APPEND entries "${name}_entry(), ")
  endforeach()
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp")
  file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [[
#include "radcert/@layer@/@arg_HEADER@"
// An "undefined reference" to one of these: its source defines no function of this name in the namespace radcert.

namespace radcert {
@declarations@
const std::vector<@arg_TYPE@>& @function@() {
  static const std::vector<@arg_TYPE@> entries = {@entries@};
  return entries;
}
}  // namespace radcert
]])
  target_sources(radcert_${layer} PRIVATE "${source}")
endfunction()

# Reads every header and source of a layer, stops at an include of a layer that is not among `allowed` and at one of
# these that is never included, and has the configuration run again when one of the files changes, comes or goes.
function(radcert_check_includes name folder allowed)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS "${folder}/*.h" "${folder}/*.cpp")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(unused ${allowed})
  foreach(file IN LISTS files)
    file(READ "${file}" text)
    string(REGEX MATCHALL "\n[ \t]*#[ \t]*include[ \t]*[<\"][^>\"\n]*" includes "\n${text}")
    foreach(include IN LISTS includes)
      string(REGEX REPLACE ".*[<\"]" "" path "${include}")
      set(complaint)
      if(path MATCHES "(^|/)[.][.]/")
        set(complaint "includes \"${path}\"; write #include \"radcert/<layer>/<file>.h\"")
      elseif(path MATCHES "^radcert/([^/]+)")
        set(layer "${CMAKE_MATCH_1}")
        list(REMOVE_ITEM unused ${layer})
        if(NOT layer STREQUAL name AND NOT layer IN_LIST allowed)
          set(complaint "includes \"${path}\" of layer ${layer}")
        endif()
      endif()
      if(complaint)
        string(FIND "\n${text}" "${include}" position)
        string(SUBSTRING "\n${text}" 0 ${position} before)
        string(REGEX MATCHALL "\n" newlines "${before}")
        list(LENGTH newlines line)
        math(EXPR line "${line} + 1")
        list(JOIN allowed " " names)
        message(FATAL_ERROR "${file}:${line}: layer ${name} ${complaint}; a layer may use only those declared "
          "above it and named (${name} may use: ${names})")
      endif()
    endforeach()
  endforeach()
  if(unused)
    list(JOIN unused " " names)
    message(FATAL_ERROR "radcert_layer(${name}): USES ${names}, but no file includes it")
  endif()
endfunction()

# radcert_umbrella(): the target radcert::radcert, which is all layers declared so far, and, with RADCERT_INSTALL, their
# installation.
function(radcert_umbrella)
  get_property(layers GLOBAL PROPERTY RADCERT_LAYERS)
  set(targets ${layers})
  list(TRANSFORM targets PREPEND radcert_)

  add_library(radcert_all INTERFACE)
  add_library(radcert::radcert ALIAS radcert_all)
  set_target_properties(radcert_all PROPERTIES EXPORT_NAME radcert)
  target_link_libraries(radcert_all INTERFACE ${targets})
  if(NOT RADCERT_INSTALL)
    return()
  endif()

  include(GNUInstallDirs)
  include(CMakePackageConfigHelpers)
  set(destination "${CMAKE_INSTALL_LIBDIR}/cmake/radcert")
  set(helpers "${PROJECT_SOURCE_DIR}/lib/cmake")
  install(TARGETS radcert_all ${targets} EXPORT radcertTargets COMPONENT development)
  install(EXPORT radcertTargets NAMESPACE radcert:: DESTINATION "${destination}" COMPONENT development)
  install(DIRECTORY radcert DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT development
    FILES_MATCHING PATTERN "*.h")
  configure_package_config_file("${helpers}/radcertConfig.cmake.in" radcertConfig.cmake
    INSTALL_DESTINATION "${destination}")
  write_basic_package_version_file(radcertConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES
    "${CMAKE_CURRENT_BINARY_DIR}/radcertConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/radcertConfigVersion.cmake"
    "${helpers}/FindArb.cmake" "${helpers}/FindFLINT.cmake" "${helpers}/FindGMP.cmake"
    "${helpers}/FindMPFR.cmake"
    DESTINATION "${destination}" COMPONENT development)
endfunction()
