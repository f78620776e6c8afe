# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Run by CPack on what it has made: in an archive files belong to root, whoever has built them. CPack 3.25 writes the name
# of the user who runs it, so that two builds would differ; packages of Debian have root anyway.
foreach(file IN LISTS CPACK_PACKAGE_FILES)
  if(NOT file MATCHES "\\.tar\\.gz$")
    continue()
  endif()
  set(content ${file}.content)
  file(REMOVE_RECURSE ${content})
  file(MAKE_DIRECTORY ${content})
  execute_process(COMMAND tar --extract --gzip --file ${file} --directory ${content} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND tar --create --format=gnu --sort=name --mtime=@$ENV{SOURCE_DATE_EPOCH} --owner=root:0 --group=root:0
      --directory ${content} ${CPACK_PACKAGE_FILE_NAME}
    COMMAND gzip --best --no-name OUTPUT_FILE ${file} COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE_RECURSE ${content})
endforeach()
