"""wirepack figures: the data behind the pictures are right, wrong input is refused."""

import unittest

import h5py
import numpy

from support import SMALL_RUN, ProgramTest


class Figures(ProgramTest):
    def make_result(self, name="result.h5"):
        self.write("scenario.toml", SMALL_RUN)
        code, _, err = self.run_program("run", "scenario.toml", "-o", name)
        self.assertEqual(code, 0, err)

    def test_tube_keeps_its_radius_is_closed_and_every_colour_is_a_number(self):
        self.make_result()
        code, out, err = self.run_program("figures", "result.h5", "-o", "figures")
        self.assertEqual(code, 0, err)
        self.assertIn("packing.png", out)
        text = (self.folder / "figures" / "packing.dat").read_text()
        rings = [
            numpy.array([line.split() for line in block.splitlines() if line[:1] != "#"], float)
            for block in text.split("\n\n")
            if block.strip()
        ]
        self.assertGreater(len(rings), 30)
        for k, ring in enumerate(rings):
            self.assertTrue(numpy.isfinite(ring).all())
            centre = ring[:-1, :3].mean(axis=0)
            distance = numpy.linalg.norm(ring[:, :3] - centre, axis=1)
            at_end = k in (0, len(rings) - 1)
            numpy.testing.assert_allclose(distance, 0 if at_end else 1, atol=1e-3)
        drawn = ("packing", "section", "force", "energy", "torsion", "bend_distribution")
        for name in drawn:
            for ending, start in ((".png", b"\x89PNG"), (".pdf", b"%PDF"), (".svg", b"<?xml")):
                data = (self.folder / "figures" / (name + ending)).read_bytes()
                self.assertEqual(data[: len(start)], start)
                self.assertGreater(len(data), 4000)

    def test_sections_are_ellipses_of_the_wire_inside_the_cavity(self):
        self.make_result()
        code, _, err = self.run_program("figures", "result.h5", "-o", "figures")
        self.assertEqual(code, 0, err)
        rows = numpy.loadtxt(self.folder / "figures" / "section.dat", ndmin=2)
        self.assertGreater(len(rows), 0)
        self.assertTrue((numpy.hypot(rows[:, 0], rows[:, 1]) < 5).all())
        self.assertTrue((rows[:, 3] == 2).all())  # a diameter
        self.assertTrue((rows[:, 2] >= rows[:, 3]).all())

    def test_the_frame_is_the_one_that_was_asked_for(self):
        self.make_result()
        for number, option in enumerate((("--frame", "1"), ("--density", "0.01"))):
            code, _, err = self.run_program(
                "figures", "result.h5", "-o", f"early{number}", *option
            )
            self.assertEqual(code, 0, err)
        self.assertEqual(
            (self.folder / "early0" / "packing.dat").read_text(),
            (self.folder / "early1" / "packing.dat").read_text(),
        )
        for option in (("--frame", "100000"), ("--density", "0.9")):
            code, _, err = self.run_program("figures", "result.h5", "-o", "no", *option)
            self.assertEqual(code, 2, err)
            self.assertIn("frames", err)
            self.assertFalse((self.folder / "no").exists())

    def test_names_with_quotes_and_underscores_are_drawn_to_the_letter(self):
        name = "it's a_\"b\".h5"
        self.make_result(name)
        code, _, err = self.run_program("figures", name, "-o", "fig'ures")
        self.assertEqual(code, 0, err)
        self.assertIn("a_", (self.folder / "fig'ures" / "force.svg").read_text())

    def make_packing(self, name, seed, *more):
        """A run by half edges; returns its columns."""
        if not (self.folder / "packing.toml").exists():
            self.write(
                "packing.toml",
                "[cavity]\nradius = 4\n[stop]\ndensity = 0.6\n"
                "[wire]\nedge_length = 1\n[insertion]\nincrement = 0.5\n",
            )
        code, _, err = self.run_program(
            "run", "packing.toml", "-o", name, "--set", f"packing.seed={seed}", *more
        )
        self.assertEqual(code, 0, err)
        with h5py.File(self.folder / name) as result:
            return {key: column[:] for key, column in result["history"].items()}

    def blocks(self, figure):
        """The blocks of numbers of a figure's data."""
        text = (self.folder / "figures" / (figure + ".dat")).read_text()
        return [
            numpy.loadtxt(block.splitlines(), ndmin=2)
            for block in text.split("\n\n\n")
            if block.strip()
        ]

    def test_seeds_of_one_scenario_are_drawn_as_their_mean_with_its_standard_error(self):
        runs = [self.make_packing(f"{seed}.h5", seed) for seed in (1, 2, 3)]
        code, _, err = self.run_program("figures", "1.h5", "2.h5", "3.h5", "-o", "figures")
        self.assertEqual(code, 0, err)
        self.assertEqual(len(self.blocks("force")), 2)  # the mean, and the model
        mean = self.blocks("force")[0]
        density = mean[:, 0]
        for column, key, unit in ((1, "scaled_force", 1), (3, "energy_bend", 5 * numpy.pi / 4 / 4)):
            values = [numpy.interp(density, r["packing_density"], r[key] / unit) for r in runs]
            inside = slice(30, -2)
            numpy.testing.assert_allclose(
                mean[inside, column], numpy.mean(values, axis=0)[inside], rtol=1e-3, atol=1e-3
            )
            error = numpy.std(values, axis=0, ddof=1) / numpy.sqrt(3)
            numpy.testing.assert_allclose(
                mean[inside, column + 1], error[inside], rtol=1e-3, atol=1e-3
            )

    @staticmethod
    def mean_force(run):
        """Of each row over an edge length of 1; zero until an edge after the first coil."""
        length, force = run["inserted_length"], run["scaled_force"]
        work = numpy.concatenate(
            ([0], numpy.cumsum(numpy.diff(length) * (force[1:] + force[:-1]) / 2))
        )
        mean = work - numpy.interp(length - 1, length, work)
        after = length[length > 2 * (1 + numpy.pi) * 4]
        mean[length < after[0] + 1 - 1e-9] = 0
        return mean

    def test_phi_max_is_the_first_density_after_the_first_coil_whose_mean_force_is_high(self):
        run = self.make_packing("1.h5", 1)
        length, force = run["inserted_length"], run["scaled_force"]
        mean = self.mean_force(run)
        highest = mean.argmax()
        code, _, err = self.run_program(
            "figures", "1.h5", "-o", "figures", "--threshold", str(0.9999 * mean[highest])
        )
        self.assertEqual(code, 0, err)
        ((ratio, density, error, count),) = self.blocks("phi_max")[0]
        self.assertEqual((ratio, error, count), (0.25, 0, 1))
        self.assertAlmostEqual(density, run["packing_density"][highest], delta=1e-9)
        self.assertIn("Stoop", (self.folder / "figures" / "phi_max.gp").read_text())
        code, out, err = self.run_program(
            "figures", "1.h5", "-o", "none", "--threshold", str(100 * mean[highest])
        )
        self.assertEqual(code, 0, err)
        self.assertIn("no phi_max: no run reaches", out)
        self.assertFalse((self.folder / "none" / "phi_max.png").exists())

    def test_phi_max_of_seeds_is_one_point_and_other_friction_another_series(self):
        curved = ("--set", "imperfection.natural_curvature=0.3")
        friction = ("--set", "friction.model='coulomb'", "--set", "stop.density=0.5")
        runs = [self.make_packing(f"{seed}.h5", seed, *curved) for seed in (1, 2)]
        runs.append(self.make_packing("rough.h5", 1, *curved, *friction))
        means = [self.mean_force(run) for run in runs]
        threshold = 0.9 * min(mean.max() for mean in means)
        code, _, err = self.run_program(
            "figures", "1.h5", "2.h5", "rough.h5", "-o", "figures", "--threshold", str(threshold)
        )
        self.assertEqual(code, 0, err)
        first = [
            run["packing_density"][(mean >= threshold).argmax()] for run, mean in zip(runs, means)
        ]
        smooth, rough = self.blocks("phi_max")
        self.assertNotEqual(first[0], first[1])
        numpy.testing.assert_allclose(
            smooth, [[0.25, (first[0] + first[1]) / 2, abs(first[0] - first[1]) / 2, 2]], rtol=1e-5
        )
        numpy.testing.assert_allclose(rough, [[0.25, first[2], 0, 1]], rtol=1e-5)
        key = (self.folder / "figures" / "phi_max.gp").read_text()
        self.assertIn("low torsion, as 1", key)
        self.assertIn("low torsion, as rough", key)

    def test_bend_energies_over_their_mean_are_spread_with_an_area_of_one(self):
        self.make_packing("1.h5", 1)
        code, _, err = self.run_program("figures", "1.h5", "-o", "figures")
        self.assertEqual(code, 0, err)
        bars = self.blocks("bend_distribution")[0]
        width = numpy.diff(numpy.log(bars[:, 0]))
        numpy.testing.assert_allclose(width, 0.25, rtol=1e-3)
        self.assertAlmostEqual((bars[:, 1] * 0.25).sum(), 1, delta=0.05)
        with h5py.File(self.folder / "1.h5") as result:
            frames = result["frames"]
            energy = frames[sorted(frames)[-1]]["bend_energy"][:]
        energy = energy[energy > 0]
        logs = numpy.log(energy / energy.mean())
        expected = numpy.average(numpy.log(bars[:, 0]), weights=bars[:, 1])
        self.assertAlmostEqual(expected, logs.clip(-9, 4).mean(), delta=0.13)

    def test_what_is_not_a_result_is_a_file_error_and_leaves_nothing(self):
        self.write("text.h5", "no result")
        for name in ("missing.h5", "text.h5"):
            code, _, err = self.run_program("figures", name, "-o", "figures")
            self.assertEqual(code, 5)
            self.assertEqual(len(err.strip().splitlines()), 1, err)
            self.assertFalse((self.folder / "figures").exists())


if __name__ == "__main__":
    unittest.main()
