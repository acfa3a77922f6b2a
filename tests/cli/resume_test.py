#!/usr/bin/python3
"""Runs that are killed, stopped or continued end in the same bits as an undisturbed run."""

import random
import signal
import time
import unittest

import h5py

from support import ENDLESS, ProgramTest, SMALL_RUN, check_readable, datasets, differing


# a = 2, Y = 4, rho = 4: powers of two, so that changing units rounds nothing
IN_OTHER_UNITS = """
[packing]
setup = "high_torsion"
[wire]
radius = 2
youngs_modulus = 4
density = 4
[contact]
excluded_arc_length = 6
[cavity]
radius = 8
[friction]
model = "coulomb"
"""


def make_version_1(path):
    """Of a file IN_OTHER_UNITS, as it was before the checkpoint was in units of the wire."""
    length, force, energy, time = 2.0, 16.0, 32.0, 2.0
    units = {"length": length, "force": force, "force length": energy, "time": time}
    with h5py.File(path, "a") as file:
        checkpoint = file["checkpoint"]
        file.attrs["format_version"] = 1
        del file["provenance"], file["checkpoint_before"]
        del checkpoint["balance"], checkpoint["work"], checkpoint["crossings"]
        checkpoint["nodes"][...] *= length
        checkpoint.attrs["inlet_rest_length"] *= length
        checkpoint.attrs["trapezoid_error"] *= energy
        if len(checkpoint["slip_memory"]):
            checkpoint["slip_memory"][:, 2:] *= length
        checkpoint["recent_forces"][...] *= [length, force]
        for name, column in file["history"].items():
            checkpoint["last"].attrs[name] *= units.get(column.attrs["unit"], 1)


class Resume(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("run.toml", SMALL_RUN)

    def run_whole(self, name="whole.h5", *arguments):
        code, out, err = self.run_program("run", "run.toml", "-o", name, *arguments)
        self.assertEqual(code, 0, err)
        return self.folder / name

    def test_two_runs_give_the_same_bits(self):
        one = self.run_whole("one.h5")
        other = self.run_whole("other.h5", "--threads", "3")
        self.assertEqual(differing(one, other), [])
        check_readable(self, one)

    def test_what_a_run_has_cost_is_in_the_file_and_in_the_table(self):
        start = time.monotonic()
        code, out, err = self.run_program(
            "run", "run.toml", "-o", "whole.h5", "--set", "stop.increments=30"
        )
        duration = time.monotonic() - start
        self.assertEqual(code, 0, err)
        with h5py.File(self.folder / "whole.h5") as file:
            work = dict(file["work"].attrs)
            of_increments = int(file["history/evaluations"][()].sum())
        # the first two edges are brought to rest before the first increment
        self.assertGreater(work["evaluations"], of_increments)
        self.assertLess(work["evaluations"], of_increments + 50)
        self.assertGreater(work["factorizations"], 30)
        self.assertGreater(work["list_builds"], 0)
        seconds = [value for key, value in work.items() if key.endswith("_seconds")]
        self.assertEqual(len(seconds), 8)
        self.assertGreater(min(seconds), 0)
        self.assertLess(sum(seconds), duration)
        self.assertRegex(out, f"# evaluations +{work['evaluations']}\n")
        self.assertRegex(out, "#   triangular solves +[0-9.]+ s, [0-9]+ %\n")

    def test_a_run_killed_many_times_ends_in_the_same_bits(self):
        start = time.monotonic()
        whole = self.run_whole()
        duration = time.monotonic() - start
        choice = random.Random(7)
        killed = self.folder / "killed.h5"
        for attempt in range(40):
            process = self.start("run", "run.toml", "-o", "killed.h5", "--resume")
            time.sleep(choice.uniform(0.0, 0.5 * duration))
            process.kill()
            process.communicate()
            if killed.exists():
                check_readable(self, killed)
            if process.returncode == 0:
                break
        code, _, err = self.run_program("run", "run.toml", "-o", "killed.h5", "--resume")
        self.assertEqual(code, 0, err)
        self.assertEqual(differing(whole, killed), [])
        # a run that is killed between its end and giving back its lock leaves that behind
        left = [name for name in self.names() if name != "killed.h5.lock"]
        self.assertEqual(left, ["killed.h5", "run.toml", "whole.h5"])

    def test_a_signal_saves_and_the_run_goes_on(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            name = f"stopped{int(number)}.h5"
            process = self.run_until(20, name, *ENDLESS)
            process.send_signal(number)
            _, err = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 75, err)
            self.assertIn("--resume", err)
            saved = check_readable(self, self.folder / name)
            self.assertGreaterEqual(saved, 20)
            with h5py.File(self.folder / name) as file:
                self.assertEqual(file.attrs["finished"], 0)
            end = ["--set", f"stop.increments={saved + 20}"]
            self.run_whole(name, "--resume", *end)
            whole = self.run_whole(f"whole{int(number)}.h5", *end)
            self.assertEqual(differing(whole, self.folder / name), [])

    def test_limits_may_change_and_other_keys_may_not(self):
        whole = self.run_whole()
        part = self.run_whole("part.h5", "--set", "stop.increments=25")
        code, _, err = self.run_program(
            "run", "run.toml", "-o", "part.h5", "--resume", "--set", "cavity.radius=5"
        )
        self.assertEqual(code, 2)
        self.assertIn("cannot be continued with this configuration: cavity.radius: was 4.0", err)
        code, _, err = self.run_program("run", "run.toml", "-o", "part.h5", "--resume")
        self.assertEqual(code, 0, err)
        self.assertEqual(differing(whole, part), [])

    def test_a_finished_run_with_a_larger_limit_is_the_run_that_had_it_from_the_start(self):
        dynamic = ["--method", "dynamic", "--set", "dynamics.insertion_speed=0.05"]
        for method in ([], ["--set", "friction.model=coulomb"], dynamic):
            limits = ["--set", "stop.increments=100000"]
            whole = self.run_whole("whole.h5", *method, *limits, "--set", "stop.length=10.13")
            # both limits cut their last increment
            part = self.run_whole("part.h5", *method, *limits, "--set", "stop.length=6.37")
            code, _, err = self.run_program(
                "run",
                "run.toml",
                "-o",
                "part.h5",
                *method,
                *limits,
                "--set",
                "stop.length=10.13",
                "--resume",
            )
            self.assertEqual(code, 0, err)
            self.assertEqual(differing(whole, part), [], method)
            whole.unlink()
            part.unlink()

    def test_contacts_with_friction_go_on_as_they_were(self):
        friction = ["--set", "friction.model=coulomb"]
        whole = self.run_whole("whole.h5", *friction)
        self.run_whole("part.h5", *friction, "--set", "stop.increments=43")
        code, _, err = self.run_program("run", "run.toml", "-o", "part.h5", "--resume", *friction)
        self.assertEqual(code, 0, err)
        self.assertGreater(len(datasets(whole)["checkpoint/slip_memory"]), 5)
        self.assertEqual(differing(whole, self.folder / "part.h5"), [])

    def test_a_file_of_format_version_1_goes_on_to_the_same_bits(self):
        self.write("run.toml", IN_OTHER_UNITS)
        whole = self.run_whole("whole.h5", "--set", "stop.increments=60")
        part = self.run_whole("part.h5", "--set", "stop.increments=40")
        make_version_1(part)
        code, _, err = self.run_program(
            "run", "run.toml", "-o", "part.h5", "--resume", "--set", "stop.increments=60"
        )
        self.assertEqual(code, 0, err)
        first, second = datasets(whole), datasets(part)
        self.assertGreater(len(first["checkpoint/slip_memory"]), 5)
        for name, value in first.items():
            if name.startswith(("history/", "checkpoint/", "balance")) and "@" not in name:
                self.assertEqual(value.tolist(), second[name].tolist(), name)

    def test_the_balance_is_in_the_units_of_the_configuration(self):
        self.write("run.toml", IN_OTHER_UNITS)
        with h5py.File(self.run_whole("whole.h5", "--set", "stop.increments=40")) as file:
            balance = file["balance"].attrs
            self.assertEqual(balance["energy"], file["history/energy_total"][-1])
            length, force = file["history/inserted_length"][()], file["history/force"][()]
            work = sum((length[1:] - length[:-1]) * (force[1:] + force[:-1]) / 2)
            self.assertAlmostEqual(balance["work"] / work, 1, delta=0.03)
            self.assertEqual(file["checkpoint/balance"].attrs["work"], balance["work"] / 32)

    def test_a_finished_run_stays_as_it_is(self):
        whole = self.run_whole()
        before = whole.read_bytes()
        code, out, err = self.run_program("run", "run.toml", "-o", "whole.h5", "--resume")
        self.assertEqual(code, 0)
        self.assertIn("is finished", err)
        self.assertEqual(whole.read_bytes(), before)

    def test_files_that_cannot_be_continued(self):
        whole = self.run_whole().read_bytes()
        damaged = bytearray(whole)
        damaged[600:3000] = bytes(2400)
        self.write("other.h5", b"")
        with h5py.File(self.folder / "other.h5", "w") as file:
            file["x"] = 1
        self.write("new.h5", whole)
        with h5py.File(self.folder / "new.h5", "a") as file:
            file.attrs["format_version"] = 4
        for name, content, part in [
            ("text.h5", b"hello", "is not an HDF5 file"),
            ("empty.h5", b"", "is not an HDF5 file"),
            ("cut.h5", whole[: len(whole) // 2], "is damaged"),
            ("holes.h5", bytes(damaged), "holes.h5: is"),
            ("other.h5", None, "is not a result file of wirepack"),
            ("new.h5", None, "has format version 4"),
        ]:
            with self.subTest(name):
                path = self.folder / name
                if content is not None:
                    path.write_bytes(content)
                before = path.read_bytes()
                code, out, err = self.run_program("run", "run.toml", "-o", name, "--resume")
                self.assertEqual((code, out), (5, ""), err)
                self.assertIn(part, err)
                self.assertEqual(len(err.splitlines()), 1, err)
                self.assertEqual(path.read_bytes(), before)

    def test_force_replaces(self):
        self.write("old.h5", "something")
        self.run_whole("old.h5", "--force")
        check_readable(self, self.folder / "old.h5")

    def test_the_columns_hold_what_their_names_say(self):
        with h5py.File(self.run_whole()) as file:
            history = {name: column[()] for name, column in file["history"].items()}
            bend = 5 * 3.141592653589793 / 4  # YI of the default wire
            for length, density in zip(history["inserted_length"], history["packing_density"]):
                self.assertAlmostEqual(density, 3 * length / (4 * 4**3), places=12)
            for force, scaled in zip(history["force"], history["scaled_force"]):
                self.assertAlmostEqual(scaled, force * 16 / bend, places=9)
            parts = sum(
                history[f"energy_{n}"] for n in ("stretch", "bend", "twist", "wall", "contact")
            )
            for total, part in zip(history["energy_total"], parts):
                self.assertAlmostEqual(total, part, places=9)
            frame = file["frames/000060"]
            self.assertAlmostEqual(
                frame["bend_energy"][()].sum(), history["energy_bend"][-1], places=9
            )
            self.assertEqual(file.attrs["phi_max"], history["packing_density"].max())


if __name__ == "__main__":
    unittest.main()
