# Tells <source> of <target> which radcert this is: RADCERT_VERSION, the project's version, and
# RADCERT_SOURCE_DIGEST, a hash over the files of lib/ and verification/ taken when they are built. Nothing but
# that one source is compiled again when the digest changes.
function(radcert_version_information target source)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    return()
  endif()
  file(GLOB_RECURSE files CONFIGURE_DEPENDS
    "${PROJECT_SOURCE_DIR}/lib/*" "${PROJECT_SOURCE_DIR}/verification/*")
  list(FILTER files EXCLUDE REGEX "/[.#][^/]*$|~$")
  list(SORT files COMPARE STRING)

  set(list_file "${CMAKE_CURRENT_BINARY_DIR}/source_digest_files.txt")
  list(JOIN files "\n" lines)
  file(CONFIGURE OUTPUT "${list_file}" CONTENT "${lines}\n" @ONLY)

  set(header "${CMAKE_CURRENT_BINARY_DIR}/source_digest/radcert_source_digest.h")
  set(script "${PROJECT_SOURCE_DIR}/lib/cmake/source_digest.cmake")
  add_custom_command(OUTPUT "${header}"
    COMMAND ${CMAKE_COMMAND} -D "root=${PROJECT_SOURCE_DIR}" -D "files=${list_file}" -D "header=${header}"
      -P "${script}"
    DEPENDS "${script}" "${list_file}" ${files}
    COMMENT "Taking the source digest" VERBATIM)
  target_sources(${target} PRIVATE "${header}")
  set_source_files_properties("${source}" PROPERTIES
    COMPILE_DEFINITIONS "RADCERT_VERSION=\"${PROJECT_VERSION}\""
    COMPILE_OPTIONS "-include;${header}"
    OBJECT_DEPENDS "${header}")
endfunction()
