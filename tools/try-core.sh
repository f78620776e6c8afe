#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Builds the library `core` by itself in every way that it is meant for, and compares the bits of all that it makes: with the
# threads of the standard library and with none, by Clang with its own C++ library, and as WebAssembly.
#   tools/try-core.sh BUILD    BUILD: a build of everything, whose results the others must have
# Exit code 1 if anything differs or does not build. What cannot be tried here is named.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=tools/setup.sh
source "$root/tools/setup.sh"
[ $# -eq 1 ] || die "usage: try-core.sh BUILD"
expected=$(mktemp)
trap 'rm -f "$expected"' EXIT

spheres=("$root/tests/alone/spheres.xyzr")
if [ -n "${MENISCUS_TEST_DATA-}" ]; then
    for name in 1ETN 1B17 fullerene; do spheres+=("$MENISCUS_TEST_DATA/structures/$name.xyzr"); done
    for name in 1crn 1hga; do # atoms with their radii, as files of spheres
        "$1/cli/meniscus" surface "$MENISCUS_TEST_DATA/structures/$name.pdb" --method gaussian --spacing 2 --no-exact --quiet \
            -o "$root/build/$name.xyzr"
        spheres+=("$root/build/$name.xyzr")
    done
fi
cmake --build "$1" --target core_checksums >/dev/null
"$1/tests/alone/core_checksums" "${spheres[@]}" >"$expected"
if ldd "$1/tests/alone/core_checksums" | grep -vE 'linux-vdso|ld-linux|lib(stdc\+\+|m|gcc_s|c|tbb|pthread)\.so'; then
    die "core needs these libraries, but should need none beside the thread library"
fi

failed=0
# try NAME COMMAND_TO_RUN TESTS(ON|OFF) CONFIGURE ...
try() {
    local name=$1 runner=$2 tests=$3 folder=$root/build/core-$1
    shift 3
    if (quietly "$@" -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DMENISCUS_LIBRARIES=core \
        -DMENISCUS_INSTALL=OFF -DMENISCUS_TESTS="$tests" && quietly cmake --build "$folder" &&
        quietly cmake --build "$folder" --target core_checksums &&
        $runner "$(find "$folder/tests/alone" -name core_checksums -o -name core_checksums.js)" "${spheres[@]}" |
        diff "$expected" - && { [ "$tests" = OFF ] || quietly ctest --test-dir "$folder" --output-on-failure; }); then
        say "core, $name: the same bits"
    else
        say "core, $name: FAILED"
        failed=1
    fi
}

try standard-threads "" ON cmake -DMENISCUS_THREADS=std
try no-threads "" ON cmake -DMENISCUS_THREADS=none
if [ -d /usr/lib/llvm-14/include/c++/v1 ] && command -v clang++ >/dev/null; then
    try libc++ "" OFF cmake -DMENISCUS_THREADS=std -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS=-stdlib=libc++
else
    say "core, libc++: not tried, libc++-dev or clang is missing"
fi
if command -v emcmake >/dev/null && command -v node >/dev/null; then
    export NODE_PATH=/usr/share/nodejs # where Debian keeps acorn, which the linker uses
    old_node=$(node --no-experimental-fetch -e 0 2>/dev/null && echo --no-experimental-fetch || true)
    try WebAssembly "node $old_node" OFF emcmake cmake -DMENISCUS_THREADS=none -DMENISCUS_HARDENING=OFF
else
    say "core, WebAssembly: not tried, emscripten or nodejs is missing"
fi
exit $failed
