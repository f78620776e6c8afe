#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# Makes the wheel and uses it in a bare Debian system that has Python and numpy and nothing else of what Meniscus is built
# with: what package and program write there is what the program of BUILD writes.
#   tools/try-wheel.sh BUILD                                    in Debian 12; needs root and the network
#   tools/try-wheel.sh BUILD RELEASE PYTHON [SETTING ...]       in another release, with a wheel for another Python
#                                                               (tools/make-wheel)
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=tools/setup.sh
source "$root/tools/setup.sh"
[ $# -eq 1 ] || [ $# -ge 3 ] || die "usage: try-wheel.sh BUILD [RELEASE PYTHON [SETTING ...]]"
[ "$(id -u)" -eq 0 ] || die "only root can change into another system; run this as root"
native=$(cd "$1" && pwd)/cli/meniscus

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/expected"
cp "$root/examples/1ubq.pdb" "$work/expected"
(cd "$work/expected" && "$native" surface 1ubq.pdb --quiet -o 1ubq.ply -o 1ubq.png -o 1ubq.html --report surface.json &&
    "$native" measure 1ubq.pdb --quiet -o residues.csv --report measure.json &&
    "$native" batch measure 1ubq.pdb --quiet --out batch >/dev/null && mv batch/results.jsonl . && rm -r batch)

cat >"$work/use.py" <<'PYTHON'
import json
import subprocess
import meniscus

protein = meniscus.read("1ubq.pdb")
surface = meniscus.surface(protein)
for name in ("1ubq.ply", "1ubq.png", "1ubq.html"):
    surface.save(name)
measures = json.load(open("../program/measure.json"))["exact"]
assert meniscus.measure(protein).ses_area == measures["ses_area"], measures
(found,) = meniscus.map(["1ubq.pdb"], jobs=1)
assert found["status"] == "done", found
print(meniscus.__version__, subprocess.check_output(["/venv/bin/meniscus", "--version"], text=True))
PYTHON

# try_in RELEASE WHEEL
try_in() {
    local bare=$work/$1 wheel
    wheel=$(basename "$2")
    [ "$(stat -c %s "$2")" -lt 20000000 ] || die "$2 has 20 MB or more"
    quietly debootstrap --variant=minbase --include=python3,python3-numpy,python3-venv "$1" "$bare" http://deb.debian.org/debian
    mkdir -p "$bare/try/program" "$bare/try/package"
    cp "$root/examples/1ubq.pdb" "$bare/try/program"
    cp "$root/examples/1ubq.pdb" "$work/use.py" "$bare/try/package"
    cp "$2" "$bare/try"
    quietly chroot "$bare" env -i PATH=/usr/bin:/bin HOME=/root sh -e -c "
        python3 -m venv --system-site-packages /venv
        /venv/bin/pip install --no-index /try/$wheel
        cd /try/program
        /venv/bin/meniscus surface 1ubq.pdb --quiet -o 1ubq.ply -o 1ubq.png -o 1ubq.html --report surface.json
        /venv/bin/meniscus measure 1ubq.pdb --quiet -o residues.csv --report measure.json
        /venv/bin/meniscus batch measure 1ubq.pdb --quiet --out batch
        mv batch/results.jsonl .
        cd ../package
        /venv/bin/python use.py"
    "$root/tools/same-outputs.py" "$work/expected" "$bare/try/program"
    for name in 1ubq.ply 1ubq.png 1ubq.html; do cmp "$work/expected/$name" "$bare/try/package/$name"; done
    say "works in Debian $1: $wheel, $(stat -c %s "$2") bytes"
}

wheel=$("$root/tools/make-wheel" "${@:3}")
try_in "${2-bookworm}" "$wheel"
