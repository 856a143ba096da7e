# What radcert builds upon. The Debian package of each, with the reason, is in .ci/packages-build.txt.
# Imported targets bring their headers as system headers; every use is PRIVATE.

find_package(Threads REQUIRED)
find_package(TBB REQUIRED CONFIG)
find_package(GMP REQUIRED MODULE)
find_package(MPFR 4.0 REQUIRED MODULE)
find_package(FLINT 2.9 REQUIRED MODULE)
find_package(Arb 2.23 REQUIRED MODULE)
find_package(CGAL 5.5 REQUIRED CONFIG)
find_package(Eigen3 3.4 REQUIRED CONFIG)
find_package(pegtl 3.2 REQUIRED CONFIG)
find_package(nlohmann_json 3.11 REQUIRED CONFIG)
find_package(PNG 1.6 REQUIRED MODULE)
find_package(ZLIB 1.2 REQUIRED MODULE)
find_package(EXPAT 2.4 REQUIRED MODULE)
find_package(OpenSSL 3.0 REQUIRED MODULE COMPONENTS Crypto)
# The program and the verification use these as well.
if(PROJECT_IS_TOP_LEVEL)
  find_package(Boost 1.74 REQUIRED CONFIG)
  find_package(tomlplusplus 3.3 REQUIRED CONFIG)
  find_package(CLI11 2.1 REQUIRED CONFIG)
  find_package(fmt 9 REQUIRED CONFIG)
endif()
