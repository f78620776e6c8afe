#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""VTK contours a volume at 0: our volume, and normals that point outwards.

usage: vtk_volume_test.py PROGRAM SOURCE_DIR
"""
import foreign


def contour(path):
    """Points, triangles and normals of the contour at 0 of a .mrc, read without help of ours."""
    import mrcfile
    import numpy
    import vtk
    from vtk.util import numpy_support

    with mrcfile.open(path) as file:
        values = numpy.ascontiguousarray(file.data, dtype=numpy.float32)
        step = [float(file.voxel_size[axis]) for axis in "xyz"]
        origin = [float(file.header.origin[axis]) for axis in "xyz"]
    image = vtk.vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetSpacing(step)
    image.SetOrigin(origin)
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(values.ravel(), deep=True))
    cubes = vtk.vtkFlyingEdges3D()
    cubes.SetInputData(image)
    cubes.SetValue(0, 0.0)
    cubes.ComputeNormalsOn()
    cubes.Update()
    mesh = cubes.GetOutput()
    triangles = numpy_support.vtk_to_numpy(mesh.GetPolys().GetData()).reshape(-1, 4)[:, 1:]
    return (numpy_support.vtk_to_numpy(mesh.GetPoints().GetData()).astype(float), triangles,
            numpy_support.vtk_to_numpy(mesh.GetPointData().GetNormals()).astype(float))


def enclosed(points, triangles):
    """Å³, positive where triangles are counter-clockwise seen from outside."""
    import numpy

    a, b, c = (points[triangles[:, i]] for i in range(3))
    return float(numpy.einsum("ij,ij->", a, numpy.cross(b, c)) / 6.0)


class VtkVolumeTest(foreign.ForeignTest):
    def contoured(self, *options):
        report = self.meniscus("surface", foreign.UBIQUITIN, "-o", "a.mrc", "-o", "a.dx", *options)
        points, triangles, normals = contour(self.folder / "a.mrc")
        return report, points, triangles, normals

    def test_the_contour_at_zero_has_our_volume(self):
        for options, bound in (((), 0.005), (("--method", "direct"), 0.005), (("--spacing", "0.35"), 0.0025)):
            report, points, triangles, _ = self.contoured(*options)
            volume = abs(enclosed(points, triangles))
            deviation = volume / report["mesh"]["volume"] - 1
            print(f"{' '.join(options) or 'flow'}: {volume:.1f} Å³, {100 * deviation:+.3f} %")
            self.assertLess(abs(deviation), bound)

    def test_normals_point_outwards(self):
        import numpy

        report, points, triangles, normals = self.contoured()
        self.assertTrue(numpy.isfinite(normals).all())
        # VTK's normals and triangles look down the values, as those of programs that show molecules do.
        before, after = enclosed(points, triangles), enclosed(points + 0.01 * normals, triangles)
        self.assertGreater(before, 0)
        self.assertAlmostEqual((after - before) / (0.01 * report["mesh"]["area"]), 1, delta=0.1)

    def test_vtk_and_we_agree_on_dx(self):
        import numpy

        self.meniscus("surface", foreign.UBIQUITIN, "-o", "a.mrc", "-o", "a.dx")
        lines = (self.folder / "a.dx").read_text().splitlines()
        start = next(i for i, line in enumerate(lines) if line.endswith("data follows"))
        counts = [int(n) for n in next(line for line in lines if "gridpositions" in line).split()[-3:]]
        rows = " ".join(lines[start + 1:-5])
        values = numpy.array(rows.split(), dtype=numpy.float32).reshape(counts)
        import mrcfile

        with mrcfile.open(self.folder / "a.mrc") as file:
            self.assertTrue((file.data == values.transpose(2, 1, 0)).all())


foreign.main(modules=["vtk", "mrcfile", "numpy"])
