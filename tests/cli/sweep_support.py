"""Sweeps of small runs, for the tests of what runs them."""

import os
import re
import subprocess
import tempfile
import time

import h5py

from support import ProgramTest, differing

# These runs save after every increment, which waits for a disk, but not for memory.
if os.access("/dev/shm", os.W_OK):
    tempfile.tempdir = "/dev/shm"

# 2 setups x 3 radii x 3 seeds, some tenths of a second each.
PLAN = """
[stop]
increments = 40
[output]
checkpoint_every_seconds = 0
[sweep]
packing.setup = ["low_torsion", "high_torsion"]
cavity.radius = [3, 3.5, 4]
packing.seed = { from = 1, to = 3 }
"""
TASKS = 18


class SmallDisk:
    """A file system of its own in memory, which a file of the test's fills up."""

    def __init__(self, folder):
        self.ballast = folder / "ballast"
        folder.mkdir()
        mount = ["mount", "-t", "tmpfs", "-o", "size=64m", "tmpfs", str(folder)]
        self.mounted = subprocess.run(mount, capture_output=True, check=False).returncode == 0
        self.folder = folder

    def fill(self):
        """Leaves room for a log and not for a result."""
        size = os.statvfs(self.folder)
        free = size.f_bavail * size.f_frsize
        self.ballast.write_bytes(bytes(free - 100_000))

    def empty(self):
        self.ballast.unlink()

    def unmount(self):
        subprocess.run(["umount", str(self.folder)], check=True)


class SweepTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("plan.toml", PLAN)

    def small_disk(self, name):
        disk = SmallDisk(self.folder / name)
        if not disk.mounted:
            self.skipTest("needs the right to mount a small file system")
        self.addCleanup(disk.unmount)
        return disk

    def tasks(self, folder):
        return sorted(path.parent for path in (self.folder / folder).glob("*/config.toml"))

    def true_state(self, task):
        """Of a task that nobody runs, by its result alone; and the increment that is saved."""
        if not (task / "run.h5").exists():
            return "waiting", 0
        with h5py.File(task / "run.h5") as file:
            state = "done" if file.attrs["finished"] else "resumable"
            return state, int(file["checkpoint/last"].attrs["increment"])

    def status(self, folder):
        """State and remark of each task, by name, as --status tells them."""
        code, out, err = self.run_program("sweep", "--status", folder)
        self.assertEqual(code, 0, err)
        found = {}
        for line in out.splitlines():
            match = re.match(r" (\S+) +(no equilibrium|\S+) +[0-9.]+ +[0-9]+ +\S+ +\S+  (.*)", line)
            if match:
                found[match[1]] = (match[2], match[3])
        return found

    def wait_for_done(self, folder, count, process):
        """Returns when so many tasks are done, or the process has ended."""
        ended = lambda log: log.read_text().endswith("exit code 0\n")
        self.wait_for(
            lambda: sum(map(ended, (self.folder / folder).glob("*/run.log"))) >= count, process
        )

    def wait_for(self, reached, process):
        while process.poll() is None and not reached():
            time.sleep(0.01)

    def check_same_bits(self, one, other):
        names = [task.name for task in self.tasks(one)]
        self.assertEqual(names, [task.name for task in self.tasks(other)])
        for name in names:
            first, second = (
                self.folder / one / name / "run.h5",
                self.folder / other / name / "run.h5",
            )
            self.assertEqual(differing(first, second), [], name)


class Stops:
    """What was there at each stop, against what came of it: nothing is computed twice."""

    def __init__(self, test, folder):
        self.test, self.folder, self.saved, self.finished = test, folder, {}, {}

    def note(self):
        for task in self.test.tasks(self.folder):
            state, increment = self.test.true_state(task)
            if state == "done":
                files = [(task / name).read_bytes() for name in ("run.h5", "run.log")]
                stamp = (task / "run.h5").stat().st_mtime_ns
                self.finished.setdefault(task.name, (files, stamp))
            elif state == "resumable":
                self.saved.setdefault(task.name, []).append(increment)

    def check(self):
        for task in self.test.tasks(self.folder):
            log = (task / "run.log").read_text()
            went_on = [int(n) for n in re.findall("going on after increment ([0-9]+)", log)]
            self.test.assertEqual(went_on, self.saved.get(task.name, []), task.name)
            if task.name in self.finished:
                files, stamp = self.finished[task.name]
                self.test.assertEqual(
                    [(task / name).read_bytes() for name in ("run.h5", "run.log")], files
                )
                self.test.assertEqual((task / "run.h5").stat().st_mtime_ns, stamp)
