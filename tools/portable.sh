# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Sourced by tools/make-portable and tools/make-wheel: builds with all libraries linked statically (cmake/portable.cmake),
# in build/portable. The sourcing script has set `root`, the project's folder, and has read tools/setup.sh.
# shellcheck shell=bash disable=SC2154

portable=$root/build/portable

# Dates within what is made: of the commit, else the earliest that every archive can hold.
if [ -z "${SOURCE_DATE_EPOCH-}" ]; then
    SOURCE_DATE_EPOCH=$(git -C "$root" log -1 --format=%ct 2>/dev/null || echo 315532800)
fi
export SOURCE_DATE_EPOCH

# build_portable PYTHON TARGET ...: with the CMake settings in `settings`. MENISCUS_EMBREE may name a folder that
# tools/make-embree has filled.
settings=()
build_portable() {
    local python=$1 embree=${MENISCUS_EMBREE-$root/build/embree}
    shift
    "$root/tools/make-embree" "$embree"
    forget_moved_build "$portable"
    # Another Python may have been the last one.
    quietly cmake -S "$root" -B "$portable" -G Ninja -U "Python_*" -U "PYTHON_*" -U pybind11_DIR \
        -DCMAKE_BUILD_TYPE=Release -DMENISCUS_PORTABLE=ON -DMENISCUS_TESTS=OFF \
        -Dembree_ROOT="$(cd "$embree" && pwd)/install" -DMENISCUS_PYTHON=ON \
        -DPython_EXECUTABLE="$python" -DPYTHON_EXECUTABLE="$python" "${settings[@]}"
    drop_unusable_launcher "$portable"
    quietly cmake --build "$portable" --target "$@"
}

# The licences of all that is linked, as Debian's packages state them, with the common texts that these only name.
portable_licences() {
    local package text
    local packages=(fonts-dejavu-core gcc-12-base gemmi-dev libarchive-dev libbrotli-dev libc6 libcli11-dev libembree-dev
        libfmt-dev libfreetype-dev libjs-three libpng-dev nettle-dev nlohmann-json3-dev pybind11-dev tao-pegtl-dev
        zlib1g-dev)
    cat "$root/LICENSE"
    for package in "${packages[@]}"; do
        printf '\n\n======== %s (Debian package)\n\n' "$package"
        cat "/usr/share/doc/$package/copyright"
    done
    for text in $(for package in "${packages[@]}"; do cat "/usr/share/doc/$package/copyright"; done |
        grep -ohE '/usr/share/common-licenses/[A-Za-z0-9.-]*[A-Za-z0-9]' | sort -u); do
        [ -f "$text" ] || continue
        printf '\n\n======== %s\n\n' "$text"
        cat "$text"
    done
}
