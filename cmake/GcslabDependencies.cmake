# Every dependency is found here, once. README.md says why each is used.
find_package(PkgConfig REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(TBB REQUIRED)
pkg_check_modules(GMPXX REQUIRED IMPORTED_TARGET gmpxx gmp)
pkg_check_modules(MPFR REQUIRED IMPORTED_TARGET mpfr)
pkg_check_modules(CLP REQUIRED IMPORTED_TARGET clp)
find_path(GLPK_INCLUDE_DIR glpk.h REQUIRED)  # GLPK brings neither a CMake nor a pkg-config file
find_library(GLPK_LIBRARY glpk REQUIRED)
add_library(GLPK::GLPK UNKNOWN IMPORTED)
set_target_properties(GLPK::GLPK PROPERTIES
  IMPORTED_LOCATION ${GLPK_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${GLPK_INCLUDE_DIR})
find_path(FLINT_INCLUDE_DIR flint/fmpz_poly.h REQUIRED)  # neither does FLINT
find_library(FLINT_LIBRARY flint REQUIRED)
add_library(FLINT::FLINT UNKNOWN IMPORTED)
set_target_properties(FLINT::FLINT PROPERTIES
  IMPORTED_LOCATION ${FLINT_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${FLINT_INCLUDE_DIR})
find_path(CERES_INCLUDE_DIR ceres/ceres.h REQUIRED)  # its CMake file asks for the headers of libunwind, which clang's displace
find_library(CERES_LIBRARY ceres REQUIRED)
find_library(GLOG_LIBRARY glog REQUIRED)
add_library(Ceres::ceres UNKNOWN IMPORTED)
set_target_properties(Ceres::ceres PROPERTIES
  IMPORTED_LOCATION ${CERES_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${CERES_INCLUDE_DIR}
  INTERFACE_LINK_LIBRARIES "Eigen3::Eigen;${GLOG_LIBRARY}")
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)
if(GCSLAB_BUILD_TESTS)
  find_package(GTest REQUIRED)
  find_package(valijson REQUIRED)  # an outside judge of configs/schema
endif()
if(GCSLAB_BUILD_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()
if(NOT TARGET yaml-cpp::yaml-cpp)
  add_library(yaml-cpp::yaml-cpp ALIAS yaml-cpp)
endif()
