# cmake -D root=<folder> -D files=<list> -D header=<output> -P source_digest.cmake
# Writes a header that defines RADCERT_SOURCE_DIGEST: SHA-256 over the lines "<SHA-256 of a file> <its path from
# the root>" of the listed files, in order. A header that says the same already is left untouched.
file(STRINGS "${files}" listed)
set(lines)
foreach(file IN LISTS listed)
  file(SHA256 "${file}" hash)
  file(RELATIVE_PATH path "${root}" "${file}")
  string(APPEND lines "${hash} ${path}\n")
endforeach()
string(SHA256 digest "${lines}")
set(text "#pragma once\n#define RADCERT_SOURCE_DIGEST \"${digest}\"\n")
if(EXISTS "${header}")
  file(READ "${header}" present)
endif()
if(NOT present STREQUAL text)
  file(WRITE "${header}" "${text}")
endif()
