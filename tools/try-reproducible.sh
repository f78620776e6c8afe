#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Builds everything we ship twice: in folders of other names and depths, by other users (where this is root), with other
# homes, time zones and languages, one after the other, without the network; and compares every byte of
# programs, libraries, packages, the portable program and the wheel, whose Embree both builds share.
#   tools/try-reproducible.sh [BUILD ...]    BUILD: build folders to compare instead of making them
# Exit code 1 if anything differs. Takes two builds; what a compiler cache holds would prove nothing and is not used.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=tools/setup.sh
source "$root/tools/setup.sh"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"
python=/usr/bin/python3

# What is built, without what git ignores and without its history: the date comes with the variable.
copy_sources() {
    mkdir -p "$1"
    (cd "$root" && git ls-files -z --cached --others --exclude-standard | tar --null --files-from=- --create) |
        tar --extract --directory="$1"
}

# build_in SOURCE USER VARIABLE=VALUE ...: all targets, packages and the wheel, in SOURCE/build/package.
build_in() {
    local source=$1 user=$2 as_user=()
    shift 2
    if [ "$(id -u)" -eq 0 ]; then
        chown -R "$user" "$source"
        as_user=(setpriv "--reuid=$user" --regid=65534 --clear-groups)
    fi
    say "building in $source as ${as_user[*]:-this user}"
    quietly "$root/tools/without-network.sh" "${as_user[@]}" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin \
        CCACHE_DISABLE=1 SOURCE_DATE_EPOCH="$date" "$@" bash -c "umask 022; cd '$source' &&
        cmake --preset package -DMENISCUS_VDB=ON -DMENISCUS_PYTHON=ON -DPython_EXECUTABLE=$python -DPYTHON_EXECUTABLE=$python &&
        cmake --build build/package && (cd build/package && cpack) &&
        MENISCUS_EMBREE='$embree' tools/make-portable && MENISCUS_EMBREE='$embree' tools/make-wheel $python &&
        mv build/wheel/*.whl build/portable/meniscus-*-linux-* build/package"
}

# Files that are shipped or made of what is, by their paths in the build folder.
shipped() {
    (cd "$1" && find . -maxdepth 1 \( -name '*.deb' -o -name '*.tar.gz' -o -name '*.whl' -o\
        -name 'meniscus-*-linux-*' \) && find cli src python \
        -type f \( -name '*.so' -o -name 'libmeniscus-*.a' -o \( -path 'cli/*' -perm -u+x \) \)) | sort
}

compare() {
    local path differing=0
    diff <(shipped "$1") <(shipped "$2") >&2 || die "not the same files"
    while read -r path; do
        if cmp "$1/$path" "$2/$path" >&2; then
            say "the same: $path, $(stat -c %s "$1/$path") bytes"
        else
            differing=1
        fi
    done < <(shipped "$1")
    return $differing
}

date=${SOURCE_DATE_EPOCH-$(git -C "$root" log -1 --format=%ct 2>/dev/null || echo 315532800)}
if [ "$#" -eq 2 ]; then
    compare "$1" "$2"
    exit
fi
embree=$work/embree
"$root/tools/make-embree" "$embree"
chmod -R go+rX "$embree"
first=$work/one second=$work/another/place/of-a-longer-name
copy_sources "$first"
copy_sources "$second"
chmod 755 "$work/another" "$work/another/place"
build_in "$first" "$(id -u)" HOME="$work" USER=one LC_ALL=C TZ=UTC
build_in "$second" 65534 HOME=/nonexistent USER=another LC_ALL=C.UTF-8 TZ=Asia/Kathmandu
compare "$first/build/package" "$second/build/package"
