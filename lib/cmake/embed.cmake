# radcert_embed(<target> <folder>)
#
# Gives the target the definition of radcert::verification::embedded_papers() (verification/framework/embedded.h):
# every .toml, .csv, .json, .md and .bib file below the folder, by its path from there. Built again when one of
# these files changes, comes or goes.
function(radcert_embed target folder)
  get_filename_component(folder "${folder}" ABSOLUTE)
  set(patterns toml csv json md bib)
  list(TRANSFORM patterns PREPEND "${folder}/*.")
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${patterns})
  list(SORT files COMPARE STRING)

  set(list_file "${CMAKE_CURRENT_BINARY_DIR}/${target}_embedded.txt")
  list(JOIN files "\n" lines)
  file(CONFIGURE OUTPUT "${list_file}" CONTENT "${lines}\n" @ONLY)

  if(NOT TARGET radcert_embed_files)
    add_executable(radcert_embed_files "${PROJECT_SOURCE_DIR}/verification/framework/embed_files.cpp")
    set_target_properties(radcert_embed_files PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tools")
  endif()
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${target}_embedded.cpp")
  add_custom_command(OUTPUT "${source}"
    COMMAND radcert_embed_files "${folder}" "${list_file}" "${source}"
    DEPENDS radcert_embed_files "${list_file}" ${files}
    COMMENT "Embedding ${folder}" VERBATIM)
  target_sources(${target} PRIVATE "${source}")
  # The generated source includes "verification/framework/embedded.h".
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}")
endfunction()
