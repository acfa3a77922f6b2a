#!/usr/bin/python3
"""A disk that fills up: exit code 5, the reason, and the last good file."""

import resource
import subprocess
import unittest

import h5py

from support import ProgramTest, SMALL_RUN, check_readable, differing


def limit_file_size(size):
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


class DiskFull(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("run.toml", SMALL_RUN)
        code, _, err = self.run_program("run", "run.toml", "-o", "whole.h5")
        self.assertEqual(code, 0, err)
        self.size = (self.folder / "whole.h5").stat().st_size

    def check_rest(self, code, err, reason, path):
        self.assertEqual(code, 5, err)
        self.assertIn(f"{path}: cannot be written: {reason}", err)
        last = check_readable(self, self.folder / path)
        self.assertGreater(last, 0)
        with h5py.File(self.folder / path) as file:
            self.assertEqual(file.attrs["finished"], 0)

    def test_a_limit_on_files_in_the_middle_of_a_run(self):
        code, _, err = self.run_program(
            "run", "run.toml", "-o", "out.h5", preexec_fn=limit_file_size(self.size * 3 // 4)
        )
        self.check_rest(code, err, "File too large", "out.h5")
        self.assertEqual(self.names(), ["out.h5", "run.toml", "whole.h5"])
        code, _, err = self.run_program("run", "run.toml", "-o", "out.h5", "--resume")
        self.assertEqual(code, 0, err)
        self.assertEqual(differing(self.folder / "whole.h5", self.folder / "out.h5"), [])

    def test_no_space_from_the_start(self):
        code, out, err = self.run_program(
            "run", "run.toml", "-o", "out.h5", preexec_fn=limit_file_size(1000)
        )
        self.assertEqual(code, 5, err)
        self.assertIn("File too large", err)
        self.assertEqual(self.names(), ["run.toml", "whole.h5"])

    def test_a_full_disk(self):
        disk = self.folder / "disk"
        disk.mkdir()
        # both the old and the new file must fit
        size = f"size={self.size * 3 // 2 // 1024}k"
        mount = subprocess.run(
            ["mount", "-t", "tmpfs", "-o", size, "tmpfs", disk], capture_output=True, check=False
        )
        if mount.returncode != 0:
            self.skipTest("needs the right to mount a small file system")
        try:
            code, _, err = self.run_program("run", "run.toml", "-o", "disk/out.h5")
            self.check_rest(code, err, "No space left on device", "disk/out.h5")
            self.assertEqual([path.name for path in disk.iterdir()], ["out.h5"])
        finally:
            subprocess.run(["umount", disk], check=False)

    def test_a_disk_that_is_full_when_a_run_goes_on(self):
        code, _, err = self.run_program(
            "run", "run.toml", "-o", "out.h5", "--set", "stop.increments=30"
        )
        self.assertEqual(code, 0, err)
        before = (self.folder / "out.h5").read_bytes()
        code, _, err = self.run_program(
            "run",
            "run.toml",
            "-o",
            "out.h5",
            "--resume",
            preexec_fn=limit_file_size(len(before) // 2),
        )
        self.assertEqual(code, 5, err)
        self.assertIn("out.h5: cannot be written: File too large", err)
        self.assertEqual((self.folder / "out.h5").read_bytes(), before)
        code, _, err = self.run_program("run", "run.toml", "-o", "out.h5", "--resume")
        self.assertEqual(code, 0, err)
        self.assertEqual(differing(self.folder / "whole.h5", self.folder / "out.h5"), [])

    def test_a_folder_that_vanishes(self):
        (self.folder / "there").mkdir()
        process = self.run_until(10, "there/out.h5", "--set", "stop.increments=100000")
        (self.folder / "there").rename(self.folder / "elsewhere")
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 5, err)
        self.assertIn("there/out.h5: cannot be written: No such file or directory", err)
        self.assertGreater(check_readable(self, self.folder / "elsewhere/out.h5"), 0)

    def test_a_file_that_is_replaced_under_a_run_is_the_runs_again(self):
        longer = ["--set", "stop.increments=300"]
        process = self.run_until(10, "out.h5", *longer)
        (self.folder / "other").write_text("something else")
        (self.folder / "other").rename(self.folder / "out.h5")
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0, err)
        code, _, err = self.run_program("run", "run.toml", "-o", "longer.h5", *longer)
        self.assertEqual(code, 0, err)
        self.assertEqual(differing(self.folder / "longer.h5", self.folder / "out.h5"), [])

    def test_a_table_that_cannot_be_written(self):
        with open("/dev/full", "w") as full:
            process = self.start("run", "run.toml", "-o", "out.h5")
            process.communicate()
            process = subprocess.Popen(
                [process.args[0], "run", "run.toml", "-o", "out2.h5"],
                cwd=self.folder,
                stdout=full,
                stderr=subprocess.PIPE,
                text=True,
            )
            _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 5)
        self.assertIn("standard output cannot be written", err)
        check_readable(self, self.folder / "out2.h5")


if __name__ == "__main__":
    unittest.main()
