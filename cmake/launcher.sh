#!/bin/sh
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# The programs in bin of the archive: runs the one of this name with the libraries that lie beside it. (A search path in
# the program itself would need /proc, which a bare system may not have.)
called=$(readlink -f "$0")
home=$(dirname "$(dirname "$called")")/lib/meniscus
LD_LIBRARY_PATH=$home${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export LD_LIBRARY_PATH
exec "$home/$(basename "$called")" "$@"
