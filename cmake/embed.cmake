# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Writes files into a C++ source, as string views: cmake -DOUT=FILE -DNAMESPACE=A::B -DCONTENT=name=file,file:name=...
# -P embed.cmake. Several files of one name follow each other. No file: an empty view.
cmake_minimum_required(VERSION 3.25)
file(WRITE ${OUT}.new "// Made by cmake/embed.cmake.\n#include <string_view>\n\nnamespace {\n")
string(REPLACE ":" ";" entries "${CONTENT}")
set(views "")
foreach(entry ${entries})
  string(REPLACE "=" ";" pair "${entry}")
  list(POP_FRONT pair name)
  string(REPLACE "," ";" paths "${pair}")
  set(digits "")
  foreach(path ${paths})
    file(READ ${path} more HEX)
    string(APPEND digits ${more})
  endforeach()
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${digits}")
  string(LENGTH "${digits}" length)
  math(EXPR length "${length} / 2")
  file(APPEND ${OUT}.new "const unsigned char ${name}_bytes[] = {${bytes}0};\n")
  string(APPEND views "extern const std::string_view ${name};\n"
    "const std::string_view ${name}(reinterpret_cast<const char*>(${name}_bytes), ${length});\n")
endforeach()
file(APPEND ${OUT}.new "}  // namespace\n\nnamespace ${NAMESPACE} {\n${views}}\n")
file(RENAME ${OUT}.new ${OUT})
