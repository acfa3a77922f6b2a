#!/usr/bin/python3
"""Faults of the machine: no memory, a clock that jumps, no right to write, locks of others."""

import ctypes
import fcntl
import os
import resource
import signal
import subprocess
import unittest
from pathlib import Path

import h5py

from support import ENDLESS, RunTest, check_readable

# Debian's libfaketime
FAKE_CLOCK = next(Path("/usr/lib").glob("*/faketime/libfaketime.so.1"), None)


class Memory(RunTest):
    def test_a_run_without_memory_says_so_and_goes_on_from_what_was_saved(self):
        for threads in ("1", "2"):
            more = ["--set", "output.frame_every_density=0.002", "--threads", threads]
            for spare in (0, 300_000):
                process = self.run_until(20, "out.h5", "--force", *ENDLESS[:2], *more)
                process.send_signal(signal.SIGSTOP)
                taken = int(Path(f"/proc/{process.pid}/statm").read_text().split()[0])
                most = taken * resource.getpagesize() + spare
                resource.prlimit(process.pid, resource.RLIMIT_AS, (most, most))
                process.send_signal(signal.SIGCONT)
                _, err = process.communicate(timeout=60)
                self.assertEqual(process.returncode, 4, err)
                self.assertRegex(err, "^wirepack run: there is not enough memory; [^\n]*\n$")
                self.assertGreaterEqual(check_readable(self, self.folder / "out.h5"), 19)
                self.check_goes_on_to_the_same_bits(*more)
                self.assertEqual(self.names(), ["out.h5", "run.toml", "whole.h5"])


@unittest.skipUnless(FAKE_CLOCK, "libfaketime is not installed")
class Clock(RunTest):
    def test_a_clock_that_is_set_back_stops_no_saving_and_spoils_no_times(self):
        clock = self.write("clock", "+0")
        environment = {
            **os.environ,
            "LD_PRELOAD": str(FAKE_CLOCK),
            "FAKETIME_TIMESTAMP_FILE": str(clock),
            "FAKETIME_NO_CACHE": "1",
            "DONT_FAKE_MONOTONIC": "1",
        }
        year = lambda: subprocess.check_output(["date", "+%Y"], env=environment, text=True)
        today = int(year())
        every = ["--set", "output.checkpoint_every_seconds=0.01"]
        process = self.run_until(20, "out.h5", *ENDLESS[:2], *every, env=environment)
        process.send_signal(signal.SIGSTOP)
        clock.write_text("-10y")
        self.assertLess(int(year()), today - 8)
        saved = self.saved()
        process.send_signal(signal.SIGCONT)
        # a table is printed line by line, for as long as it takes until it is saved again
        for line in process.stdout:
            if self.saved() > saved + 20:
                break
        process.kill()
        process.communicate()
        self.assertGreater(self.saved(), saved + 20)
        with h5py.File(self.folder / "out.h5") as file:
            times = file["history/wall_seconds"][()]
        self.assertGreater(min(times[1:] - times[:-1]), 0)
        self.assertLess(times[-1], 60)
        self.check_goes_on_to_the_same_bits(*every)


def obey_rights():
    """Before a program starts: takes from a superuser the right to write where nobody may."""
    drop_from_bounding_set, override_rights = 24, 1
    ctypes.CDLL(None).prctl(drop_from_bounding_set, override_rights, 0, 0, 0)


class Folders(RunTest):
    def test_a_folder_that_becomes_unwritable_costs_only_what_was_not_saved(self):
        process = self.run_until(10, "out.h5", *ENDLESS[:2], preexec_fn=obey_rights)
        self.folder.chmod(0o555)
        _, err = process.communicate(timeout=60)
        self.folder.chmod(0o755)
        self.assertEqual(process.returncode, 5, err)
        self.assertIn("out.h5: cannot be written: Permission denied", err)
        self.assertGreater(check_readable(self, self.folder / "out.h5"), 0)
        self.check_goes_on_to_the_same_bits()
        self.assertEqual(self.names(), ["out.h5", "run.toml", "whole.h5"])


class Readers(RunTest):
    def test_locks_of_hdf5_on_a_result_hinder_neither_saving_nor_going_on(self):
        process = self.run_until(20, "out.h5", *ENDLESS[:2])
        with h5py.File(self.folder / "out.h5", locking=True) as read:
            rows = len(read["history/increment"])
            last = self.saved()
            for line in process.stdout:
                if int(line.split()[0]) > last + 20:
                    break
            process.send_signal(signal.SIGTERM)
            _, err = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 75, err)
            self.assertEqual(len(read["history/increment"]), rows)
        end = f"stop.increments={self.saved() + 20}"
        with open(self.folder / "out.h5", "rb") as locked:
            fcntl.flock(locked, fcntl.LOCK_EX)  # as HDF5 of a file that is opened to write
            code, _, err = self.run_program("analyze", "out.h5")
            self.assertEqual(code, 0, err)
            environment = {**os.environ, "HDF5_USE_FILE_LOCKING": "TRUE"}
            code, _, err = self.run_program(
                "run", "run.toml", "-o", "out.h5", "--resume", "--set", end, env=environment
            )
            self.assertEqual(code, 0, err)


if __name__ == "__main__":
    unittest.main()
