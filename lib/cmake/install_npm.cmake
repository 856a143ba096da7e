# cmake -D NPM=... -D FROM=... -D TO=... [-D REQUIRED=ON] -P install_npm.cmake
# Installs what package-lock.json pins into TO/node_modules; TO/installed says "yes", or "no" where that fails. REQUIRED:
# where it says "no" it is tried once more, and a failure is an error.
if(REQUIRED)
  file(READ "${TO}/installed" installed)
  if(installed STREQUAL "yes")
    return()
  endif()
endif()
file(MAKE_DIRECTORY "${TO}")
file(COPY "${FROM}/package.json" "${FROM}/package-lock.json" DESTINATION "${TO}")
execute_process(COMMAND "${NPM}" ci --ignore-scripts --no-audit --no-fund --loglevel=error
  WORKING_DIRECTORY "${TO}" RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT failed)
  file(WRITE "${TO}/installed" "yes")
  return()
endif()
file(WRITE "${TO}/installed" "no")
set(what "npm could not install what ${FROM}/package-lock.json pins, which takes a network once")
if(REQUIRED)
  message(FATAL_ERROR "${what}. Nothing was made. Build the target again where npm reaches its registry.\n${said}")
endif()
message(WARNING "${what}; pages that need it are plain or missing.\n${said}")
