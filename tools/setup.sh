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

missing_packages() {
    local package
    for package in "$@"; do
        [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || printf '%s\n' "$package"
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
    local wanted missing
    mapfile -t wanted < <(packages_of "$@")
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

# Removes a build folder that was configured for another place of the project.
forget_moved_build() {
    local cache=$1/CMakeCache.txt
    if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then rm -rf "$1"; fi
}

# Holds the lock of a build folder until this script ends, so that two runs do not build into it at once.
lock_build() {
    mkdir -p "$1"
    exec 9>"$1.lock"
    flock 9
}
