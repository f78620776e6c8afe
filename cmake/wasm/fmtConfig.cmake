# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# {fmt} for WebAssembly: its headers alone, which the build has copied to MENISCUS_HEADERS (tools/make-web).
if(NOT TARGET fmt::fmt)
  add_library(fmt::fmt INTERFACE IMPORTED)
  set_target_properties(fmt::fmt PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES ${MENISCUS_HEADERS} INTERFACE_COMPILE_DEFINITIONS FMT_HEADER_ONLY=1)
endif()
