#!/usr/bin/env python3
"""Reads with meshio what `stylet run --vtu` leaves, and compares it with the run's recording and with known displacements."""

import argparse
import csv
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree as ElementTree

import meshio
import numpy

given = None    # the command line

SINGLE = 2.0**-23    # of a number: what single precision leaves of it
LONGEST = 0.4        # [m] no coordinate of the scenes here is larger
NEARLY = LONGEST * SINGLE    # [m] so true are coordinates
CUT = 1.1e-5    # [m] what the tip cuts in a tick at 10 mm/s, and a little more


def run(folder, *arguments):
    command = [given.stylet, "run", *map(str, arguments), "--quiet", "--vtu", "pictures"]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300)


def moments(pvd):
    """(time, file) of each moment that a PVD file lists."""
    root = ElementTree.parse(pvd).getroot()
    assert root.tag == "VTKFile" and root.get("type") == "Collection", pvd
    return [(float(one.get("timestep")), pvd.parent / one.get("file")) for one in root.find("Collection")]


def whole_series(pvd):
    """(time, mesh) of each moment; every file must be there and be read."""
    return [(at, meshio.read(file)) for at, file in moments(pvd)]


def recording(file):
    """Rows of a recording by their time, each a map of column names without units."""
    with open(file) as lines:
        rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    names = [cell.split(" ")[0] for cell in rows[0][:-1]]
    return {float(row[0]): dict(zip(names, map(float, row[:-1]))) for row in rows[1:]}


def distinct(numbers):
    """The numbers that differ by more than rounding, ascending."""
    ascending = numpy.sort(numbers)
    return ascending[numpy.diff(ascending, prepend=-numpy.inf) > 4 * NEARLY]


def only(values):
    assert len(values) == 1
    return float(values[0])


class Fig9(unittest.TestCase):
    """The needle touches, buckles, punctures, is straight again and buckles a second time."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        path = pathlib.Path(cls.folder.name)
        done = run(path, given.scenes / "paper/fig9.yaml", "--vtu-rate", "10 Hz")
        assert done.returncode == 0, done.stderr
        cls.needle = whole_series(path / "pictures/fig9_needle.pvd")
        cls.tissue = whole_series(path / "pictures/fig9_tissue.pvd")
        cls.contacts = whole_series(path / "pictures/fig9_contacts.pvd")
        cls.rows = recording(path / "out/fig9.csv")
        cls.files = sorted(file.name for file in (path / "pictures").iterdir())

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def recorded(self, series):
        """(row of the recording, mesh) of each moment but the first, which no row tells of."""
        return [(self.rows[at], mesh) for at, mesh in series[1:]]

    def test_a_moment_comes_every_tenth_of_a_second_from_the_start_on(self):
        for series in (self.needle, self.tissue, self.contacts):
            times = [at for at, _ in series]
            numpy.testing.assert_allclose(times, numpy.arange(86) / 10.0, atol=1e-12)    # 8.5 s
            self.assertEqual(times, [only(mesh.field_data["TimeValue"]) for _, mesh in series])

    def test_nothing_else_is_written(self):
        names = [f"fig9_{body}_{i:04}.vtu" for body in ("contacts", "needle", "tissue") for i in range(86)]
        self.assertEqual(self.files, sorted(names + [f"fig9_{body}.pvd" for body in ("contacts", "needle", "tissue")]))

    def test_the_needle_is_a_row_of_lines_and_the_tissue_a_block_of_hexahedra(self):
        for _, mesh in self.needle:
            self.assertEqual(mesh.points.shape, (101, 3))
            numpy.testing.assert_array_equal(mesh.cells_dict["line"], [(i, i + 1) for i in range(100)])
        for _, mesh in self.tissue:
            self.assertEqual(len(mesh.points), 25 * 25 * 14)    # 13, and the border at 30 mm
            self.assertEqual(mesh.cells_dict["hexahedron"].shape, (24 * 24 * 13, 8))

    def test_the_needles_tip_is_as_deep_as_the_recording_says(self):
        for row, mesh in self.recorded(self.needle):
            self.assertAlmostEqual(-mesh.points[-1, 2], row["depth"], delta=NEARLY)
            self.assertEqual(only(mesh.field_data["depth"]), row["depth"])
            self.assertEqual(only(mesh.field_data["hand_force"]), row["hand_force"])

    def test_a_buckled_needle_shows_its_bow(self):
        sampling = 1e-3    # of the bow: the middle of a half sine lies between two of 101 points
        buckled = 0
        for row, mesh in self.recorded(self.needle):
            bow = numpy.abs(mesh.points[:, 0]).max()    # it bows along x
            self.assertAlmostEqual(bow, row["deflection"], delta=NEARLY + sampling * row["deflection"])
            self.assertEqual(only(mesh.field_data["buckled"]), float(row["deflection"] > 0.0))
            buckled += row["deflection"] > 1e-3
        print(f"{buckled} of {len(self.needle)} moments show a bow of more than a millimetre")
        self.assertGreater(buckled, 20)

    def test_the_needle_knows_which_of_its_points_are_inside(self):
        for row, mesh in self.recorded(self.needle):
            arclength, inside = mesh.point_data["arclength"], mesh.point_data["inside"]
            numpy.testing.assert_allclose(arclength, numpy.linspace(0.0, 0.2, 101), atol=NEARLY)
            clear = numpy.abs(arclength - row["free_length"]) > NEARLY
            numpy.testing.assert_array_equal(inside[clear], arclength[clear] > row["free_length"])
            numpy.testing.assert_allclose(mesh.point_data["radius"], 0.3e-3, rtol=SINGLE)

    def test_contact_forces_add_up_to_what_the_hand_holds(self):
        pushed = 0
        for row, mesh in self.recorded(self.contacts):
            force = mesh.point_data["force"].sum(axis=0)
            self.assertAlmostEqual(force[2], row["hand_force"], delta=100 * SINGLE)    # a dozen forces of up to 1.4 N
            self.assertEqual(mesh.point_data["tip"].sum(), 1.0)
            pushed += row["hand_force"] > 0.1
        self.assertGreater(pushed, 50)

    def test_the_tips_contact_is_where_the_needle_has_its_tip(self):
        for (_, contacts), (_, needle) in zip(self.contacts, self.needle):
            tip = contacts.points[contacts.point_data["tip"] == 1.0][0]
            numpy.testing.assert_allclose(tip, needle.points[-1], atol=CUT + NEARLY)

    def test_the_dent_is_as_deep_as_the_tip_until_the_surface_ruptures_and_springs_back(self):
        grip = 1e-6    # of the dent: so firmly does the coupling hold the tip on the tissue
        entry = numpy.flatnonzero((numpy.abs(self.tissue[0][1].points) < NEARLY).all(axis=1))
        self.assertEqual(len(entry), 1)
        dents = [(row, -mesh.point_data["displacement"][entry[0], 2]) for row, mesh in self.recorded(self.tissue)]
        pressed = [(row["depth"], dent) for row, dent in dents if row["depth"] > 0.0 and row["inserted"] == 0.0]
        for depth, dent in pressed:
            self.assertAlmostEqual(dent, depth, delta=NEARLY + grip * depth)
        deepest = pressed[-1][1]
        after = [dent for row, dent in dents if row["inserted"] > 0.0]
        print(f"dent {1e3 * deepest:.2f} mm, after the puncture {1e3 * after[0]:.2f} mm")
        self.assertGreater(deepest, 0.03)
        self.assertLess(after[0], 0.1 * deepest)

    def test_a_layer_of_cells_ends_at_its_border(self):
        for _, mesh in self.tissue[:1]:
            below = mesh.points[mesh.cells_dict["hexahedron"], 2].max(axis=1) < -0.03 + NEARLY
            numpy.testing.assert_array_equal(mesh.cell_data["layer"][0], below)
            self.assertEqual(only(mesh.field_data["layer 0: upper"]), 25e3)
            self.assertEqual(only(mesh.field_data["layer 1: lower"]), 25e3)

    def test_cells_are_finest_where_the_needle_goes_in(self):
        points = self.tissue[0][1].points
        apart = numpy.diff(distinct(points[:, 0]))
        self.assertAlmostEqual(apart.min(), 0.3e-3, delta=2 * NEARLY)    # its radius
        self.assertIn(0.0, points[:, 0])


class KnownDisplacement(unittest.TestCase):
    """A tissue alone, without a needle: u = t·(x/10, y/5 + z/4, −z/10), which is at rest as the simulation begins."""

    SCENE = """
stylet: 1
title: Stretched
tissue:
  type: stretching
  extent: [100 mm, 60 mm, 30 mm]
  fixed: bottom
  layers:
    - {name: "fat & <skin>", youngs_modulus: 10 kPa, poisson_ratio: 0.49, thickness: 11 mm}
    - {name: muscle, youngs_modulus: 25 kPa, poisson_ratio: 0.49}
run: {rate: 100 Hz, duration: 1 s}
"""

    def stretched(self, folder, *arguments):
        (folder / "stretched.yaml").write_text(self.SCENE)
        done = run(folder, "stretched.yaml", "--plugin-dir", given.plugins, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return folder / "pictures/stretched_tissue.pvd"

    def test_points_are_where_the_tissue_is_and_displacement_says_from_where(self):
        with tempfile.TemporaryDirectory() as folder:
            series = whole_series(self.stretched(pathlib.Path(folder)))
        self.assertEqual(len(series), 26)
        undeformed = series[0][1].points - series[0][1].point_data["displacement"]
        for at, mesh in series:
            x, y, z = (mesh.points - mesh.point_data["displacement"]).T
            numpy.testing.assert_allclose(numpy.array([x, y, z]).T, undeformed, atol=2 * NEARLY)
            expected = at * numpy.array([x / 10, y / 5 + z / 4, -z / 10]).T
            numpy.testing.assert_allclose(mesh.point_data["displacement"], expected, atol=2 * NEARLY)

    def test_cells_are_not_inside_out_and_fill_the_block(self):
        with tempfile.TemporaryDirectory() as folder:
            mesh = whole_series(self.stretched(pathlib.Path(folder)))[0][1]
        points = mesh.points - mesh.point_data["displacement"]
        corner, x, y, z = (points[mesh.cells_dict["hexahedron"][:, i]].astype(float) for i in (0, 1, 3, 4))    # in VTK's order
        volumes = numpy.einsum("ij,ij->i", numpy.cross(x - corner, y - corner), z - corner)
        self.assertGreater(volumes.min(), 0.0)
        self.assertAlmostEqual(volumes.sum(), 0.1 * 0.06 * 0.03, delta=1e-6 * volumes.sum())

    def test_without_a_needle_cells_are_even_and_no_other_series_is_written(self):
        with tempfile.TemporaryDirectory() as folder:
            pvd = self.stretched(pathlib.Path(folder))
            self.assertEqual([file.name for file in pvd.parent.glob("*.pvd")], ["stretched_tissue.pvd"])
            mesh = whole_series(pvd)[0][1]
        x, y, z = (distinct(axis) for axis in (mesh.points - mesh.point_data["displacement"]).T)
        numpy.testing.assert_allclose(x, numpy.linspace(-0.05, 0.05, 25), atol=2 * NEARLY)
        numpy.testing.assert_allclose(y, numpy.linspace(-0.03, 0.03, 25), atol=2 * NEARLY)
        numpy.testing.assert_allclose(z, sorted([*numpy.linspace(-0.03, 0.0, 13), -0.011]), atol=2 * NEARLY)
        self.assertIn("layer 0: fat & <skin>", mesh.field_data)

    def test_a_displacement_that_is_not_a_number_leaves_files_that_open(self):
        with tempfile.TemporaryDirectory() as folder:
            pvd = self.stretched(pathlib.Path(folder), "--set", "tissue.stretching={lost_after: 0.5 s}")
            sizes = [int(ElementTree.parse(file).find(".//Piece").get("NumberOfPoints")) for _, file in moments(pvd)]
        self.assertEqual(sizes, [25 * 25 * 14] * 13 + [0] * 13)


class AKilledRun(unittest.TestCase):
    def test_leaves_a_series_that_opens(self):
        for lives in (1, 3, 10, 30, 100):    # moments that have been written when it is killed
            with tempfile.TemporaryDirectory() as folder:
                pvd = pathlib.Path(folder) / "pictures/fig9_contacts.pvd"    # the last to be written
                command = [given.stylet, "run", given.scenes / "paper/fig9.yaml", "--quiet", "--vtu", "pictures", "--vtu-rate", "1 kHz"]
                with subprocess.Popen(command, cwd=folder) as process:
                    while not pvd.exists() or pvd.read_text().count("<DataSet") < lives:
                        self.assertIsNone(process.poll(), "ended by itself")
                        time.sleep(0.001)
                    time.sleep(random.uniform(0.0, 0.005))    # anywhere in what it writes next
                    process.kill()
                    self.assertEqual(process.wait(), -signal.SIGKILL)
                lengths = [len(whole_series(pvd.parent / f"fig9_{body}.pvd")) for body in ("tissue", "needle", "contacts")]
                print(f"killed after {lives} moments: {lengths} open")
                self.assertGreaterEqual(min(lengths), lives)
                self.assertLessEqual(max(lengths) - min(lengths), 1)    # tissue is written first


if __name__ == "__main__":
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--stylet", required=True)
    options.add_argument("--scenes", required=True, type=pathlib.Path)
    options.add_argument("--plugins", required=True)
    given, rest = options.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
