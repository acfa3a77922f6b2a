#!/usr/bin/python3
"""Stiffness and units as users give them, warnings, and what a run says about going on."""

import re
import unittest

import h5py

from support import ProgramTest, SMALL_RUN

DNA = """
[wire]
radius = 1
persistence_length = 50
temperature = 300
[cavity]
radius = 4
[stop]
increments = 60
[output]
frame_every_density = 0.001
"""


class Inputs(ProgramTest):
    def run_config(self, text, *arguments, code=0):
        self.write("run.toml", text)
        returned, out, err = self.run_program("run", "run.toml", "-o", "out.h5", *arguments)
        self.assertEqual(returned, code, err)
        return out, err

    def test_a_persistence_length_gives_forces_in_piconewtons_and_energies_in_k_B_T(self):
        out, err = self.run_config(DNA)
        self.assertEqual(err, "")
        force = re.search(r"# force +(\S+) YI/R\^2 = (\S+) pN", out)
        unit = 1.380649e-2 * 300 * 50 / 4**2  # k_B T l_p / R^2 in pN
        self.assertAlmostEqual(float(force[2]) / float(force[1]) / unit, 1, places=3)
        energy = re.search(r"stored energy +(\S+) YI/R = (\S+) k_B T", out)
        self.assertAlmostEqual(float(energy[2]) / float(energy[1]) / (50 / 4), 1, places=3)
        with h5py.File(self.folder / "out.h5") as file:
            self.assertEqual(file.attrs["force_unit"], "pN")
            self.assertEqual(file.attrs["warnings"], "")

    def test_a_dry_run_with_units_gives_itself(self):
        self.write("run.toml", DNA)
        _, first, _ = self.run_program("run", "run.toml", "--dry-run")
        self.assertIn("EI = 207.097", first)
        self.write("again.toml", first)
        _, second, _ = self.run_program("run", "again.toml", "--dry-run")
        self.assertEqual(first, second)

    def test_warnings_come_once_and_are_in_the_file(self):
        rows = "[[0, 0, 2, 0], [3, 0, 2, 0], [3.5, 0, 0, 0], [99, 0, 0, 0]]"
        shape = f"[wire]\nreference_shape = {rows}\n"
        text = shape + "edge_length = 0.5\n[cavity]\nradius = 4\n[stop]\nincrements = 8\n"
        _, err = self.run_config(text)
        tight = "at rest the wire bends to a radius of 0.5, tighter than its own, wire.radius = 1"
        self.assertEqual(err.count(tight), 1, err)
        self.assertIn("fewer than 5 frames", err)
        with h5py.File(self.folder / "out.h5") as file:
            self.assertEqual(file.attrs["warnings"].count(tight), 1)

    def test_a_wire_may_twist_more_easily_than_a_solid_one_which_is_said(self):
        text = "[wire]\nbending_stiffness = 2\ntorsional_stiffness = 0.5\n[cavity]\nradius = 4\n"
        _, err = self.run_config(text + "[stop]\nincrements = 8\n")
        self.assertIn("GJ = 0.5 is below two thirds of EI = 2", err)

    def test_a_lost_run_goes_on_with_other_minimizer_values_which_the_file_keeps(self):
        few = ["--set", "minimizer.max_evaluations = 3"]
        _, err = self.run_config(SMALL_RUN, *few, code=3)
        self.assertIn("go on by --resume with other values", err)
        _, err = self.run_config(SMALL_RUN, *few, "--resume", code=3)
        self.assertIn("is finished: no_equilibrium; go on by --resume", err)
        _, err = self.run_config(SMALL_RUN, "--resume", "--set", "packing.seed=3", code=2)
        self.assertIn("packing.seed: was 1, is now 3", err)
        _, err = self.run_config(SMALL_RUN, "--resume")
        with h5py.File(self.folder / "out.h5") as file:
            changes = file.attrs["search_changes"]
            self.assertEqual(file.attrs["stop_reason"], "increments")
        self.assertRegex(
            changes, r"^after increment \d+: minimizer.max_evaluations: was 3, is now \d+$"
        )

    def test_all_differences_of_a_refused_continuation_are_listed(self):
        self.run_config(SMALL_RUN, "--set", "stop.increments=5")
        _, err = self.run_config(SMALL_RUN, "--resume", "--set", "cavity.radius=5", code=2)
        self.assertRegex(err, "configuration: cavity.radius: was 4.0, is now 5.0\n")

    def test_a_run_whose_table_nobody_reads_ends_quietly_with_all_saved(self):
        self.write("run.toml", SMALL_RUN.replace("60", "100000"))
        process = self.run_until(3, "out.h5")
        process.stdout.close()
        err = process.stderr.read()
        process.stderr.close()
        self.assertEqual(process.wait(60), 75, err)
        self.assertRegex(
            err, r"^wirepack run: nobody reads the table .*--resume goes on from there\n$"
        )
        with h5py.File(self.folder / "out.h5") as file:
            self.assertGreaterEqual(len(file["history/force"]), 3)

    def test_a_dry_run_estimates_the_size_within_30_percent(self):
        for radius, density in [(4, 0.3), (8, 0.04)]:
            text = f"[cavity]\nradius = {radius}\n[stop]\ndensity = {density}\n"
            out, _ = self.run_config(text, "--force")
            _, plan, _ = self.run_program("run", "run.toml", "--dry-run")
            estimate = 1e6 * float(re.search(r"(\S+) MB", plan)[1])
            size = (self.folder / "out.h5").stat().st_size
            self.assertLess(abs(estimate / size - 1), 0.3, plan)
            self.assertIn("# next: wirepack view out.h5", out.splitlines()[-1])

    def test_compare_says_its_least_density_before_it_computes(self):
        self.write("run.toml", "[cavity]\nradius = 10\n")
        code, out, err = self.run_program("compare", "run.toml", "-o", "out", "--density", "0.02")
        self.assertEqual((code, out), (2, ""))
        self.assertRegex(err, r"--density 0.02: must be at least 0\.\d+")
        self.assertEqual(self.names(), ["run.toml"])


if __name__ == "__main__":
    unittest.main()
