# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# {fmt} compiled in from its headers, for builds that can link no shared library: portable ones and WebAssembly.
# MENISCUS_HEADERS, if set, is the folder with the headers (tools/make-web).
find_path(MENISCUS_FMT_INCLUDE_DIR fmt/core.h HINTS ${MENISCUS_HEADERS} NO_CMAKE_FIND_ROOT_PATH REQUIRED)
if(NOT TARGET fmt::fmt)
  add_library(fmt::fmt INTERFACE IMPORTED)
  set_target_properties(fmt::fmt PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES ${MENISCUS_FMT_INCLUDE_DIR} INTERFACE_COMPILE_DEFINITIONS FMT_HEADER_ONLY=1)
endif()
