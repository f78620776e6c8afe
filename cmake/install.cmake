# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts where. Components: `runtime`, the program and its pages; `development`, the library; and
# `bundle`, all that the archive holds (packages.cmake).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/meniscus)

# The library, for CMake and for pkg-config; both find it wherever the folder is moved.
foreach(library IN LISTS MENISCUS_LIBRARIES)
  install(TARGETS meniscus-${library} EXPORT meniscus-${library}-targets
    ARCHIVE COMPONENT development
    LIBRARY COMPONENT development)
  install(EXPORT meniscus-${library}-targets NAMESPACE Meniscus:: DESTINATION ${package_dir} COMPONENT development)
endforeach()
if(TARGET meniscus_c)
  install(TARGETS meniscus_c EXPORT meniscus-c-targets LIBRARY COMPONENT development)
  install(EXPORT meniscus-c-targets NAMESPACE Meniscus:: DESTINATION ${package_dir} COMPONENT development)
endif()
# core alone has no use for the headers of the other libraries.
set(left_out)
if(NOT MENISCUS_LIBRARIES MATCHES files)
  set(left_out REGEX "/(colours?|draw_(pockets|surface)|file_name|file_words|legend|level_set_file|list_of_counts|page|picture|radii|read_mesh|\
structure|tables|vertex_values|volume_file|write)\\.h$" EXCLUDE)
endif()
install(DIRECTORY include/meniscus DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILES_MATCHING PATTERN *.h ${left_out})

configure_package_config_file(cmake/meniscus-config.cmake.in meniscus-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(meniscus-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/FindNettle.cmake ${CMAKE_CURRENT_BINARY_DIR}/meniscus-config.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/meniscus-config-version.cmake
  DESTINATION ${package_dir} COMPONENT development)

file(RELATIVE_PATH path_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" path_to_prefix ${path_to_prefix})
# meniscus.pc is the whole, meniscus-core.pc the library that needs nothing else.
function(make_pc_file name)
  foreach(library IN LISTS ARGN)
    string(PREPEND pc_libs " -lmeniscus-${library}")
    string(APPEND pc_others "${pc_libs_of_${library}}")
    string(APPEND pc_requires "${pc_requires_of_${library}}")
  endforeach()
  if(BUILD_SHARED_LIBS)  # who links a static library links what it needs, too
    set(pc_needs "Libs: -L\${libdir}${pc_libs}\nLibs.private:${pc_others}\nRequires.private:${pc_requires}")
  else()
    set(pc_needs "Libs: -L\${libdir}${pc_libs}${pc_others}\nRequires:${pc_requires}")
  endif()
  configure_file(cmake/meniscus.pc.in ${name}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)
endfunction()
make_pc_file(meniscus-core core)
if(TARGET meniscus_c)
  set(name meniscus-c)
  set(pc_needs "Libs: -L\${libdir} -lmeniscus")
  configure_file(cmake/meniscus.pc.in meniscus-c.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/meniscus-c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)
endif()
if(MENISCUS_LIBRARIES MATCHES view)
  make_pc_file(meniscus core files view)
endif()

# Pages and examples, and the licences of what is compiled into the program, as Debian brings them.
set(built_in_packages fonts-dejavu-core gemmi-dev libcli11-dev libjs-three nlohmann-json3-dev tao-pegtl-dev)
function(install_pages)
  install(FILES CHANGELOG.md CITATION.cff LICENSE README.md THIRD_PARTY_NOTICES.md
    DESTINATION ${CMAKE_INSTALL_DOCDIR} ${ARGN})
  install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR} ${ARGN})
  install(PROGRAMS tools/slurm/meniscus-array.sh DESTINATION ${CMAKE_INSTALL_DOCDIR}/tools/slurm ${ARGN})
  foreach(package IN LISTS built_in_packages)
    install(FILES /usr/share/doc/${package}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR}/licences
      RENAME ${package}.txt ${ARGN} OPTIONAL)
  endforeach()
endfunction()

# Manual pages and completion, which the program itself prints.
set(made_dir ${CMAKE_BINARY_DIR}/made)
function(make_page file)
  list(JOIN ARGN " " words)
  add_custom_command(OUTPUT ${made_dir}/${file}
    COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:meniscus_cli> -D "WORDS=${words}" -D FILE=${made_dir}/${file}
      -P ${PROJECT_SOURCE_DIR}/cmake/make-page.cmake
    DEPENDS meniscus_cli ${PROJECT_SOURCE_DIR}/cmake/make-page.cmake VERBATIM)
  set_property(GLOBAL APPEND PROPERTY meniscus_made_pages ${made_dir}/${file})
endfunction()
function(make_pages)
  make_page(man1/meniscus.1 --man)
  foreach(subcommand IN ITEMS surface measure pockets compare batch)
    make_page(man1/meniscus-${subcommand}.1 --man ${subcommand})
  endforeach()
  make_page(completions/meniscus --completion bash)
  make_page(site-functions/_meniscus --completion zsh)
  get_property(pages GLOBAL PROPERTY meniscus_made_pages)
  add_custom_target(meniscus_made_pages ALL DEPENDS ${pages})
endfunction()
function(install_made_pages)
  install(DIRECTORY ${made_dir}/man1 cli/dropins/man1 DESTINATION share/man ${ARGN})
  install(DIRECTORY ${made_dir}/completions DESTINATION share/bash-completion ${ARGN})
  install(DIRECTORY ${made_dir}/site-functions DESTINATION share/zsh ${ARGN})
endfunction()

if(TARGET meniscus_cli)
  include(cmake/dropins.cmake)
  make_pages()
  install_made_pages(COMPONENT runtime)
  install(TARGETS meniscus_cli ${dropins} RUNTIME COMPONENT runtime)
  install(DIRECTORY ${link_dir}/ DESTINATION lib/meniscus/dropins COMPONENT runtime)
  install_pages(COMPONENT runtime)
  include(cmake/packages.cmake)
endif()
