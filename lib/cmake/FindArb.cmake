# Arb brings no CMake package. Defines the target Arb::Arb, which brings FLINT::FLINT with it. Debian calls the library
# flint-arb, others arb.
include(CMakeFindDependencyMacro)
find_dependency(FLINT MODULE)

find_path(Arb_INCLUDE_DIR arb.h)
find_library(Arb_LIBRARY NAMES flint-arb arb)
mark_as_advanced(Arb_INCLUDE_DIR Arb_LIBRARY)

if(Arb_INCLUDE_DIR)
  file(STRINGS "${Arb_INCLUDE_DIR}/arb.h" Arb_VERSION REGEX "^#define ARB_VERSION ")
  string(REGEX REPLACE ".*\"([0-9.]+).*" "\\1" Arb_VERSION "${Arb_VERSION}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb
  REQUIRED_VARS Arb_LIBRARY Arb_INCLUDE_DIR
  VERSION_VAR Arb_VERSION)

if(Arb_FOUND AND NOT TARGET Arb::Arb)
  add_library(Arb::Arb UNKNOWN IMPORTED)
  set_target_properties(Arb::Arb PROPERTIES
    IMPORTED_LOCATION "${Arb_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${Arb_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES FLINT::FLINT)
endif()
