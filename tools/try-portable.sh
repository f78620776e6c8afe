#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Makes the portable program and runs it in a system that has nothing else, not even a C library; what it writes is what
# the program of BUILD writes.
#   tools/try-portable.sh BUILD    needs root, and the network once (tools/make-embree)
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=tools/setup.sh
source "$root/tools/setup.sh"
[ $# -eq 1 ] || die "usage: try-portable.sh BUILD"
[ "$(id -u)" -eq 0 ] || die "only root can change into another system; run this as root"
native=$(cd "$1" && pwd)/cli/meniscus
program=$("$root/tools/make-portable")
[ "$(stat -c %s "$program")" -le 25000000 ] || die "$program has more than 25 MB"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/bare/dev" "$work/native"
mknod -m 666 "$work/bare/dev/null" c 1 3 # what a batch gives its processes as input
cp "$program" "$work/bare/meniscus"
for folder in "$work/bare" "$work/native"; do gzip -nc "$root/examples/1ubq.pdb" >"$folder/1ubq.pdb.gz"; done

# outputs COMMAND ...: with the program that these words start.
outputs() {
    "$@" surface 1ubq.pdb.gz --quiet -o 1ubq.ply -o 1ubq.html --report surface.json
    "$@" surface 1ubq.pdb.gz --quiet --color depth --legend -o 1ubq.png
    "$@" measure 1ubq.pdb.gz --quiet -o residues.csv --report measure.json
    "$@" batch measure 1ubq.pdb.gz -o .csv --quiet --out tables.tar
}
(cd "$work/native" && outputs "$native")
outputs chroot "$work/bare" /meniscus
"$root/tools/same-outputs.py" "$work/native" "$work/bare"
say "works without anything else: $program, $(stat -c %s "$program") bytes"
