"""wirepack.py reads what the program writes, at any moment of a run."""

import os
import signal
import subprocess
import sys
import time
import unittest

import h5py
import numpy

from support import SMALL_RUN, ProgramTest

sys.path.insert(0, os.environ["WIREPACK_READER"])
import wirepack  # noqa: E402


class PythonReader(ProgramTest):
    def make_result(self, text=SMALL_RUN):
        self.write("scenario.toml", text)
        code, _, err = self.run_program("run", "scenario.toml", "-o", "run.h5")
        self.assertEqual(code, 0, err)
        return self.folder / "run.h5"

    def test_numbers_and_units_are_those_of_the_file(self):
        path = self.make_result()
        run = wirepack.Run(path)
        with h5py.File(path) as file:
            for name, column in file["history"].items():
                numpy.testing.assert_array_equal(run.history[name], column[()])
                self.assertEqual(getattr(run.history, name).unit, column.attrs["unit"])
            self.assertEqual(len(run.frames), len(file["frames"]))
            for name, frame in zip(sorted(file["frames"]), run.frames):
                self.assertEqual(frame.increment, int(name))
                for item, data in file["frames"][name].items():
                    numpy.testing.assert_array_equal(getattr(frame, item), data[()])
                    self.assertEqual(getattr(frame, item).unit, frame.units[item])
        self.assertEqual(run.frames[-1].position[2:].unit, "length")
        self.assertEqual(type(run.history.force * 2), numpy.ndarray)
        self.assertEqual((run.finished, run.stop_reason, run.radius), (True, "increments", 1))
        self.assertAlmostEqual(run.bend_stiffness, 5 * numpy.pi / 4)
        scaled = run.history.force * run.cavity_radius**2 / run.bend_stiffness
        numpy.testing.assert_allclose(scaled, run.history.scaled_force, rtol=1e-12)
        frame = run.frames[-1]
        self.assertAlmostEqual(frame.arc_length[-1], frame.inserted_length, delta=0.02 * len(frame))

    def test_frames_are_found_by_density(self):
        run = wirepack.Run(self.make_result())
        densities = run.frames.packing_density
        self.assertGreater(len(densities), 5)
        middle = float(densities[3])
        self.assertEqual(run.frames[middle + 1e-4].packing_density, middle)
        part = run.frames[float(densities[1]) : float(densities[4])]
        self.assertEqual([f.packing_density for f in part], list(densities[1:5]))
        self.assertEqual(len(run.frames[0.9:]), 0)
        self.assertEqual(len(run.frames[-2:]), 2)
        for missing in (0.9, len(run.frames)):
            with self.assertRaises(IndexError):
                run.frames[missing]

    def test_what_is_not_in_equilibrium_is_refused_unless_asked_for(self):
        path = self.make_result()
        with h5py.File(path, "r+") as file:
            last = int(max(file["frames"]))
            file["history/residual"][last - 1] = 1.0  # far above minimizer.tolerance
        run = wirepack.Run(path)
        self.assertEqual(list(numpy.flatnonzero(~run.converged)), [last - 1])
        self.assertGreater(run.frames[-2].increment, 0)
        with self.assertRaisesRegex(wirepack.NotConverged, "unconverged=True"):
            run.frames[-1]
        self.assertEqual(wirepack.Run(path, unconverged=True).frames[-1].increment, last)
        with h5py.File(path, "r+") as file:
            file.attrs["stop_reason"] = "no_equilibrium"
        with self.assertRaisesRegex(wirepack.NotConverged, "no_equilibrium"):
            wirepack.Run(path).frames[0]
        self.assertGreater(len(wirepack.Run(path, unconverged=True).frames[0]), 2)

    def test_live_and_killed_runs_are_read_and_reloaded(self):
        self.write("scenario.toml", SMALL_RUN.replace("60", "100000"))
        path = self.folder / "run.h5"
        process = self.start("run", "scenario.toml", "-o", "run.h5")
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        for _ in range(3000):
            if path.exists() and len(wirepack.Run(path).history.increment) >= 10:
                break
            time.sleep(0.02)
        run = wirepack.Run(path)
        before = len(run.history.increment)
        self.assertGreaterEqual(before, 10)
        self.assertFalse(run.finished)
        for _ in range(3000):
            if len(wirepack.Run(path).history.increment) > before + 5:
                break
            time.sleep(0.02)
        self.assertEqual(len(run.history.increment), before)  # as it was when it was opened
        self.assertEqual(len(run.frames[-1].position.shape), 2)
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.assertGreater(len(run.reload().history.increment), before)
        self.assertFalse(run.finished)
        self.assertIn("unfinished", run._repr_html_())

    def test_gsd_and_xyz_hold_every_node(self):
        import gsd.hoomd

        run = wirepack.Run(self.make_result())
        run.to_gsd(self.folder / "run.gsd")
        run.to_xyz(self.folder / "run.xyz")
        lines = (self.folder / "run.xyz").read_text().splitlines()
        with gsd.hoomd.open(str(self.folder / "run.gsd"), "rb") as shots:
            self.assertEqual(len(shots), len(run.frames))
            for shot, frame in zip(shots, run.frames):
                numpy.testing.assert_allclose(shot.particles.position, frame.position, atol=1e-5)
                numpy.testing.assert_array_equal(shot.particles.diameter, 2)
                self.assertEqual(shot.bonds.group[-1].tolist(), [len(frame) - 2, len(frame) - 1])
                self.assertEqual(int(lines[0]), len(frame))
                rows = numpy.array([line.split()[1:] for line in lines[2 : 2 + len(frame)]], float)
                numpy.testing.assert_array_equal(rows[:, :3], frame.position)
                numpy.testing.assert_array_equal(rows[:, 4], frame.bend_energy)
                lines = lines[2 + len(frame) :]

    def test_the_notebook_view_escapes_names_counts_saddles_and_has_both_curves(self):
        path = self.make_result().rename(self.folder / "a<b>&.h5")
        with h5py.File(path, "r+") as file:
            file["history/stable"][-3:-1] = 0
        view = wirepack.Run(path)._repr_html_()
        self.assertIn("<th>saddles</th><td>2</td>", view)
        self.assertIn("a&lt;b&gt;&amp;.h5", view)
        self.assertEqual(view.count("<polyline"), 2)
        self.assertIn("ended by increments", view)

    def test_other_files_are_refused_with_their_name(self):
        with self.assertRaisesRegex(FileNotFoundError, "no.h5"):
            wirepack.Run(self.folder / "no.h5")
        with h5py.File(self.folder / "other.h5", "w") as file:
            file["frames/000001/position"] = [1.0]
        result = self.make_result().read_bytes()
        for name, data in (("text.h5", b"no result"), ("cut.h5", result[: len(result) // 2])):
            self.write(name, data)
        for name in ("other.h5", "text.h5", "cut.h5"):
            with self.assertRaisesRegex(wirepack.ResultError, name):
                wirepack.Run(self.folder / name)

    def test_what_packs_is_missing_alone_where_it_is_not_compiled(self):
        environment = os.environ | {"PYTHONPATH": os.environ["WIREPACK_READER"]}
        code = "import wirepack; wirepack.Run; wirepack.Packer"
        done = subprocess.run([sys.executable, "-c", code], env=environment, text=True,
                              stderr=subprocess.PIPE)
        self.assertIn("AttributeError: no Packer without the compiled module: ", done.stderr)

    def test_the_module_has_at_most_250_lines(self):
        with open(wirepack.__file__, encoding="utf-8") as module:
            self.assertLessEqual(len(module.readlines()), 250)


if __name__ == "__main__":
    unittest.main()
