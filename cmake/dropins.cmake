# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# The programs that stand in for others, and a folder of links to them under the names of those: at the head of PATH it
# makes callers of the others take ours.
set(dropins meniscus-msms meniscus-nanoshaper pdb_to_xyzr pdb_to_xyzrn)
set(dropin_links msms NanoShaper pdb_to_xyzr pdb_to_xyzrn)
set(link_dir ${CMAKE_BINARY_DIR}/dropin-links)
file(MAKE_DIRECTORY ${link_dir})
foreach(link program IN ZIP_LISTS dropin_links dropins)
  file(CREATE_LINK ../../../bin/${program} ${link_dir}/${link} SYMBOLIC)
endforeach()
