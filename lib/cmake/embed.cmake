# radcert_embed(<target> <folder> FUNCTION <name> [FILES <file>...])
#
# Gives the target the definition of a function of verification/framework/embedded.h: the files, by their paths from the
# folder; if none are named, every .toml, .csv, .json, .md and .bib file below it. Built again when one of these
# files changes, comes or goes.
function(radcert_embed target folder)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "FUNCTION" "FILES")
  get_filename_component(folder "${folder}" ABSOLUTE)
  set(files ${arg_FILES})
  if(NOT files)
    set(patterns toml csv json md bib)
    list(TRANSFORM patterns PREPEND "${folder}/*.")
    file(GLOB_RECURSE files CONFIGURE_DEPENDS ${patterns})
    list(SORT files COMPARE STRING)
  endif()

  set(list_file "${CMAKE_CURRENT_BINARY_DIR}/${target}_${arg_FUNCTION}.txt")
  list(JOIN files "\n" lines)
  file(CONFIGURE OUTPUT "${list_file}" CONTENT "${lines}\n" @ONLY)

  if(NOT TARGET radcert_embed_files)
    add_executable(radcert_embed_files "${PROJECT_SOURCE_DIR}/verification/framework/embed_files.cpp")
    set_target_properties(radcert_embed_files PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tools")
  endif()
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${target}_${arg_FUNCTION}.cpp")
  add_custom_command(OUTPUT "${source}"
    COMMAND radcert_embed_files "${folder}" "${list_file}" "${source}" ${arg_FUNCTION}
    DEPENDS radcert_embed_files "${list_file}" ${files}
    COMMENT "Embedding ${folder}" VERBATIM)
  target_sources(${target} PRIVATE "${source}")
  # The generated source includes "verification/framework/embedded.h".
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}")
endfunction()
