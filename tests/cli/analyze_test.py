#!/usr/bin/python3
"""What `wirepack analyze` prints is what the result file holds."""

import json
import math
import unittest

import h5py
import numpy

from support import ProgramTest

RUN = """
[packing]
setup = "high_torsion"
[cavity]
radius = 5
[friction]
model = "coulomb"
[imperfection]
natural_curvature = 0.1
nozzle_offset = 0.5
nozzle_tilt = 0.05
[stop]
density = 0.2
"""


class Analyze(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("run.toml", RUN)
        code, _, err = self.run_program("run", "run.toml", "-o", "run.h5")
        self.assertEqual(code, 0, err)

    def analyze(self, *arguments):
        code, out, err = self.run_program("analyze", "run.h5", *arguments)
        self.assertEqual(code, 0, err)
        return out

    def test_numbers_are_those_of_the_file(self):
        code, out, err = self.run_program(
            "analyze", "run.h5", "--density", "0.1,0.2,0.9", "--json"
        )
        self.assertEqual(code, 0, err)
        self.assertIn("no frame at density 0.9", err)
        rows = json.loads(out)["frames"]
        self.assertEqual(len(rows), 2)
        unit = 5 * math.pi / 4 / 5  # YI / R
        with h5py.File(self.folder / "run.h5") as file:
            for row, density in zip(rows, (0.1, 0.2)):
                self.assertAlmostEqual(row["packing_density"], density, delta=0.01)
                k = list(file["history/increment"]).index(row["increment"])
                self.assertAlmostEqual(
                    row["bend_energy"] * unit, file["history/energy_bend"][k], delta=1e-9
                )
                self.assertEqual(row["scaled_force"], file["history/scaled_force"][k])
                self.assertTrue(-0.5 <= row["axis_order"] <= 1)
                self.assertAlmostEqual(row["tip_rotation"], row["twist"] + row["writhe"])
            self.assertEqual(file["setup/nozzle_position"].shape, (3,))
            self.assertGreater(abs(file["setup/rest_darboux"][0]), 0)
            self.assertLess(abs(file["setup/rest_darboux"][0]), 0.1 / 5)

    def test_shells_hold_the_volume_of_the_wire(self):
        row = json.loads(self.analyze("--json"))["frames"][0]
        volume = sum(
            s["density"] * 4 / 3 * math.pi * (s["outer"] ** 3 - s["inner"] ** 3)
            for s in row["radial_density"]
        )
        with h5py.File(self.folder / "run.h5") as file:
            nodes = file[f"frames/{row['increment']:06d}/position"][:]
        # of the compressed wire; the disc in the nozzle is partly outside of the cavity
        length = numpy.linalg.norm(numpy.diff(nodes, axis=0), axis=1).sum()
        self.assertAlmostEqual(volume / (math.pi * length), 1, delta=0.005)

    def test_phi_max_is_where_the_history_first_reaches_a_level(self):
        levels = json.loads(self.analyze("--json"))["frames"][0]["phi_max"]
        with h5py.File(self.folder / "run.h5") as file:
            force = file["history/scaled_force"][:]
            density = file["history/packing_density"][:]
        scaled = [l for l in levels if l["scale"] == "scaled_force"]
        self.assertGreater(len(scaled), 3)
        for level in scaled:
            reached = density[force >= level["level"]]
            self.assertAlmostEqual(level["first"], reached[0], delta=1e-12)
            if level["mean_over_edge"] is not None:
                self.assertGreaterEqual(level["mean_over_edge"], level["first"])

    def test_runs_that_differ_in_the_seed_are_averaged(self):
        self.write("other.toml", RUN.replace("[packing]", "[packing]\nseed = 2"))
        code, _, err = self.run_program("run", "other.toml", "-o", "other.h5")
        self.assertEqual(code, 0, err)
        result = json.loads(self.analyze("other.h5", "--json"))
        (ensemble,) = result["ensembles"]
        energies = [row["bend_energy"] for row in result["frames"]]
        found = ensemble["frames"][0]["bend_energy"]
        self.assertAlmostEqual(found["mean"], sum(energies) / 2)
        # of two: half their difference
        self.assertAlmostEqual(found["standard_error"], abs(energies[0] - energies[1]) / 2)

    def test_table_and_csv_have_every_number(self):
        table = self.analyze()
        names, values = [line.split(",") for line in self.analyze("--csv").splitlines()]
        self.assertEqual(len(names), len(values))
        for name in names[1:]:
            self.assertIn("\n" + name, table)

    def test_wrong_questions_get_an_answer(self):
        self.assertEqual(self.run_program("analyze", "no.h5")[0], 5)
        self.assertEqual(self.run_program("analyze", "run.toml")[0], 5)
        code, _, err = self.run_program("analyze", "run.h5", "--density", "7")
        self.assertEqual(code, 2)
        self.assertIn("--density", err)
        code, out, err = self.run_program("analyze", "run.h5", "--density", "0.9")
        self.assertEqual((code, out), (2, ""))
        self.assertIn("frames are from", err)


if __name__ == "__main__":
    unittest.main()
