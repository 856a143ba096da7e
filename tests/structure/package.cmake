# Packs the Debian package, unpacks it into a folder, and uses from there what it brings: the program, the module of
# Python, the libraries for C and C++.
# cmake -D root= -D scratch= -D build= -D cpack= -D compiler= -D c_compiler= -D generator= -D version= -D python= -P package.cmake
cmake_minimum_required(VERSION 3.25)

function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors
    WORKING_DIRECTORY "${scratch}")
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}${errors}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()
function(require pattern)
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "no ${pattern} in: ${output}")
  endif()
endfunction()

file(REMOVE_RECURSE "${scratch}")
file(MAKE_DIRECTORY "${scratch}")
# Packed in a hurry: what a reader downloads is packed by xz.
step("${cpack}" --config "${build}/CPackConfig.cmake" -G DEB -B "${scratch}/packed" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip)
file(GLOB package "${scratch}/packed/radcert_${version}_*.deb")
step(dpkg-deb --extract "${package}" "${scratch}/root")
set(usr "${scratch}/root/usr")

# Nothing outside /usr, and what it depends upon by name, found in the shared objects or stated.
file(GLOB outside RELATIVE "${scratch}/root" "${scratch}/root/*")
if(NOT outside STREQUAL "usr")
  message(FATAL_ERROR "the package has ${outside}")
endif()
step(dpkg-deb --field "${package}" Package Version Depends Maintainer Description)
require("Package: radcert\n.*|Version: ${version}")
foreach(needed IN ITEMS libc6 libflint-arb2 libgmp10 libmpfr6 libstdc\\+\\+6 libtbb12)
  require("Depends: [^\n]*${needed} \\(")
endforeach()
if(python)
  require("Depends: [^\n]*python3 \\(>= 3[.][0-9]+~\\), python3 \\(<< 3[.][0-9]+~\\), python3-numpy")
endif()

# Without what the build folder or an installed radcert could lend.
set(ENV{LD_LIBRARY_PATH} "")
set(ENV{HOME} "${scratch}")
step("${usr}/bin/radcert" reference cube_opposite_faces --digits 10)
require("0[.]19982489")
foreach(file IN ITEMS share/man/man1/radcert.1 share/bash-completion/completions/radcert share/doc/radcert/copyright)
  if(NOT EXISTS "${usr}/${file}")
    message(FATAL_ERROR "${file} is not there")
  endif()
endforeach()
if(python)
  step(${CMAKE_COMMAND} -E env "PYTHONPATH=${usr}/lib/python3/dist-packages" "${python}" -B -c
    "import radcert\nprint(radcert.__file__, radcert.reference('cube_opposite_faces'))")
  require("${usr}/lib/python3/dist-packages/radcert/__init__.py <Reference cube_opposite_faces: 0[.]19982489")
endif()

# The example for C, by the folders of the package and by the package for CMake, which the library for C++ comes with.
set(examples "${root}/apps/examples/09_other_languages")
step("${c_compiler}" -std=c11 "${examples}/factors.c" "-I${usr}/include" "-L${usr}/lib" -lradcert_c
  "-Wl,-rpath,${usr}/lib" -o "${scratch}/factors")
step("${scratch}/factors")
require("floor to slope: 0[.]57735026")
find_program(pkg_config pkg-config)
if(pkg_config)
  step(${CMAKE_COMMAND} -E env "PKG_CONFIG_PATH=${usr}/lib/pkgconfig" "${pkg_config}" --cflags --libs radcert)
  require("-lradcert_c")
else()
  message(STATUS "pkg-config is not here: radcert.pc was not read")
endif()
file(WRITE "${scratch}/both/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)
project(both LANGUAGES C CXX)
find_package(radcert 0.1 CONFIG REQUIRED)
add_executable(in_c \"${examples}/factors.c\")
target_link_libraries(in_c PRIVATE radcert::c)
add_executable(in_cpp \"${root}/tests/structure/consumer/version.cpp\")
target_link_libraries(in_cpp PRIVATE radcert::radcert)
")
step(${CMAKE_COMMAND} -G "${generator}" -S "${scratch}/both" -B "${scratch}/both/build"
  -D "CMAKE_CXX_COMPILER=${compiler}" -D "CMAKE_C_COMPILER=${c_compiler}" -D "CMAKE_PREFIX_PATH=${usr}")
step(${CMAKE_COMMAND} --build "${scratch}/both/build")
step("${scratch}/both/build/in_c")
require("floor to slope: 0[.]57735026")
step("${scratch}/both/build/in_cpp")
require("^radcert ${version}\n$")
# What was unpacked is large, and says nothing any more.
file(REMOVE_RECURSE "${scratch}")
