#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""VTK reads our VTP files: the same points, triangles and arrays as in PLY, the volume of the report.

usage: vtk_test.py PROGRAM SOURCE_DIR
"""
import foreign


def read_polydata(path):
    import vtk

    reader = vtk.vtkXMLPolyDataReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(path))
    reader.SetFileName(str(path))
    reader.Update()
    assert not errors and reader.GetErrorCode() == 0, "VTK reports an error"
    return reader.GetOutput()


def read_ply(path):
    """Vertex records and triangles of our binary PLY, as numpy reads them."""
    import numpy

    types = {"float": "<f4", "double": "<f8", "int": "<i4", "uint": "<u4", "uchar": "u1"}
    header, _, body = path.read_bytes().partition(b"end_header\n")
    lines = [line.split() for line in header.decode("ascii").splitlines()]
    counts = [int(words[2]) for words in lines if words[0] == "element"]
    record = numpy.dtype([(words[2], types[words[1]]) for words in lines if words[0] == "property" and len(words) == 3])
    vertices = numpy.frombuffer(body, record, counts[0])
    faces = numpy.frombuffer(body, [("n", "u1"), ("v", "<i4", 3)], counts[1], counts[0] * record.itemsize)
    return vertices, faces["v"]


class Vtp(foreign.ForeignTest):
    OPTIONS = ("-o", "a.vtp", "-o", "a.ply", "--color", "patch")

    def setUp(self):
        from vtk.util.numpy_support import vtk_to_numpy

        self.numpy_of = vtk_to_numpy
        self.surface = read_polydata(self.folder / "a.vtp")
        self.vertices, self.triangles = read_ply(self.folder / "a.ply")

    def columns(self, *names):
        import numpy

        return numpy.stack([self.vertices[name] for name in names], axis=1)

    def test_points_and_triangles_are_those_of_ply(self):
        self.assertEqual(self.surface.GetNumberOfPoints(), self.report["mesh"]["vertices"])
        self.assertEqual(self.surface.GetNumberOfPolys(), self.report["mesh"]["triangles"])
        self.assertTrue((self.numpy_of(self.surface.GetPoints().GetData()) == self.columns("x", "y", "z")).all())
        corners = self.numpy_of(self.surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.assertTrue((corners == self.triangles).all())

    def test_every_array_is_that_of_ply(self):
        data = self.surface.GetPointData()
        names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
        own = {"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "alpha"}
        self.assertEqual(set(names), (set(self.vertices.dtype.names) - own) | {"Normals", "colors"})
        self.assertIn("residue", names)
        for name in set(names) - {"Normals", "colors"}:
            array = self.numpy_of(data.GetArray(name))
            self.assertTrue((array == self.vertices[name]).all(), name)
        self.assertTrue((self.numpy_of(data.GetNormals()) == self.columns("nx", "ny", "nz")).all())
        colours = self.columns("red", "green", "blue", "alpha")
        self.assertTrue((self.numpy_of(data.GetScalars()) == colours).all())
        self.assertEqual(data.GetScalars().GetName(), "colors")

    def test_the_volume_is_that_of_the_report(self):
        import vtk

        properties = vtk.vtkMassProperties()
        properties.SetInputData(self.surface)
        self.assertAlmostEqual(properties.GetVolume() / self.report["mesh"]["volume"], 1, delta=1e-6)
        self.assertAlmostEqual(properties.GetSurfaceArea() / self.report["mesh"]["area"], 1, delta=1e-6)

    def test_the_probe_radius_is_told(self):
        self.assertEqual(self.surface.GetFieldData().GetArray("probe").GetValue(0), 1.4)

    def test_nothing_is_an_empty_surface(self):
        self.meniscus("surface", foreign.UBIQUITIN, "-o", "none.vtp", "--components", "cavities", "--min-cavity", "1e6")
        self.assertEqual(read_polydata(self.folder / "none.vtp").GetNumberOfPoints(), 0)


foreign.main(modules=("vtk", "numpy"))
