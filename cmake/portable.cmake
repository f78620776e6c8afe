# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Portable builds (MENISCUS_PORTABLE): all libraries are linked from static ones, also those that are otherwise loaded when
# they are needed. The program then runs on any Linux for its processor, and the Python module on any with a C library that
# is new enough. Embree comes from tools/make-embree (-Dembree_ROOT); the other libraries from Debian's packages.
set(MENISCUS_THREADS std)  # Debian has no static oneTBB
set(MENISCUS_VDB OFF)      # nor OpenVDB
set(MENISCUS_INSTALL OFF)
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
set(fmt_DIR ${CMAKE_CURRENT_LIST_DIR}/headers)
set(CMAKE_CXX_LINK_OPTIONS_PIE -fPIE -static-pie)
list(APPEND link_program -s)
# What is not called is left out, and with it functions of newer C libraries.
list(APPEND link_module -static-libstdc++ -static-libgcc -Wl,--gc-sections -s)

# Debian's libpng.a is made for programs: its one use of `stderr` cannot be linked into a module. It gets a variable of
# ours in its place (src/io/png_standard_error.cpp).
find_library(MENISCUS_STATIC_PNG png REQUIRED)
set(PNG_LIBRARY_RELEASE ${PROJECT_BINARY_DIR}/libpng.a CACHE FILEPATH "" FORCE)
execute_process(COMMAND ${CMAKE_OBJCOPY} --redefine-sym stderr=meniscus_standard_error ${MENISCUS_STATIC_PNG}
    ${PNG_LIBRARY_RELEASE} COMMAND_ERROR_IS_FATAL ANY)
