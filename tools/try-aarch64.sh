#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Builds the program for 64-bit ARM and runs it with qemu: its meshes and numbers are those of BUILD. The libraries come
# from Debian's packages for that processor, unpacked into a folder; nothing of them is installed.
#   tools/try-aarch64.sh BUILD    needs g++-aarch64-linux-gnu, qemu-user-static and, the first time, the network
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=tools/setup.sh
source "$root/tools/setup.sh"
[ $# -eq 1 ] || die "usage: try-aarch64.sh BUILD"
native=$(cd "$1" && pwd)/cli/meniscus
folder=$root/build/aarch64
sysroot=$folder/sysroot

# The packages with all that they depend on, by apt with lists of its own.
fill_sysroot() {
    local apt=$folder/apt package headers
    mapfile -t headers < <(packages_of run | grep -e '-dev$')
    mkdir -p "$apt/lists/partial" "$apt/archives/partial" "$sysroot"
    : >"$apt/status"
    echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian bookworm main" \
        >"$apt/sources.list"
    local options=(-o "Dir::Etc::SourceList=$apt/sources.list" -o Dir::Etc::SourceParts=- -o "Dir::State::Lists=$apt/lists"
        -o "Dir::State::status=$apt/status" -o "Dir::Cache=$apt" -o APT::Sandbox::User= -o APT::Architecture=arm64
        -o APT::Architectures=arm64)
    quietly apt-get "${options[@]}" update
    quietly apt-get "${options[@]}" install -y --no-install-recommends --download-only libc6-dev libstdc++-12-dev \
        "${headers[@]}"
    for package in "$apt"/archives/*.deb; do dpkg -x "$package" "$sysroot"; done
    touch "$folder/complete"
}
[ -f "$folder/complete" ] || fill_sysroot

quietly cmake -S "$root" -B "$folder/release" -G Ninja -DCMAKE_BUILD_TYPE=Release -DMENISCUS_TESTS=OFF -DMENISCUS_INSTALL=OFF \
    -DMENISCUS_VDB=OFF -DCMAKE_TOOLCHAIN_FILE="$root/cmake/aarch64.cmake" -DCMAKE_SYSROOT="$sysroot" \
    -DMENISCUS_FONT=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf \
    -DMENISCUS_THREE_JS=/usr/share/javascript/three/three.min.js
quietly cmake --build "$folder/release" --target meniscus_cli

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/native" "$work/arm"
input=$root/examples/1ubq.pdb
if [ -n "${MENISCUS_TEST_DATA-}" ]; then input=$MENISCUS_TEST_DATA/structures/1crn.pdb; fi

# outputs FOLDER COMMAND ...: with the program that these words start.
outputs() {
    cd "$1"
    shift
    "$@" surface "$input" --quiet -o flow.ply --report flow.json
    "$@" surface "$input" --quiet --method direct -o direct.ply --report direct.json
    "$@" measure "$input" --quiet -o residues.csv --report measure.json
}
(outputs "$work/native" "$native")
(outputs "$work/arm" qemu-aarch64-static -L "$sysroot" "$folder/release/cli/meniscus")
"$root/tools/same-outputs.py" "$work/native" "$work/arm"
say "64-bit ARM: the same meshes and numbers of $(basename "$input")"
