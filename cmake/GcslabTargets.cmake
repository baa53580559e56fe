# How every target of the project is compiled, and the two ways to declare one.

add_library(gcslab_options INTERFACE)
target_include_directories(gcslab_options INTERFACE ${PROJECT_SOURCE_DIR}/lib ${PROJECT_SOURCE_DIR})
target_compile_options(gcslab_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor
  -march=x86-64-v3
  # Directed rounding: without these GCC folds and contracts outward rounded operations away.
  -frounding-math -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(gcslab_options INTERFACE -Wno-restrict)  # false alarms on std::string, GCC bug 105651
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  # Clang marks its own support of -frounding-math experimental; the rounding self-test decides instead.
  target_compile_options(gcslab_options INTERFACE -Wno-unknown-pragmas -Wno-ignored-optimization-argument)
endif()
if(GCSLAB_SANITIZE)
  target_compile_options(gcslab_options INTERFACE -fsanitize=${GCSLAB_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=undefined)
  target_link_options(gcslab_options INTERFACE -fsanitize=${GCSLAB_SANITIZE})
endif()

# gcslab_library(<folder> SOURCES <files> DEPENDS <folders or targets>): the library of lib/<folder>.
function(gcslab_library folder)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(gcslab_${folder} STATIC ${ARG_SOURCES})
  target_link_libraries(gcslab_${folder} PUBLIC gcslab_options ${ARG_DEPENDS})
endfunction()

# gcslab_test(<name> LABELS <labels> SOURCES <files> DEPENDS <targets>): one GoogleTest executable, one ctest entry.
function(gcslab_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "LABELS;SOURCES;DEPENDS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 600)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} GTest::gtest_main gcslab_options)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE GCSLAB_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT})
endfunction()
