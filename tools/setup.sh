# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Sourced by ./run and ./test: installs Debian packages that are missing and builds with CMake.
# Everything it says goes to standard error. The sourcing script has set `root`, the project's folder.
# shellcheck shell=bash disable=SC2154

say() { printf '%s\n' "meniscus: $*" >&2; }

die() {
    say "error: $*"
    exit 1
}

# The packages of the named sections of packages.txt.
packages_of() {
    local section
    for section in "$@"; do
        sed -n "/^\[$section\]/,/^\[/{/^\[/d;s/[[:space:]]*#.*//;/./p}" "$root/packages.txt"
    done
}

# Those of the named packages that are not installed, nor provided by another one that is.
missing_packages() {
    local installed package
    installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}, ${Provides},\n' 2>/dev/null | sed -n 's/^installed//p')
    for package in "$@"; do
        grep -qE "(^| )${package//[.+]/\\&}( \([^)]*\))?," <<<"$installed" || printf '%s\n' "$package"
    done
}

# apt-get as root, by whichever way there is; its output is shown only when it fails.
apt_get() {
    local log as_root=()
    if [ "$(id -u)" -ne 0 ]; then as_root=(sudo); fi
    log=$(mktemp)
    if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "$@" >"$log" 2>&1 </dev/null; then
        cat "$log" >&2
        rm -f "$log"
        return 1
    fi
    rm -f "$log"
}

# Installs what is missing of the named sections; silent and without network when nothing is.
install_packages() {
    local wanted
    mapfile -t wanted < <(packages_of "$@")
    install_missing "${wanted[@]}"
}

# install_only SECTION PACKAGE ...: of a section, which must have them, these packages alone.
install_only() {
    local package listed
    listed=$(packages_of "$1")
    shift
    for package in "$@"; do
        grep -qx "$package" <<<"$listed" || die "packages.txt does not have $package where it is looked for"
    done
    install_missing "$@"
}

# Installs those of the named packages that are missing.
install_missing() {
    local wanted=("$@") missing
    if ! command -v dpkg-query >/dev/null; then
        say "warning: not a Debian system; needed are: ${wanted[*]}"
        return
    fi
    mapfile -t missing < <(missing_packages "${wanted[@]}")
    [ "${#missing[@]}" -gt 0 ] || return 0
    if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
        die "these packages are missing and neither root nor sudo is at hand: apt-get install ${missing[*]}"
    fi
    say "installing ${missing[*]}"
    apt_get update || say "warning: the package lists could not be updated; trying with those at hand"
    apt_get install -y --no-install-recommends "${missing[@]}" || die "the packages could not be installed"
}

# Runs a command; shows its output only when it fails.
quietly() {
    local log
    log=$(mktemp)
    if ! "$@" >"$log" 2>&1 </dev/null; then
        cat "$log" >&2
        rm -f "$log"
        die "failed: $*"
    fi
    rm -f "$log"
}

# Whether a person reads what goes to standard error as it comes.
is_watched() { [ -t 2 ]; }

# show_progress: reads ninja's status lines ("[12/34 5.6] ...", NINJA_STATUS below) and turns them into one line that moves.
export NINJA_STATUS='[%f/%t %e] '
show_progress() {
    local line left
    while IFS= read -r line; do
        [[ $line =~ ^\[([0-9]+)/([0-9]+)\ ([0-9]+) ]] || continue
        left=''
        if [ "${BASH_REMATCH[3]}" -ge 5 ] && [ "${BASH_REMATCH[1]}" -gt 0 ]; then
            left=$(((BASH_REMATCH[2] - BASH_REMATCH[1]) * BASH_REMATCH[3] / BASH_REMATCH[1]))
            if [ "$left" -ge 90 ]; then
                left=", about $(((left + 30) / 60)) minutes left"
            elif [ "$left" -ge 45 ]; then
                left=", about 1 minute left"
            else
                left=", less than a minute left"
            fi
        fi
        printf '\r\033[Kbuilding: %d of %d files%s' "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" "$left" >&2
    done
    printf '\r\033[K' >&2
}

# run_ninja FOLDER [TARGET ...]: builds, with a line that moves where a person is watching; returns 1 and leaves the
# output in FOLDER.log where that fails.
run_ninja() {
    local folder=$1
    shift
    if is_watched; then
        cmake --build "$folder" -- "$@" 2>&1 </dev/null | tee "$folder.log" | show_progress
    else
        cmake --build "$folder" -- "$@" >"$folder.log" 2>&1 </dev/null
    fi
}

# What matters of a build's log: not the steps that have passed.
show_errors() { sed '/^\[[0-9]/d' "$1"; }

# Whether the compiler cache is there and can write what it keeps.
has_compiler_cache() {
    local folder result=0
    command -v ccache >/dev/null || return 1
    folder=$(mktemp -d)
    ccache c++ -x c++ -c /dev/null -o "$folder/empty.o" >/dev/null 2>&1 </dev/null || result=1
    rm -rf "$folder"
    return $result
}

# A compiler cache where there is one. An environment that has chosen another launcher keeps it.
if [ -z "${CMAKE_CXX_COMPILER_LAUNCHER-}" ] && has_compiler_cache; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
    export CCACHE_SLOPPINESS="${CCACHE_SLOPPINESS-pch_defines,time_macros}"
fi

# drop_unusable_launcher FOLDER: where a build folder was configured with a compiler cache that can no longer be used.
drop_unusable_launcher() {
    [ -f "$1/CMakeCache.txt" ] && [ -z "${CMAKE_CXX_COMPILER_LAUNCHER-}" ] || return 0
    if grep -q '^CMAKE_CXX_COMPILER_LAUNCHER:.*=ccache$' "$1/CMakeCache.txt"; then
        quietly cmake -DCMAKE_CXX_COMPILER_LAUNCHER= "$1"
    fi
}

# Removes a build folder that was configured for another place of the project.
forget_moved_build() {
    local cache=$1/CMakeCache.txt
    if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then rm -rf "$1"; fi
}

# Holds the lock of a build folder until this script ends, so that two runs do not build into it at once.
lock_build() {
    mkdir -p "$1"
    exec 9>"$1.lock"
    flock -n 9 || { say "waiting for another ./run or ./test that builds in $1"; flock 9; }
}
