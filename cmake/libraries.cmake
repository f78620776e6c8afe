# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# The libraries that Meniscus links, the one list: who links the static library links them, too, so that the files for
# CMake and pkg-config and the Debian package all name them.
set(libraries
  # target        find_package  pkg-config  Debian package
  TBB::tbb        "TBB"         tbb         libtbb-dev
  ZLIB::ZLIB      "ZLIB"        zlib        zlib1g-dev
  PNG::PNG        "PNG"         libpng      libpng-dev
  Nettle::nettle  "Nettle"      nettle      nettle-dev
  fmt::fmt        "fmt"         fmt         libfmt-dev)

while(libraries)
  list(POP_FRONT libraries target package pc_name debian_package)
  string(REPLACE " " ";" words ${package})
  find_package(${words} REQUIRED)
  list(APPEND library_targets ${target})
  string(APPEND find_dependencies "  find_dependency(${package})\n")
  if(pc_name MATCHES "^-l")
    string(APPEND pc_libs " ${pc_name}")
  else()
    string(APPEND pc_requires " ${pc_name}")
  endif()
  list(APPEND debian_packages ${debian_package})
endwhile()
