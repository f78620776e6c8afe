# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Flags that make a mistake in memory end the program instead of doing harm, and builds that are the same bytes wherever
# and whenever they are made; what each costs is in docs/design/supply-chain.md. Sanitizers do more than the first and do
# not go along with them; debug builds keep the paths of their sources, for debuggers.
option(MENISCUS_HARDENING "Build with the compiler's and the linker's protections" ON)
set(shipped "$<CONFIG:Release,MinSizeRel,RelWithDebInfo>")

include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(MENISCUS_ELF)
  add_link_options(LINKER:-z,noexecstack)
endif()

if(MENISCUS_HARDENING AND NOT MENISCUS_SANITIZE)
  add_compile_options("$<${shipped}:-fstack-protector-strong;-fstack-clash-protection>")
  # Optimization comes with the configuration; what the surroundings have set is taken back, else it is a warning.
  add_compile_options("$<${shipped}:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>")
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|i.86")
    add_compile_options("$<${shipped}:-fcf-protection>")
  endif()
  if(MENISCUS_ELF)
    add_link_options(LINKER:-z,relro LINKER:-z,now)
  endif()
endif()
add_compile_options("$<$<CONFIG:Debug>:-D_GLIBCXX_ASSERTIONS>")  # 4 % of the time: too much for what is shipped

add_compile_options(
  "$<$<CONFIG:Release,MinSizeRel>:-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.;-ffile-prefix-map=${CMAKE_CURRENT_BINARY_DIR}=./build>")
