# radcert_embed(<target> <folder> FUNCTION <name> HEADER <header> [FILES <file>...])
#
# Gives the target the definition of the function <name>, as radcert::embedded_schemas, which <header>
# declares to return std::span<const EmbeddedFile>: the files in their order, by their paths from the folder;
# if none are named, every .toml, .csv, .json, .md and .bib file below it, ascending by path. Built again when
# one of these files changes, comes or goes.
function(radcert_embed target folder)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "FUNCTION;HEADER" "FILES")
  get_filename_component(folder "${folder}" ABSOLUTE)
  set(files ${arg_FILES})
  if(NOT files)
    set(patterns toml csv json md bib)
    list(TRANSFORM patterns PREPEND "${folder}/*.")
    file(GLOB_RECURSE files CONFIGURE_DEPENDS ${patterns})
    list(SORT files COMPARE STRING)
  endif()

  string(REGEX REPLACE ".*::" "" name "${arg_FUNCTION}")
  set(list_file "${CMAKE_CURRENT_BINARY_DIR}/${target}_${name}.txt")
  list(JOIN files "\n" lines)
  file(CONFIGURE OUTPUT "${list_file}" CONTENT "${lines}\n" @ONLY)

  if(NOT TARGET radcert_embed_files)
    add_executable(radcert_embed_files "${PROJECT_SOURCE_DIR}/lib/cmake/embed_files.cpp")
    target_compile_features(radcert_embed_files PRIVATE cxx_std_20)
    set_target_properties(radcert_embed_files PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tools")
  endif()
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${target}_${name}.cpp")
  add_custom_command(OUTPUT "${source}"
    COMMAND radcert_embed_files "${folder}" "${list_file}" "${source}" "${arg_HEADER}" ${arg_FUNCTION}
    DEPENDS radcert_embed_files "${list_file}" ${files}
    COMMENT "Embedding ${folder}" VERBATIM)
  target_sources(${target} PRIVATE "${source}")
endfunction()
