"""wirepack figures: the data behind the pictures are right, wrong input is refused."""

import unittest

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
        for name in ("packing", "section", "force", "energy"):
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

    def test_what_is_not_a_result_is_a_file_error_and_leaves_nothing(self):
        self.write("text.h5", "no result")
        for name in ("missing.h5", "text.h5"):
            code, _, err = self.run_program("figures", name, "-o", "figures")
            self.assertEqual(code, 5)
            self.assertEqual(len(err.strip().splitlines()), 1, err)
            self.assertFalse((self.folder / "figures").exists())


if __name__ == "__main__":
    unittest.main()
