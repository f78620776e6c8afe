# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# What PROGRAM prints when it is given WORDS becomes FILE; nothing is left of a page that could not be made.
string(REPLACE " " ";" words "${WORDS}")
execute_process(COMMAND ${PROGRAM} ${words} OUTPUT_VARIABLE page COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${FILE} "${page}")
