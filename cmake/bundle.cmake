# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Run at installation of the component `bundle`: the shared libraries that `program` needs, and `loaded`, which it loads
# while running; all but the C library's own, with their licences as Debian's packages bring them.
set(root "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}")
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES "${program}" LIBRARIES ${loaded}
  RESOLVED_DEPENDENCIES_VAR libraries
  PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|rt|pthread)\\.so")

list(APPEND libraries ${loaded})

# The thread library's, if it is there: memory is handed out faster with it.
foreach(library IN LISTS libraries)
  string(REPLACE "libtbb.so.12" "libtbbmalloc.so.2" companion "${library}")
  if(NOT companion STREQUAL library)
    list(APPEND libraries "${companion}")
  endif()
endforeach()

set(packages)
foreach(library IN LISTS libraries)
  file(INSTALL "${library}" DESTINATION "${root}/${library_dir}" FOLLOW_SYMLINK_CHAIN)
  # Debian's list of files has some of them in /usr/lib, others in /lib, which is a link to it.
  file(REAL_PATH "${library}" file)
  string(REGEX REPLACE "^/usr" "" file "${file}")
  execute_process(COMMAND dpkg-query --search "*${file}" OUTPUT_VARIABLE owner COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "[:,].*" "" owner "${owner}")
  list(APPEND packages ${owner})
  configure_file(/usr/share/doc/${owner}/copyright "${root}/${licence_dir}/${owner}.txt" COPYONLY)
endforeach()

# The licences that these texts, and those of what is compiled in, only name.
set(common_texts)
foreach(package IN LISTS packages built_in_packages)
  file(READ /usr/share/doc/${package}/copyright text)
  string(REGEX MATCHALL "/usr/share/common-licenses/[A-Za-z0-9.-]*[A-Za-z0-9]" named "${text}")
  list(APPEND common_texts ${named})
endforeach()
list(REMOVE_DUPLICATES common_texts)
foreach(text IN LISTS common_texts)
  if(EXISTS "${text}")
    get_filename_component(name "${text}" NAME)
    configure_file("${text}" "${root}/${licence_dir}/common/${name}.txt" COPYONLY)
  endif()
endforeach()
