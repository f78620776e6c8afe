# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Open files and paths are read and written alike."""
import gzip
import io
import os
import pathlib
import subprocess
import sys
import threading
import unittest

from support import CENTRES, RADII, UBIQUITIN, InScratchFolder, read

import meniscus

SPHERES = "0 0 0 1.5\n2 0 0 1.4\n"


class Reading(InScratchFolder):
    def test_every_kind_of_file_object(self):
        wanted = read(UBIQUITIN)
        data = pathlib.Path(UBIQUITIN).read_bytes()
        pathlib.Path("a.pdb.gz").write_bytes(gzip.compress(data))
        with open(UBIQUITIN, "rb") as binary, open(UBIQUITIN, encoding="utf-8") as text, gzip.open("a.pdb.gz") as plain, \
                open("a.pdb.gz", "rb") as packed:
            for file in (binary, text, plain, packed, io.BytesIO(data), io.StringIO(data.decode()),
                         io.BytesIO(gzip.compress(data))):
                with self.subTest(file=type(file).__name__):
                    found = read(file)
                    self.assertEqual(found.xyz.tobytes(), wanted.xyz.tobytes())
                    self.assertEqual((found.notes, found.radii_set), (wanted.notes, wanted.radii_set))
                    self.assertFalse(file.closed)

    def test_the_name_and_the_hash_are_those_of_the_file(self):
        with open(UBIQUITIN, "rb") as file:
            found = read(file)
        wanted = read(UBIQUITIN)
        self.assertEqual((found.file, found.stem, found.sha256), (wanted.file, wanted.stem, wanted.sha256))
        self.assertEqual(read(io.StringIO(SPHERES)).stem, "structure")
        self.assertEqual(read(io.StringIO(SPHERES), name="two.xyzr").stem, "two")

    def test_a_format_is_told_where_content_does_not_tell(self):
        pqr = "ATOM 1 N ALA 1 0 0 0 0.5 1.5\n"
        self.assertEqual(read(io.StringIO(pqr), format="pqr").radii.tolist(), [1.5])
        self.assertEqual(read(io.StringIO("0 0 0 1.5 1 CA_GLY_1\n"), format="xyzrn").name.tolist(), ["CA"])
        self.assertEqual(read(io.BytesIO(gzip.compress(SPHERES.encode())), format="xyzr").notes, [])
        with self.assertRaisesRegex(meniscus.UsageError, "format: unknown value 'xyz'; choose one of pdb, "):
            meniscus.read(io.StringIO(SPHERES), format="xyz")

    def test_a_path_may_tell_nothing(self):
        pathlib.Path("spheres.dat").write_text(SPHERES)
        pathlib.Path("models.dat").write_bytes(pathlib.Path(UBIQUITIN).read_bytes())
        with self.assertRaisesRegex(meniscus.InputError, "unknown suffix"):
            meniscus.read("spheres.dat")
        for options in ({"format": "xyzr"}, {"name": "a.xyzr"}):
            self.assertEqual(read(pathlib.Path("spheres.dat"), **options).radii.tolist(), [1.5, 1.4])
        self.assertEqual(len(meniscus.read_models("models.dat", format="pdb")[0]), 602)
        with self.assertRaises(FileNotFoundError):
            meniscus.read("nosuch.dat", format="pdb")

    def test_what_is_wrong_is_told_with_its_place(self):
        bad = "ATOM      1  CA  GLY A   1       1.000   2.000   x.000\n"
        for options, start in (({}, "<data>:1:47: "), ({"name": "mine.pdb"}, "mine.pdb:1:47: "), ({"format": "pdb"}, "data.pdb:1:47")):
            with self.assertRaises(meniscus.InputError) as caught:
                meniscus.read(io.StringIO(bad), **options)
            self.assertTrue(str(caught.exception).startswith(start), caught.exception)
        with self.assertRaisesRegex(meniscus.InputError, "<data>: empty"):
            meniscus.read(io.BytesIO())
        with self.assertRaisesRegex(meniscus.InputError, "neither PDB nor mmCIF"):
            meniscus.read(io.BytesIO(b"hello"))
        with open("w.pdb", "wb") as file, self.assertRaises(OSError):
            meniscus.read(file)

    def test_a_file_that_gives_neither_bytes_nor_text(self):
        class Odd:
            def __init__(self, data):
                self.data = data

            def read(self):
                return self.data

        for data in (5, None, [1, 2]):
            with self.assertRaisesRegex(TypeError, rf"must give bytes or text, not {type(data).__name__}\Z"):
                meniscus.read(Odd(data))
        self.assertEqual(len(read(Odd(bytearray(b"0 0 0 1.5\n")))), 1)

    def test_wherever_a_path_is_read(self):
        def spheres():
            return io.StringIO(SPHERES)
        area = meniscus.measure(spheres()).sas_area
        self.assertEqual(meniscus.ExactSurface(spheres()).measures.sas_area, area)
        self.assertEqual(meniscus.surface(spheres()).measures.sas_area, area)
        self.assertEqual(len(meniscus.read_models(spheres())), 1)
        self.assertLess(meniscus.compare(spheres(), spheres()).hausdorff, 0.01)
        self.assertEqual(len(meniscus.measure(io.BytesIO(pathlib.Path(UBIQUITIN).read_bytes()), select="CA").structure), 76)

    def test_meshes_maps_and_tables(self):
        surface = meniscus.surface(CENTRES, RADII)
        surface.save("a.ply")
        surface.save("a.dx")
        with open("a.ply", "rb") as mesh:
            self.assertLess(meniscus.compare(mesh, surface).hausdorff, 1e-5)
        with open("a.dx", "rb") as values:
            found = surface.map_values(values)
        self.assertEqual(found.tobytes(), surface.map_values("a.dx").tobytes())
        table = io.StringIO("index,phi\n" + "".join(f"{i},{i}.5\n" for i in range(len(CENTRES))))
        pathlib.Path("t.csv").write_text(table.getvalue())
        self.assertEqual(surface.table_values(table)["phi"].tobytes(), surface.table_values("t.csv")["phi"].tobytes())
        bad = io.StringIO("index,phi\n0,x\n")
        with self.assertRaisesRegex(meniscus.InputError, r"\Adata.csv:1:1: no column of values"):
            surface.table_values(bad)


class Writing(InScratchFolder):
    def setUp(self):
        super().setUp()
        self.surface = meniscus.surface(CENTRES, RADII)

    def test_the_bytes_are_those_of_a_path(self):
        for format in ("ply", "obj", "stl", "off", "glb", "vtp", "html", "dx", "mrc", "mls", "png"):
            with self.subTest(format=format):
                options = {"color": "patch", "size": (64, 48)}
                self.surface.save(f"output.{format}", **options)
                stream = io.BytesIO()
                self.surface.write(stream, format, **options)
                self.assertEqual(stream.getvalue(), pathlib.Path(f"output.{format}").read_bytes())
                self.assertFalse(stream.closed)

    def test_the_name_of_a_file_tells_its_format(self):
        with open("a.ply", "wb") as file:
            self.surface.save(file)
        self.surface.save(pathlib.Path("b.ply"))
        self.assertEqual(pathlib.Path("a.ply").read_bytes(), pathlib.Path("b.ply").read_bytes())
        self.surface.save("c.dat", format="ply")
        self.assertEqual(pathlib.Path("c.dat").read_bytes(), pathlib.Path("b.ply").read_bytes())
        with gzip.open("d.gz", "wb") as file:
            self.surface.write(file, format="off")
        self.assertEqual(gzip.open("d.gz").read(3), b"OFF")

    def test_text_where_the_format_is_text(self):
        stream = io.StringIO()
        self.surface.write(stream, format="off")
        self.assertTrue(stream.getvalue().startswith("OFF"))
        with self.assertRaisesRegex(meniscus.UsageError, "opened as text, but this format is binary"):
            self.surface.write(io.StringIO(), format="glb")

    def test_everything_that_is_saved(self):
        structure, points = self.surface.structure, self.surface.sample()
        pair = meniscus.Structure.from_arrays([[0, 0, 0], [3, 0, 0]], 1.7, chain=["L", "H"])
        measures = meniscus.measure(pair, between=("L", "H"))
        comparison = meniscus.compare(self.surface, structure)
        for save, suffix in ((structure.save, "xyzr"), (structure.save, "csv"), (points.save, "ply"), (points.save, "npz"),
                             (measures.save, "csv"), (measures.save_interfaces, "json"), (comparison.save, "ply")):
            with self.subTest(save=save.__qualname__, suffix=suffix):
                stream = io.BytesIO()
                save(stream, format=suffix)
                save(f"output.{suffix}")
                self.assertGreater(len(stream.getvalue()), 10)
                if suffix != "npz":  # has the time of writing
                    self.assertEqual(stream.getvalue(), pathlib.Path(f"output.{suffix}").read_bytes())

    def test_what_cannot_be_written(self):
        with self.assertRaisesRegex(meniscus.UsageError, "format vert: makes several files; give a path"):
            self.surface.write(io.BytesIO(), format="vert")
        with self.assertRaisesRegex(meniscus.UsageError, "format: required for a file without a name"):
            self.surface.save(io.BytesIO())
        with self.assertRaisesRegex(meniscus.UsageError, r"\Aoutput.gif: unknown suffix"):
            self.surface.write(io.BytesIO(), format="gif")
        with self.assertRaises(TypeError):
            self.surface.save(3)
        with self.assertRaisesRegex(meniscus.OutputError, r"\Anosuch/a.dat: there is no folder 'nosuch'; create it first"):
            self.surface.save("nosuch/a.dat", format="ply")
        with self.assertRaisesRegex(meniscus.OutputError, r"\A\.: cannot be written"):
            self.surface.save(".", format="ply")
        self.assertEqual([path.name for path in pathlib.Path().iterdir()], [])

    def test_a_given_format_follows_links_and_keeps_permissions(self):
        points = self.surface.sample()
        for save, start in ((lambda path: self.surface.save(path, format="ply"), b"ply"), (points.save, b"PK")):
            target, link = pathlib.Path("target.npz"), pathlib.Path("link.npz")
            target.write_text("old")
            target.chmod(0o640)
            link.symlink_to(target)
            save("link.npz")
            self.assertTrue(link.is_symlink())
            self.assertEqual(target.stat().st_mode & 0o777, 0o640)
            self.assertTrue(target.read_bytes().startswith(start))
            link.unlink()
        self.assertEqual([path.name for path in pathlib.Path().iterdir()], ["target.npz"])

    def test_a_given_format_goes_to_pipes(self):
        self.surface.save("wanted.ply")
        wanted = pathlib.Path("wanted.ply").read_bytes()
        os.mkfifo("pipe")
        received = []
        reader = threading.Thread(target=lambda: received.append(pathlib.Path("pipe").read_bytes()), daemon=True)
        reader.start()
        self.surface.save("pipe", format="ply")
        reader.join(30)
        self.assertEqual(received, [wanted])
        self.assertTrue(pathlib.Path("pipe").is_fifo())
        code = ("import meniscus; meniscus.surface([[0, 0, 0]], [2.0], spacing=1.0)"
                ".save('/dev/stdout', format='off')")
        written = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, check=True).stdout
        self.assertEqual(written[:3], b"OFF")

    def test_paths_that_are_not_text(self):
        name = os.fsdecode(b"\xff.bin")
        self.surface.save(name, format="off")
        self.assertEqual(pathlib.Path(name).read_bytes()[:3], b"OFF")
        with self.assertRaises(meniscus.OutputError) as caught:
            self.surface.save(f"nosuch/{name}", format="off")
        self.assertEqual(str(caught.exception), f"nosuch/{name}: there is no folder 'nosuch'; create it first")
        for path in ("a\0b.ply", pathlib.Path("a\0b")):
            with self.assertRaisesRegex(meniscus.UsageError, "null"):
                self.surface.save(path, format="ply")

    def test_files_that_take_a_part_at_a_time(self):
        wanted = io.BytesIO()
        self.surface.write(wanted, format="ply")

        class Raw(io.RawIOBase):
            def __init__(self):
                self.taken = b""

            def writable(self):
                return True

            def write(self, data):
                self.taken += bytes(data[:1000])
                return len(data[:1000])

        whole = Raw()
        self.surface.write(whole, format="ply")
        self.assertEqual(whole.taken, wanted.getvalue())

        class Silent:
            def write(self, data):
                self.taken = data

        silent = Silent()
        self.surface.write(silent, format="ply")
        self.assertEqual(silent.taken, wanted.getvalue())
        for answer in (0, None):
            full = Raw()
            full.write = lambda data, answer=answer: answer
            with self.assertRaisesRegex(meniscus.OutputError, f"the file: took only 0 of {len(whole.taken)} bytes"):
                self.surface.write(full, format="ply")


if __name__ == "__main__":
    unittest.main()
