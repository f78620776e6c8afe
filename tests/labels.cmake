# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Which tests are not run by every ./test. A test without a label is quick and always runs. A slow one (two seconds and
# more) runs where a file has changed that it covers; it always covers its own folder. One that needs another program,
# a second build or a browser has the label `full` and runs by ./test --full, as all of them do.

# meniscus_slow(TEST ... COVERS PATH ...): for tests that add_test has made. Paths are relative to the root.
function(meniscus_slow)
  cmake_parse_arguments(ARG "" "" "COVERS" ${ARGN})
  meniscus_covers(labels ${ARG_COVERS})
  set_property(TEST ${ARG_UNPARSED_ARGUMENTS} PROPERTY LABELS ${labels})
endfunction()

# meniscus_full(TEST ...)
function(meniscus_full)
  set_property(TEST ${ARGN} PROPERTY LABELS full)
endfunction()

# meniscus_slow_cases(ROOM CASE ... COVERS PATH ...): likewise for cases of a program of GoogleTest, which ctest knows only
# once it is built; they are named Suite.Case.
function(meniscus_slow_cases room)
  cmake_parse_arguments(ARG "" "" "COVERS" ${ARGN})
  meniscus_covers(labels ${ARG_COVERS})
  list(TRANSFORM ARG_UNPARSED_ARGUMENTS PREPEND "${room}." OUTPUT_VARIABLE names)
  list(JOIN names " " names)
  set(file ${CMAKE_CURRENT_BINARY_DIR}/slow_cases.cmake)
  file(WRITE ${file} "set_tests_properties(${names} PROPERTIES LABELS \"${labels}\")\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${file})
endfunction()

function(meniscus_covers result)
  file(RELATIVE_PATH own ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  # What everything is built with, or of.
  set(common CMakeLists.txt src/CMakeLists.txt cmake packages.txt include src/core src/simd src/platform tests/CMakeLists.txt tests/labels.cmake
    tests/support)
  set(labels slow)
  foreach(path IN LISTS ARGN common ITEMS ${own})
    if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${path})
      message(FATAL_ERROR "${path}, which a slow test is said to cover, does not exist")
    endif()
    list(APPEND labels covers:${path})
  endforeach()
  set(${result} ${labels} PARENT_SCOPE)
endfunction()
