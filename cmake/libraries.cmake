# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# The libraries that Meniscus links, the one list: who links a static library links them, too, so that the files for
# CMake and pkg-config and the Debian package all name them.
# of        target           find_package  pkg-config  Debian package
set(libraries
  files     fmt::fmt         "fmt"         fmt         libfmt-dev)
if(MENISCUS_ZLIB)
  list(APPEND libraries files ZLIB::ZLIB "ZLIB" zlib zlib1g-dev)
endif()
if(MENISCUS_NETTLE)
  list(APPEND libraries files Nettle::nettle "Nettle" nettle nettle-dev)
endif()
if(MENISCUS_PICTURES)
  list(APPEND libraries files PNG::PNG "PNG" libpng libpng-dev)
endif()
if(MENISCUS_PICTURES AND NOT MENISCUS_PORTABLE)  # that Embree runs on
  list(APPEND libraries view TBB::tbb "TBB" tbb libtbb-dev)
endif()
if(MENISCUS_THREADS STREQUAL tbb)
  list(APPEND libraries core TBB::tbb "TBB" tbb libtbb-dev)
elseif(MENISCUS_THREADS STREQUAL std)
  list(APPEND libraries core Threads::Threads "Threads" -pthread libc6-dev)
endif()

while(libraries)
  list(POP_FRONT libraries of target package pc_name debian_package)
  if(NOT of IN_LIST MENISCUS_LIBRARIES)
    continue()
  endif()
  string(REPLACE " " ";" words ${package})
  find_package(${words} REQUIRED)
  list(APPEND libraries_of_${of} ${target})
  string(APPEND dependencies_of_${of} "    find_dependency(${package})\n")
  if(pc_name MATCHES "^-")
    string(APPEND pc_libs_of_${of} " ${pc_name}")
  else()
    string(APPEND pc_requires_of_${of} " ${pc_name}")
  endif()
  list(APPEND debian_packages ${debian_package})
endwhile()
list(REMOVE_DUPLICATES debian_packages)
