# radcert_report_page(<target> <folder>)
#
# Bundles the page of a report from <folder> (Node and npm, libraries pinned by its package-lock.json) and gives the
# target the definition of radcert::verification::embedded_page(); its property RADCERT_PAGE_TOOLS is the folder of node_modules. Without Node, or where npm cannot fetch the
# libraries, the page is empty, the program writes a plain page, and says so: nothing else depends on Node.
find_program(RADCERT_NODE node)
find_program(RADCERT_NPM npm)

function(radcert_report_page target folder)
  get_filename_component(folder "${folder}" ABSOLUTE)
  set(work "${CMAKE_CURRENT_BINARY_DIR}/${target}_page")
  set(pages "${work}/pages")
  set(page "${pages}/page.html")
  file(GLOB sources CONFIGURE_DEPENDS "${folder}/src/*")
  if(RADCERT_NODE AND RADCERT_NPM)
    # npm works beside the sources it installs for, and the source tree stays clean.
    add_custom_command(OUTPUT "${work}/installed"
      COMMAND "${CMAKE_COMMAND}" -D "NPM=${RADCERT_NPM}" -D "FROM=${folder}" -D "TO=${work}"
        -P "${PROJECT_SOURCE_DIR}/lib/cmake/install_npm.cmake"
      DEPENDS "${folder}/package.json" "${folder}/package-lock.json" "${PROJECT_SOURCE_DIR}/lib/cmake/install_npm.cmake"
      COMMENT "Installing the report page's libraries" VERBATIM)
    add_custom_command(OUTPUT "${page}"
      COMMAND "${CMAKE_COMMAND}" -D "NODE=${RADCERT_NODE}" -D "FROM=${folder}" -D "TO=${work}" -D "PAGE=${page}"
        -P "${PROJECT_SOURCE_DIR}/lib/cmake/bundle_page.cmake"
      DEPENDS "${work}/installed" "${folder}/build.mjs" ${sources} "${PROJECT_SOURCE_DIR}/lib/cmake/bundle_page.cmake"
      COMMENT "Bundling the report page" VERBATIM)
    set_target_properties(${target} PROPERTIES RADCERT_PAGE_TOOLS "${work}")
  else()
    message(STATUS "Node or npm is missing: reports are plain pages, without formulas, plots and views in space")
    file(WRITE "${page}" "")
  endif()
  radcert_embed(${target} "${pages}" FUNCTION radcert::verification::embedded_page
    HEADER "verification/framework/reading/embedded.h" FILES "${page}")
endfunction()
