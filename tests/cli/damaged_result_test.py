#!/usr/bin/python3
"""Results that are damaged, or made to do harm: one line, exit code 5, and nothing else."""

import os
import random
import shutil
import subprocess
import unittest
import xml.etree.ElementTree

import h5py
import numpy

from support import PROGRAM, ProgramTest, SMALL_RUN, differing

FRICTION = ["--set", "friction.model=coulomb"]


class ResultTest(ProgramTest):
    whole = None

    def setUp(self):
        super().setUp()
        self.write("run.toml", SMALL_RUN.replace("60", "30"))
        code, _, err = self.run_program("run", "run.toml", "-o", "whole.h5", *FRICTION)
        self.assertEqual(code, 0, err)
        self.whole = self.folder / "whole.h5"
        self.bad = self.folder / "bad.h5"

    def edit(self, change):
        """Makes bad.h5 of the whole one."""
        shutil.copy(self.whole, self.bad)
        with h5py.File(self.bad, "a") as file:
            change(file)

    def resume(self, *arguments):
        return self.run_program(
            "run", "run.toml", "-o", "bad.h5", *FRICTION, "--resume", *arguments, timeout=20
        )

    def check_refused(self, what):
        """By whatever reads what is wrong; nobody else minds it."""
        before = self.bad.read_bytes()
        refused = 0
        for call in (
            lambda: self.run_program("analyze", "bad.h5", timeout=20),
            lambda: self.resume("--set", "stop.increments=40"),
        ):
            code, out, err = call()
            if code == 5:
                self.assertEqual((out, len(err.splitlines())), ("", 1), what)
                self.assertIn("bad.h5: is ", err)
                self.assertEqual(self.bad.read_bytes(), before, what)
                refused += 1
            else:
                self.assertEqual(code, 0, f"{what}: {err}")
        self.assertGreater(refused, 0, what)


class Foreign(ResultTest):
    def test_links_and_values_that_lie_elsewhere_are_refused_and_nothing_else_is_touched(self):
        secret = self.write("secret", "x" * 2000)
        os.mkfifo(self.folder / "fifo")
        increments = 30

        def external(file, name, shape, target):
            del file[name]
            place = h5py.h5d.create
            properties = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
            properties.set_external(str(target).encode(), 0, h5py.h5f.UNLIMITED)
            space = h5py.h5s.create_simple(shape)
            place(file.id, name.encode(), h5py.h5t.NATIVE_DOUBLE, space, properties)

        def virtual(file):
            del file["history/force"]
            layout = h5py.VirtualLayout(shape=(increments,), dtype="f8")
            layout[:] = h5py.VirtualSource("whole.h5", "history/force", shape=(increments,))
            file.create_virtual_dataset("history/force", layout)

        def relink(name, link):
            def change(file):
                del file[name]
                file[name] = link

            return change

        changes = {
            "soft link": relink("history/force", h5py.SoftLink("/history/scaled_force")),
            "external link": relink("history", h5py.ExternalLink("whole.h5", "/history")),
            "a frame elsewhere": relink(
                "frames/000030", h5py.ExternalLink("whole.h5", "/frames/000030")
            ),
            "a link that nobody needs": lambda f: f.__setitem__("x", h5py.SoftLink("/nowhere")),
            "external file": lambda f: external(f, "history/force", (increments,), secret),
            "external fifo": lambda f: external(f, "history/force", (increments,), "fifo"),
            "external checkpoint": lambda f: external(f, "checkpoint/nodes", (10, 3), secret),
            "virtual": virtual,
        }
        for what, change in changes.items():
            with self.subTest(what):
                self.edit(change)
                self.check_refused(what)
        self.assertEqual(secret.read_text(), "x" * 2000)

    def test_sizes_are_looked_at_before_memory_is_taken(self):
        def huge(file, name, shape, chunks):
            del file[name]
            file.create_dataset(name, shape, "f8", chunks=chunks, maxshape=(None,))

        for what, shape, chunks in [
            ("list", (10**12,), (256,)),
            ("chunk", (30,), (5 * 10**8,)),
        ]:
            with self.subTest(what):
                self.edit(lambda f: huge(f, "history/force", shape, chunks))
                self.check_refused(what)


class Damage(ResultTest):
    def test_a_changed_number_is_noticed_though_hdf5_finds_nothing_wrong(self):
        def add(name, index):
            def change(file):
                values = file[name][()]
                values[index] += 1
                file[name][...] = values

            return change

        def text(file):
            config = file["provenance"].attrs["config"]
            file["provenance"].attrs["config"] = numpy.bytes_(
                config.replace(b"radius = 4", b"radius = 5")
            )

        changes = {
            "history": add("history/energy_bend", 12),
            "increment": add("history/increment", 12),
            "frame": add("frames/000030/position", (3, 1)),
            "configuration": text,
            "seed": lambda f: f["provenance"].attrs.modify("seed", 7),
        }
        for what, change in changes.items():
            with self.subTest(what):
                self.edit(change)
                self.check_refused(what)

    def test_a_changed_byte_in_the_radius_changes_no_result(self):
        data = self.whole.read_bytes()
        at = -1
        found = 0
        code, expected, err = self.run_program("analyze", "whole.h5", "--json")
        self.assertEqual(code, 0, err)
        while (at := data.find(b"radius = 4", at + 1)) >= 0:
            found += 1
            self.bad.write_bytes(data[: at + 9] + b"5" + data[at + 10 :])
            code, out, err = self.run_program("analyze", "bad.h5", "--json")
            if code == 0:
                self.assertEqual(out.replace("bad.h5", "whole.h5"), expected)
            else:
                self.assertEqual(code, 5)
        self.assertGreaterEqual(found, 2)

    def test_no_changed_byte_or_lost_sector_crashes_or_gives_other_numbers(self):
        data = self.whole.read_bytes()
        code, expected, err = self.run_program("analyze", "whole.h5", "--json")
        self.assertEqual(code, 0, err)
        choice = random.Random(3)
        damages = [
            (at, bytes([data[at] ^ 1 << choice.randrange(8)]))
            for at in choice.sample(range(8000), 150)
        ]
        damages += [(512 * k, bytes(512)) for k in choice.sample(range(len(data) // 512), 60)]
        noticed = 0
        for at, new in damages:
            self.bad.write_bytes(data[:at] + new + data[at + len(new) :])
            code, out, err = self.run_program("analyze", "bad.h5", "--json", timeout=20)
            self.assertIn(code, (0, 5), f"byte {at}: {err}")
            if code == 0:
                self.assertEqual(out.replace("bad.h5", "whole.h5"), expected, at)
            noticed += code == 5
        self.assertGreater(noticed, 10)

    def test_a_damaged_checkpoint_is_told_and_the_one_before_goes_on_to_the_same_bits(self):
        longer = ["--set", "stop.increments=40"]
        code, _, err = self.run_program("run", "run.toml", "-o", "longer.h5", *FRICTION, *longer)
        self.assertEqual(code, 0, err)

        def stop_early(file):  # as if it had been killed
            file["checkpoint/nodes"][3, 1] += 1e-9

        self.edit(stop_early)
        code, _, err = self.resume(*longer)
        self.assertEqual(code, 0, err)
        self.assertIn(
            "bad.h5: is damaged: its checksum does not fit; the checkpoint before is taken", err
        )
        self.assertEqual(differing(self.folder / "longer.h5", self.bad), [])

        def both(file):
            stop_early(file)
            file["checkpoint_before/nodes"][3, 1] += 1e-9

        self.edit(both)
        before = self.bad.read_bytes()
        code, out, err = self.resume(*longer)
        self.assertEqual((code, out), (5, ""), err)
        self.assertEqual(self.bad.read_bytes(), before)


class Names(ResultTest):
    def test_the_name_of_a_result_commands_neither_terminals_nor_gnuplot_nor_pages(self):
        name = b"a\x1b[31m\xff\n';system 'touch pwned';<script>'.h5"
        os.rename(self.whole, os.fsencode(self.folder) + b"/" + name)
        for command in (
            ["analyze", os.fsdecode(name)],
            ["figures", os.fsdecode(name), "-o", "drawn"],
            ["export", os.fsdecode(name), "--format", "xdmf", "-o", "out.xdmf"],
            ["view", os.fsdecode(name), "-o", "out.html"],
            ["run", "run.toml", "-o", os.fsdecode(name), *FRICTION, "--resume"],
        ):
            process = subprocess.run(
                [PROGRAM, *command], cwd=self.folder, capture_output=True, check=False
            )
            self.assertEqual(process.returncode, 0, process.stderr)
            for said in (process.stdout, process.stderr):
                self.assertEqual(set(said) & (set(range(32)) - set(b"\n")), set(), command)
                said.decode()
        self.assertEqual(list(self.folder.glob("**/pwned")), [])
        xml.etree.ElementTree.parse(self.folder / "out.xdmf")
        self.assertNotIn(b"<script>'", (self.folder / "out.html").read_bytes())
        for script in self.folder.glob("drawn/*.gp"):
            lines = script.read_text().splitlines()
            self.assertEqual([line for line in lines if line.startswith("'")], [])


class Believed(ResultTest):
    """Values with checksums that fit, in a file of format version 2, which has none."""

    def make_version_2(self, file):
        del file["provenance"], file["checkpoint_before"]
        file.attrs["format_version"] = 2

    def test_values_that_no_run_can_have_are_refused(self):
        def put(name, index, value):
            def change(file):
                values = file[name][()]
                values[index] = value
                file[name][...] = values

            return change

        changes = {
            "endless forces": put("checkpoint/recent_forces", (-1, 1), 1e308),
            "no number": put("checkpoint/nodes", (3, 1), numpy.nan),
            "infinite": put("frames/000030/position", (3, 1), numpy.inf),
            "no number in the history": put("history/force", 7, numpy.nan),
            "negative increments": put("history/increment", 0, -(9 * 10**18)),
            "an increment twice": put("history/increment", 8, 8),
            "edges that are not there": put("checkpoint/slip_memory", (0, 0), 1e9),
            "a part of nothing": lambda f: f["checkpoint"].attrs.modify("substep", 0.0),
            "a part that no increment is taken in": lambda f: f["checkpoint"].attrs.modify(
                "substep", 1 / 128
            ),
            "a checkpoint of another row": lambda f: f["checkpoint/last"].attrs.modify(
                "increment", 17.0
            ),
        }
        for what, change in changes.items():
            with self.subTest(what):

                def all_of_it(file):
                    self.make_version_2(file)
                    change(file)

                self.edit(all_of_it)
                self.check_refused(what)

    def test_no_file_is_read_that_the_configuration_of_a_result_names(self):
        os.mkfifo(self.folder / "fifo")

        def name_a_file(file):
            self.make_version_2(file)
            shaped = '[wire]\nreference_shape = "fifo"\n'
            file.attrs["config"] = file.attrs["config"].replace("[wire]\n", shaped)

        self.edit(name_a_file)
        code, out, err = self.run_program("analyze", "bad.h5", timeout=20)
        self.assertEqual((code, out), (5, ""), err)
        self.assertIn("wire.reference_shape is the name of a file", err)

    def test_a_file_of_format_version_2_goes_on(self):
        longer = ["--set", "stop.increments=40"]
        code, _, err = self.run_program("run", "run.toml", "-o", "longer.h5", *FRICTION, *longer)
        self.assertEqual(code, 0, err)
        self.edit(self.make_version_2)
        code, _, err = self.resume(*longer)
        self.assertEqual(code, 0, err)
        names = differing(self.folder / "longer.h5", self.bad)
        # but for the frame at its first end, which is one more and puts off the next ones
        self.assertEqual(
            [n for n in names if not n.startswith("frames/") and "frame_density" not in n], []
        )


if __name__ == "__main__":
    unittest.main()
