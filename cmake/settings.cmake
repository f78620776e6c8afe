# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# What every target shares: language, warnings, sanitizers, and floating point that gives the same bits everywhere.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# What is set here stays in this folder and below, also where another project takes this one in; only the libraries that
# are found are seen by all, since who links the library links them, too.
list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-Wno-restrict)  # GCC 12 warns falsely of joined strings (GCC bug 105651)
endif()
if(EMSCRIPTEN)
  # Sizes have 32 bits there; and exceptions, which messages to users are made of, have to be asked for.
  add_compile_options(-Wno-shorten-64-to-32 -fwasm-exceptions -msimd128)
  add_link_options(-fwasm-exceptions)
endif()
# Of the linkers for ELF, that is, not on macOS and Windows: programs name only libraries that they call; a module offers
# nothing of the libraries within it to other modules of the process.
set(link_program)
set(link_module)
if(NOT APPLE AND NOT WIN32)
  set(MENISCUS_ELF ON)
  set(link_program -Wl,--as-needed)
  set(link_module -Wl,--exclude-libs,ALL)
endif()
if(MENISCUS_WERROR)
  add_compile_options(-Werror)
endif()
if(MENISCUS_SANITIZE)
  add_compile_options(-fsanitize=${MENISCUS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${MENISCUS_SANITIZE})
endif()

# The sources of a target are compiled in packs: most of what a small source costs are the headers that it includes. Names
# in anonymous namespaces are therefore unique within a target. Sources with options of their own stay alone.
function(meniscus_pack target size)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${MENISCUS_PACKS} UNITY_BUILD_BATCH_SIZE ${size})
endfunction()

# What only reads options and writes reports spends its time in the libraries: optimised little, it compiles a quarter faster.
function(meniscus_client target)
  meniscus_pack(${target} 8)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# One static library per room: meniscus_room(NAME SOURCES ... USES other rooms and libraries).
function(meniscus_room name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES" ${ARGN})
  add_library(meniscus_${name} STATIC ${ARG_SOURCES})
  target_include_directories(meniscus_${name} PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(meniscus_${name} PUBLIC ${ARG_USES})
  set_target_properties(meniscus_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  meniscus_pack(meniscus_${name} 8)
  if(EMSCRIPTEN AND NOT library STREQUAL "core")
    target_compile_options(meniscus_${name} PRIVATE -Os)  # what reads and writes is to be small rather than fast there
  endif()
  meniscus_part(meniscus_${name})
endfunction()

# meniscus_choose(OPTION WITH source ... LINKING library ... WITHOUT source): of a room that can do without a library. Adds to
# `chosen` and `linked` what the option asks for; cmake/libraries.cmake has found the libraries.
function(meniscus_choose option)
  cmake_parse_arguments(ARG "" "" "WITH;LINKING;WITHOUT" ${ARGN})
  if(${option})
    list(APPEND chosen ${ARG_WITH})
    list(APPEND linked ${ARG_LINKING})
  else()
    list(APPEND chosen ${ARG_WITHOUT})
  endif()
  set(chosen ${chosen} PARENT_SCOPE)
  set(linked ${linked} PARENT_SCOPE)
endfunction()

# The objects of this target become part of the library that is being described (src/CMakeLists.txt).
function(meniscus_part target)
  set_property(GLOBAL APPEND PROPERTY MENISCUS_PARTS_${library} ${target})
endfunction()

# One test program per room: meniscus_test(ROOM SOURCES ... USES ...). The tests themselves are optimised little, which
# saves a quarter of their compilation: most of what they test is in the libraries. Inline functions of headers are
# compiled with them, too, and where a library has not put such a one in place either, the linker takes the test's for
# both. Headers of the standard library and of GoogleTest are compiled once for all of them, which saves half of the rest;
# no source should lean on that: clang-tidy sees them without, though several together (tools/check-tidy.py).
function(meniscus_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES" ${ARGN})
  # GCC 12 takes what comes from precompiled headers for ours, and warns falsely of joined strings (-Wno-restrict above).
  set(options $<$<CONFIG:Release>:-O1>
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-subobject-linkage>")
  if(NOT TARGET test_headers)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/test_headers.cpp CONTENT "int main() {}\n" @ONLY)
    add_executable(test_headers EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/test_headers.cpp)
    target_link_libraries(test_headers PRIVATE GTest::gtest)
    target_compile_options(test_headers PRIVATE ${options})
    target_precompile_headers(test_headers PRIVATE <gtest/gtest.h> <algorithm> <array> <cmath> <limits> <map> <numbers>
      <numeric> <optional> <random> <set> <span> <stdexcept> <string> <utility> <vector>)
  endif()
  add_executable(test_${name} ${ARG_SOURCES})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(test_${name} PRIVATE ${ARG_USES} GTest::gtest GTest::gtest_main)
  target_compile_options(test_${name} PRIVATE ${options})
  target_precompile_headers(test_${name} REUSE_FROM test_headers)
  meniscus_pack(test_${name} 8)
  gtest_discover_tests(test_${name} TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60)
endfunction()
