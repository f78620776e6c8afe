#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""APBS solves with our maps: solvation energy of a Born ion against theory, and against its own maps.

usage: apbs_test.py PROGRAM SOURCE_DIR
"""
import re
import subprocess

import foreign

RADIUS, CHARGE, INNER, OUTER = 3.0, 1.0, 1.0, 78.54
NODES, SPACING = 97, 0.25
# e² N_A / (8 pi epsilon_0), kJ/mol Å
HALF_COULOMB = 694.677
BORN = HALF_COULOMB * CHARGE**2 / RADIUS * (1 / OUTER - 1 / INNER)

ELEC = """elec name {name}
    mg-manual
    dime {n} {n} {n}
    grid {h} {h} {h}
    gcent 0 0 0
    mol 1
    lpbe
    bcfl mdh
    {ions}
    pdie {inner}
    sdie {outer}
    chgm spl2
    srfm mol
    srad 1.4
    swin 0.3
    sdens 40
    temp 298.15
    calcenergy total
    calcforce no
    {more}
end
"""


class ApbsTest(foreign.ForeignTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "ion.pqr").write_text(f"ATOM      1  I   ION     1       0.000   0.000   0.000  {CHARGE:.2f}  "
                                            f"{RADIUS:.2f}\n")
        cls.meniscus("surface", "ion.pqr", "--method", "direct", "--maps", "apbs", "--grid",
                     f"{NODES},{NODES},{NODES},{SPACING},0,0,0", "--eps", f"{INNER:g},{OUTER:g}", "-o", "ours.dx")

    def elec(self, name, outer=OUTER, more="", ions=""):
        return ELEC.format(name=name, n=NODES, h=SPACING, inner=INNER, outer=outer, more=more, ions=ions)

    def energy(self, *parts, read="", what="solvated - vacuum"):
        """What APBS prints for an expression, kJ/mol."""
        text = f"read\n    mol pqr ion.pqr\n{read}end\n{''.join(parts)}print elecEnergy {what} end\nquit\n"
        (self.folder / "apbs.in").write_text(text)
        result = subprocess.run(["apbs", "apbs.in"], cwd=self.folder, capture_output=True, encoding="utf-8",
                                check=False)
        self.assertEqual(result.returncode, 0, result.stdout[-2000:] + result.stderr[-2000:])
        return float(re.search(r"Global net ELEC energy = (\S+)", result.stdout)[1])

    # APBS takes all of them or none.
    READ = "    diel dx ours_dielx.dx ours_diely.dx ours_dielz.dx\n    kappa dx ours_kappa.dx\n"
    MAPS = "usemap diel 1\n    usemap kappa 1"

    def test_born_energy(self):
        vacuum = self.elec("vacuum", outer=INNER)
        ours = self.energy(self.elec("solvated", more=self.MAPS), vacuum, read=self.READ)
        theirs = self.energy(self.elec("solvated"), vacuum)
        print(f"Born {BORN:.2f} kJ/mol; with our maps {ours:.2f} ({100 * (ours / BORN - 1):+.2f} %), with its own "
              f"{theirs:.2f} ({100 * (theirs / BORN - 1):+.2f} %)")
        self.assertLess(abs(ours / BORN - 1), 0.02)
        self.assertLess(abs(ours / theirs - 1), 0.02)

    def test_maps_match_its_own(self):
        written = [f"write {name} dx theirs_{name}" for name in ("dielx", "diely", "dielz", "kappa")]
        ions = "ion charge 1 conc 0.15 radius 2.0\n    ion charge -1 conc 0.15 radius 2.0"
        self.energy(self.elec("solvated", more="\n    ".join(written), ions=ions), what="solvated")
        for name in ("dielx", "diely", "dielz", "kappa"):
            ours = self.read_dx(f"ours_{name}.dx")
            theirs = self.read_dx(next(p.name for p in self.folder.glob(f"theirs_{name}*.dx")))
            self.assertEqual(ours[0], theirs[0], name)
            self.assertTrue(all(abs(a - b) < 1e-4 for a, b in zip(ours[1], theirs[1])), (name, ours[1], theirs[1]))
            differing = sum(abs(a - b) > 1e-3 * abs(b) for a, b in zip(ours[2], theirs[2]))
            print(f"{name}: {differing} of {len(ours[2])} values differ")
            self.assertLess(differing, 0.002 * len(ours[2]))

    def test_salt_is_where_its_own_map_has_it(self):
        ions = "ion charge 1 conc 0.15 radius 2.0\n    ion charge -1 conc 0.15 radius 2.0"
        ours = self.energy(self.elec("salt", more=self.MAPS, ions=ions), self.elec("dry", more=self.MAPS),
                           read=self.READ, what="salt - dry")
        theirs = self.energy(self.elec("salt", ions=ions), self.elec("dry"), what="salt - dry")
        print(f"salt: with our map {ours:.4f} kJ/mol, with its own {theirs:.4f}")
        self.assertLess(theirs, -0.1)
        self.assertLess(abs(ours / theirs - 1), 0.02)

    def read_dx(self, name):
        """Counts, origin with spacings, values."""
        head, tail = (self.folder / name).read_text().split("data follows")
        counts = head.split("gridpositions counts")[1].split()[:3]
        frame = [float(x) for line in head.splitlines() if line.startswith(("origin", "delta"))
                 for x in line.split()[1:]]
        return counts, frame, [float(x) for x in tail.split("attribute")[0].split()]


foreign.main(programs=["apbs"])
