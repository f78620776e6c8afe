#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Builds the program without Embree, FreeType, libpng, zlib and nettle, and tries it: what needs none of them is the same
# bytes, all else is refused in one line.
#   tools/try-without.sh BUILD    BUILD: a build of everything, whose results these must be
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=tools/setup.sh
source "$root/tools/setup.sh"
[ $# -eq 1 ] || die "usage: try-without.sh BUILD"
whole=$(cd "$1" && pwd)/cli/meniscus
build=$root/build/without
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

quietly cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DMENISCUS_TESTS=ON -DMENISCUS_INSTALL=OFF \
    -DMENISCUS_PICTURES=OFF -DMENISCUS_ZLIB=OFF -DMENISCUS_NETTLE=OFF -DMENISCUS_VDB=OFF -DMENISCUS_WERROR=ON
quietly cmake --build "$build" --target meniscus_cli meniscus_c test_render
quietly ctest --test-dir "$build" -R '^render\.' --output-on-failure

cd "$work"
cp "$root/examples/1ubq.pdb" .
outputs() { printf -- '-o %s.ply -o %s.glb -o %s.stl ' "$1" "$1" "$1"; }
# shellcheck disable=SC2046
"$whole" surface 1ubq.pdb --quiet --spacing 0.8 $(outputs whole)
# shellcheck disable=SC2046
"$build/cli/meniscus" surface 1ubq.pdb --quiet --spacing 0.8 $(outputs less)
for suffix in ply glb stl; do cmp "whole.$suffix" "less.$suffix"; done
"$whole" measure 1ubq.pdb --quiet -o whole.csv
"$build/cli/meniscus" measure 1ubq.pdb --quiet -o less.csv
cmp whole.csv less.csv

# refused CODE WORDS ARGUMENT ...
refused() {
    local code=0
    "$build/cli/meniscus" surface "${@:3}" --quiet 2>errors || code=$?
    [ "$code" = "$1" ] && [ "$(wc -l <errors)" = 1 ] && grep -q "$2" errors ||
        die "surface ${*:3}: exit code $code, $(cat errors)"
}
gzip -c 1ubq.pdb >1ubq.pdb.gz
refused 2 "no pictures" 1ubq.pdb -o 1ubq.png
refused 2 "no zlib" 1ubq.pdb -o 1ubq.npz
refused 2 "pages" 1ubq.pdb -o 1ubq.html
refused 3 "gzipped" 1ubq.pdb.gz -o 1ubq.ply
[ -z "$(find . -name '1ubq.*' ! -name '1ubq.pdb*')" ] || die "something was written although it was refused"
say "works without Embree, FreeType, libpng, zlib and nettle"
