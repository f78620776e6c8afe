#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Tries the packages of a build in a bare Debian system: first the archive, which must need nothing, then the .deb.
#   tools/try-packages.sh BUILD    BUILD holds the packages and the program they were made of; needs root and the network
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=tools/setup.sh
source "$root/tools/setup.sh"

build=$(cd "$1" && pwd)
[ "$(id -u)" -eq 0 ] || die "only root can change into another system; run this as root"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
bare=$work/bare

# Runs a program within the bare system and compares its mesh and its picture with ours.
try() {
    rm -rf "$bare/tmp/results"
    mkdir "$bare/tmp/results"
    quietly chroot "$bare" env -i PATH=/usr/bin:/bin "$1" surface /tmp/1ubq.pdb.gz --quiet -o /tmp/results/1ubq.ply \
        -o /tmp/results/1ubq.png --report /tmp/results/1ubq.json
    cmp "$bare/tmp/results/1ubq.ply" "$work/1ubq.ply" || die "$1: another mesh"
    cmp "$bare/tmp/results/1ubq.png" "$work/1ubq.png" || die "$1: another picture"
    say "works: $1"
}

gzip -c "$root/examples/1ubq.pdb" >"$work/1ubq.pdb.gz"
(cd "$work" && "$build/cli/meniscus" surface 1ubq.pdb.gz --quiet -o 1ubq.ply -o 1ubq.png)

quietly debootstrap --variant=minbase bookworm "$bare" http://deb.debian.org/debian
cp "$work/1ubq.pdb.gz" "$bare/tmp"
tar -xzf "$build"/meniscus-*-linux-*.tar.gz -C "$bare/opt"
try "$(cd "$bare" && printf '/%s' opt/meniscus-*/bin/meniscus)"
rm -r "$bare"/opt/meniscus-*

cp "$build"/meniscus_*.deb "$bare/tmp/meniscus.deb"
quietly chroot "$bare" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive \
    apt-get install -y --no-install-recommends /tmp/meniscus.deb
try /usr/bin/meniscus
