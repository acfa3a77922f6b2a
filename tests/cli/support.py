"""What the tests of the program share. WIREPACK names the program under test."""

import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy

PROGRAM = os.environ["WIREPACK"]

# A sphere of 4 wire radii: some milliseconds per increment, frames every few increments.
SMALL_RUN = """
[cavity]
radius = 4
[stop]
increments = 60
[output]
checkpoint_every_seconds = 0
"""


# A run that only a signal ends, and saves only then.
ENDLESS = ["--set", "stop.increments=1000000", "--set", "output.checkpoint_every_seconds=1000"]


class ProgramTest(unittest.TestCase):
    """Each test works in an empty folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, text):
        path = self.folder / name
        if isinstance(text, bytes):
            path.write_bytes(text)
        else:
            path.write_text(text)
        return path

    def start(self, *arguments, **options):
        return subprocess.Popen(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            **options,
        )

    def run_until(self, increment, result, *arguments, **options):
        """Starts run.toml into a result and returns when its table has a line for the increment."""
        process = self.start("run", "run.toml", "-o", result, *arguments, **options)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        for line in process.stdout:
            if line.split()[0] == str(increment):
                return process
        self.fail(process.stderr.read())

    def run_program(self, *arguments, timeout=60, **options):
        process = self.start(*arguments, **options)
        out, err = process.communicate(timeout=timeout)
        return process.returncode, out, err

    def names(self):
        return sorted(path.name for path in self.folder.iterdir())


class RunTest(ProgramTest):
    """Tests of run.toml, a small run, and its result out.h5."""

    def setUp(self):
        super().setUp()
        self.write("run.toml", SMALL_RUN)

    def saved(self):
        with h5py.File(self.folder / "out.h5") as file:
            return int(file["checkpoint/last"].attrs["increment"])

    def check_goes_on_to_the_same_bits(self, *arguments):
        end = ["--set", f"stop.increments={self.saved() + 20}", *arguments]
        for name, more in (("whole.h5", ["--force"]), ("out.h5", ["--resume"])):
            code, _, err = self.run_program("run", "run.toml", "-o", name, *end, *more)
            self.assertEqual(code, 0, err)
        self.assertEqual(differing(self.folder / "whole.h5", self.folder / "out.h5"), [])


def datasets(path):
    """All datasets and attributes that equal runs must share, by name."""
    found = {}
    # times, and neighbor lists, of which a continued run makes one more; checksums over these; what
    # stands in / as well
    of_the_machine = re.compile("(.*/)?work@(list_builds|.*_seconds)|.*@checksum|provenance@.*")

    def note(name, item):
        for key, value in item.attrs.items():
            if not of_the_machine.fullmatch(f"{name}@{key}"):
                found[f"{name}@{key}"] = value
        if isinstance(item, h5py.Dataset) and name != "history/wall_seconds":
            found[name] = item[()]

    with h5py.File(path, "r") as file:
        file.visititems(note)
        for key in ("config", "seed", "finished", "stop_reason", "phi_max"):
            found[f"@{key}"] = file.attrs[key]
    return found


def differing(one, other):
    """Names of datasets and attributes that are not the same to the last bit."""
    first, second = datasets(one), datasets(other)
    names = sorted(first.keys() ^ second.keys())
    for name in sorted(first.keys() & second.keys()):
        a, b = numpy.asarray(first[name]), numpy.asarray(second[name])
        same = a.dtype == b.dtype and a.shape == b.shape
        if not same or (
            a.tolist() != b.tolist() if a.dtype == object else a.tobytes() != b.tobytes()
        ):
            names.append(name)
    return names


def check_readable(test, path):
    """The file opens, its columns fit together, and its frames are announced in the history."""
    with h5py.File(path, "r") as file:
        lengths = {len(column) for column in file["history"].values()}
        test.assertEqual(len(lengths), 1)
        increments = set(file["history/increment"][()].tolist())
        for name, frame in file["frames"].items():
            test.assertIn(int(frame.attrs["increment"]), increments)
            test.assertEqual(int(name), frame.attrs["increment"])
            test.assertEqual(frame["position"].shape[0], frame["quaternion"].shape[0] + 1)
            for dataset in frame.values():
                dataset[()]
        last = int(file["checkpoint/last"].attrs["increment"])
        test.assertEqual(last, max(increments, default=0))
        return last
