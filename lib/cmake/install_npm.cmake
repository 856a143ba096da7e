# cmake -D NPM=... -D FROM=... -D TO=... -P install_npm.cmake
# Installs what package-lock.json pins into TO/node_modules; TO/installed says "yes", or "no" where that fails.
file(MAKE_DIRECTORY "${TO}")
file(COPY "${FROM}/package.json" "${FROM}/package-lock.json" DESTINATION "${TO}")
execute_process(COMMAND "${NPM}" ci --ignore-scripts --no-audit --no-fund --loglevel=error
  WORKING_DIRECTORY "${TO}" RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(failed)
  message(WARNING "npm could not install what ${FROM}/package.json lists; pages that need it are plain or missing.\n${said}")
  file(WRITE "${TO}/installed" "no")
else()
  file(WRITE "${TO}/installed" "yes")
endif()
