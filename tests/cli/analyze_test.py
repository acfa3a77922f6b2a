#!/usr/bin/python3
"""What `wirepack analyze` prints is what the result file holds."""

import json
import math
import unittest

import h5py

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
        rows = json.loads(self.analyze("--density", "0.1,0.2,0.9", "--json"))
        self.assertEqual(len(rows), 2)  # 0.9 was not reached
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

    def test_the_table_has_a_line_for_each_run(self):
        lines = self.analyze().splitlines()
        self.assertEqual(len(lines), 3)
        self.assertEqual(len(lines[0].split()), len(lines[2].split()))

    def test_wrong_questions_get_an_answer(self):
        self.assertEqual(self.run_program("analyze", "no.h5")[0], 5)
        self.assertEqual(self.run_program("analyze", "run.toml")[0], 5)
        code, _, err = self.run_program("analyze", "run.h5", "--density", "7")
        self.assertEqual(code, 2)
        self.assertIn("--density", err)


if __name__ == "__main__":
    unittest.main()
