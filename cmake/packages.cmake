# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# CPack: Debian packages `meniscus` and `libmeniscus-dev`, and an archive that needs nothing but the C library.
# Made by `cmake --preset package && cmake --build build/package --target package`.
set(CPACK_GENERATOR "DEB;TGZ")
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/package-kinds.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/package-permissions.cmake)
set(CPACK_POST_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/package-owner.cmake)
set(CPACK_PACKAGE_NAME meniscus)
set(CPACK_PACKAGE_VENDOR "The Meniscus authors")
set(CPACK_PACKAGE_CONTACT "The Meniscus authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "solvent-excluded surfaces of molecules")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_MACHINE ${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# Dates within packages: of the commit, else the earliest that every archive can hold, not of the build.
set(CPACK_SOURCE_DATE 315532800)
execute_process(COMMAND git log -1 --format=%ct WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE commit_date
  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE without_git)
if(without_git EQUAL 0)
  set(CPACK_SOURCE_DATE ${commit_date})
endif()

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME meniscus)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(loaded_packages libembree3-3 libfreetype6)  # with the first picture, and with the first text in one
list(JOIN loaded_packages ", " CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS libarchive13)  # loaded where a batch names an archive
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION
"The boundary of the space that a spherical probe, rolling over the atoms of a
protein or nucleic acid, cannot enter: as a closed triangle mesh, a picture,
and exact areas and volumes per atom, residue, chain and cavity.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libmeniscus-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
list(APPEND debian_packages ${loaded_packages})
list(JOIN debian_packages ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"Headers and library for C++ programs, with files for CMake and pkg-config.")

# Debian wants the licence of each package in a file of this name.
set(doc_dir ${CMAKE_INSTALL_DATADIR}/doc)
install(FILES LICENSE DESTINATION ${doc_dir}/meniscus RENAME copyright COMPONENT runtime)
install(FILES LICENSE DESTINATION ${doc_dir}/libmeniscus-dev RENAME copyright COMPONENT development)

# The archive: bin/meniscus starts lib/meniscus/meniscus with the libraries beside it, and so do the others.
set(of_bundle COMPONENT bundle EXCLUDE_FROM_ALL)
foreach(name IN ITEMS meniscus ${dropins})
  install(PROGRAMS cmake/launcher.sh DESTINATION bin RENAME ${name} ${of_bundle})
endforeach()
install(TARGETS meniscus_cli ${dropins} RUNTIME DESTINATION lib/meniscus ${of_bundle})
install(DIRECTORY ${link_dir}/ DESTINATION lib/meniscus/dropins ${of_bundle})
install_pages(${of_bundle})
install_made_pages(${of_bundle})
find_library(MENISCUS_FREETYPE libfreetype.so.6 REQUIRED)  # by the name under which it is loaded
install(CODE "
  set(program \"$<TARGET_FILE:meniscus_cli>\")
  set(loaded \"$<TARGET_SONAME_FILE:embree>\" \"${MENISCUS_FREETYPE}\")
  set(built_in_packages ${built_in_packages})
  set(library_dir lib/meniscus)
  set(licence_dir \"${CMAKE_INSTALL_DOCDIR}/licences\")
  include(\"${CMAKE_CURRENT_LIST_DIR}/bundle.cmake\")"
  ${of_bundle})
include(CPack)
