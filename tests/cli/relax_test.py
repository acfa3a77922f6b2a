#!/usr/bin/python3
"""The example relax_without_friction, which WIREPACK_RELAX names: minima without friction."""

import os
import re
import subprocess
import unittest

import h5py
from support import ProgramTest

RUN = """
[cavity]
radius = 4
[wire]
edge_length = 0.8
[insertion]
increment = 0.8
[friction]
model = "coulomb"
[stop]
density = 0.3
"""


class Relaxing(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("run.toml", RUN)

    def relax(self, *arguments):
        return subprocess.run([os.environ["WIREPACK_RELAX"], *arguments], cwd=self.folder,
                              text=True, capture_output=True)

    def pack(self, output, *settings):
        code, _, err = self.run_program("run", "run.toml", "-o", output, *settings)
        self.assertEqual(code, 0, err)

    def test_energies_of_a_frame_fall_to_a_minimum(self):
        self.pack("run.h5")
        with h5py.File(self.folder / "run.h5") as file:
            frames = sorted(file["frames"], key=int)
            energy = dict(zip(file["history/increment"][()], file["history/energy_total"][()]))
        unit = 5 * 3.141592653589793 / 4 / 4  # YI / R
        for arguments, frame in ((["run.h5"], frames[-1]),
                                 (["run.h5", str(int(frames[-9]))], frames[-9])):
            done = self.relax(*arguments)
            self.assertEqual(done.returncode, 0, done.stderr)
            rows = re.findall(r"^(?:with friction|relaxed) +(\S+) +(\S+) +(\S+) +(\S+)$",
                              done.stdout, re.M)
            (before, bend, _, order), (after, *_) = [[float(x) for x in row] for row in rows]
            self.assertAlmostEqual(before * unit, energy[int(frame)], delta=1e-3 * before * unit)
            self.assertLess(after, 0.99 * before)
            self.assertLess(bend, before)
            self.assertLessEqual(order, 1)
            self.assertRegex(done.stdout, r"farthest move \S+ a, residual 0\.\d+, a minimum\n$")

    def test_wrong_input_is_one_message(self):
        self.pack("run.h5")
        self.pack("smooth.h5", "--set", "friction.model=none")
        self.write("text.h5", "no result")
        for arguments, code, message in (
            ([], 2, "relax_without_friction: usage: RESULT.h5 [INCREMENT]"),
            (["run.h5", "1", "2"], 2, "usage: RESULT.h5 [INCREMENT]"),
            (["missing.h5"], 5, "missing.h5: there is no such file"),
            (["text.h5"], 5, "text.h5: is not an HDF5 file"),
            (["run.h5", "9999"], 2, 'no frame "9999"; increments with a frame: 1 '),
            (["run.h5", "last"], 2, 'no frame "last"; increments with a frame: 1 '),
            (["smooth.h5"], 2, 'friction.model = "none": the result is of a run without friction'),
        ):
            done = self.relax(*arguments)
            self.assertEqual((done.returncode, done.stdout), (code, ""), arguments)
            self.assertIn(message, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
