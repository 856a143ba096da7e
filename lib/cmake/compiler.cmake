# How everything in this project is compiled. Included once, at the top.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# A project that takes radcert in as a part has a cache of its own.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  if(PROJECT_IS_TOP_LEVEL)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug, RelWithDebInfo or MinSizeRel" FORCE)
  else()
    set(CMAKE_BUILD_TYPE Release)
  endif()
endif()

find_program(RADCERT_CCACHE ccache DOC "Compiler cache, used when there is one")
if(RADCERT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${RADCERT_CCACHE}")
endif()

# A product and a sum are fused only where the source says fma: then a pack equals the double, and every
# machine gives the same bits. Nothing that lets the compiler reorder or assume finite numbers, ever.
add_compile_options(-ffp-contract=off)

if(RADCERT_ARCH)
  add_compile_options("-march=${RADCERT_ARCH}")
endif()

add_compile_options(
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast
  -Wdouble-promotion -Wformat=2 -Wimplicit-fallthrough -Wcast-align)
# GCC 12 reports an overlap in `"text" + string` where there is none (its bug 105651). -Wnull-dereference is
# left out because it misfires inside the standard containers at -O2 and above.
add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
if(RADCERT_WERROR)
  add_compile_options(-Werror)
endif()

set(RADCERT_SANITIZERS)
if(RADCERT_SANITIZE STREQUAL "thread")
  set(RADCERT_SANITIZERS -fsanitize=thread)
  # The sanitizer takes no account of fences, such as those in the headers of oneTBB, in whose place parallel.cpp has
  # threads of its own then.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>)
elseif(RADCERT_SANITIZE MATCHES "^(address|ON|on|TRUE|1)$")
  set(RADCERT_SANITIZERS -fsanitize=address,undefined -fno-sanitize-recover=all)
elseif(RADCERT_SANITIZE)
  message(FATAL_ERROR "RADCERT_SANITIZE: '${RADCERT_SANITIZE}' is no sanitizer; allowed: address, thread, OFF")
endif()
if(RADCERT_SANITIZERS)
  add_compile_options(${RADCERT_SANITIZERS} -fno-omit-frame-pointer)
  # With the sanitizers GCC 12 takes the parts of std::regex for uninitialised (its bug 105562).
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  add_link_options(${RADCERT_SANITIZERS})
endif()

# radcert_for_shared_objects(<target>)
#
# Code that a shared object may hold, such as Python's module, and that is as fast in a program as without: names that
# are hidden from other shared objects need no table of addresses, and variables of a thread are found without a call
# once the linker knows that it makes a program.
function(radcert_for_shared_objects target)
  set_target_properties(${target} PROPERTIES
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()
