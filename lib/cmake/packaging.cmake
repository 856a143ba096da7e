# What `cpack -G DEB` packs, in the build folder: the program, the library with its headers, the one for C, Python's module.
# Everything must be built; the package is then radcert_<version>_amd64.deb.
include(GNUInstallDirs)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/radcert" RENAME copyright
  COMPONENT program)
install(FILES "${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${PROJECT_SOURCE_DIR}/CITATION.cff"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/radcert" COMPONENT program)

set(CPACK_PACKAGE_NAME radcert)
set(CPACK_PACKAGE_VENDOR "The radcert authors")
set(CPACK_PACKAGE_CONTACT "The radcert authors <radcert@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION "A program, a library for C++ and C, and a module of Python that solve and examine the
radiosity integral equation. Every result comes with a radius, and says whether the radius is proved.")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL OFF)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_THREADS 0)
# The shared objects that are linked, by dpkg-shlibdeps with their least versions; ldconfig is asked to run.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
# The module is compiled for one Python.
if(TARGET radcert_python)
  get_target_property(minor radcert_python RADCERT_PYTHON_MINOR)
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "python3 (>= 3.${minor}~), python3 (<< 3.${next}~), python3-numpy")
endif()
# What a program in C++ links, since the library is static.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake (>= 3.25), g++ (>= 12), libexpat1-dev, libflint-arb-dev, libflint-dev, \
libgmp-dev, libmpfr-dev, libpng-dev, libssl-dev, libtbb-dev, pkg-config, zlib1g-dev")
include(CPack)
