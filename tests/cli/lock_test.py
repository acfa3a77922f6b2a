#!/usr/bin/python3
"""One writer for a result, and what a run makes of signals."""

import os
import resource
import signal
import socket
import subprocess
import time
import unittest

import h5py

from support import ENDLESS, RunTest, check_readable


class OneWriter(RunTest):
    def test_a_second_run_into_a_file_is_refused_and_names_the_first(self):
        first = self.run_until(5, "out.h5", *ENDLESS)
        first.send_signal(signal.SIGSTOP)
        os.symlink("out.h5", self.folder / "link.h5")
        for target in ("out.h5", "link.h5"):
            for how in ("--resume", "--force"):
                code, out, err = self.run_program("run", "run.toml", "-o", target, how)
                self.assertEqual((code, out), (5, ""), err)
                self.assertIn(f"{target} is being written by process {first.pid} on ", err)
        first.send_signal(signal.SIGCONT)
        first.send_signal(signal.SIGTERM)
        _, err = first.communicate(timeout=60)
        self.assertEqual(first.returncode, 75, err)
        self.assertEqual(self.names(), ["link.h5", "out.h5", "run.toml"])

    def test_readers_are_not_in_the_way_of_a_run_nor_it_in_theirs(self):
        first = self.run_until(20, "out.h5")
        first.send_signal(signal.SIGSTOP)
        code, out, err = self.run_program("analyze", "out.h5")
        self.assertEqual(code, 0, err)
        with h5py.File(self.folder / "out.h5") as file:
            first.send_signal(signal.SIGCONT)
            _, err = first.communicate(timeout=60)
            self.assertEqual(first.returncode, 0, err)
            self.assertGreaterEqual(len(file["history/increment"]), 19)

    def test_a_killed_run_leaves_no_lock(self):
        first = self.run_until(5, "out.h5")
        first.kill()
        first.communicate()
        self.assertIn("out.h5.lock", self.names())
        code, _, err = self.run_program("run", "run.toml", "-o", "out.h5", "--resume")
        self.assertEqual(code, 0, err)
        self.assertEqual(self.names(), ["out.h5", "run.toml"])

    def test_a_finished_run_needs_no_lock(self):
        code, _, err = self.run_program("run", "run.toml", "-o", "out.h5")
        self.assertEqual(code, 0, err)
        self.write("out.h5.lock", "something of the user")
        code, _, err = self.run_program("run", "run.toml", "-o", "out.h5", "--resume")
        self.assertEqual(code, 0, err)
        self.assertIn("is finished", err)

    def test_a_file_in_place_of_the_lock_is_left_alone(self):
        self.write("out.h5.lock", "something of the user")
        code, _, err = self.run_program("run", "run.toml", "-o", "out.h5")
        self.assertEqual(code, 5)
        self.assertIn("out.h5.lock: is in the way", err)
        self.assertEqual((self.folder / "out.h5.lock").read_text(), "something of the user")


class Saving(RunTest):
    def run_whole(self, *arguments, **options):
        code, _, err = self.run_program("run", "run.toml", "-o", "out.h5", *arguments, **options)
        self.assertEqual(code, 0, err)

    def test_rights_of_a_file_survive_a_save(self):
        self.run_whole("--set", "stop.increments=10")
        for mode in (0o640, 0o666):
            (self.folder / "out.h5").chmod(mode)
            self.run_whole("--resume", "--set", f"stop.increments={mode // 20}")
            self.assertEqual((self.folder / "out.h5").stat().st_mode & 0o7777, mode)

    def test_only_temporary_files_that_are_surely_of_a_dead_run_are_removed(self):
        self.run_whole("--set", "stop.increments=10")
        ended = subprocess.Popen(["true"])
        ended.wait()
        host = socket.gethostname()
        others = [
            f"out.h5.{ended.pid}.tmp",
            f".wirepack-elsewhere-{ended.pid}.tmp",
            f".wirepack-{host}-{os.getpid()}.tmp",
            f".wirepack-{host}-mine.tmp",
        ]
        for name in [*others, f".wirepack-{host}-{ended.pid}.tmp"]:
            self.write(name, "")
        self.run_whole("--resume")
        self.assertEqual(self.names(), sorted([*others, "out.h5", "run.toml"]))

    def test_the_longest_name_that_leaves_room_for_the_lock_can_be_saved(self):
        name = "a" * 247 + ".h5"
        code, _, err = self.run_program("run", "run.toml", "-o", name, "--set", "stop.increments=5")
        self.assertEqual(code, 0, err)
        self.assertEqual(self.names(), [name, "run.toml"])


class Log(RunTest):
    def test_a_log_has_messages_and_exit_codes_of_all_attempts(self):
        arguments = ["run", "run.toml", "-o", "out.h5", "--resume", "--log", "run.log"]
        code, out, err = self.run_program(*arguments, "--set", "stop.increments=20")
        self.assertEqual((code, out, err), (0, "", ""))
        code, out, err = self.run_program(*arguments)
        self.assertEqual((code, out, err), (0, "", ""))
        lines = (self.folder / "run.log").read_text().splitlines()
        self.assertEqual(lines.count("wirepack run: exit code 0"), 2)
        self.assertEqual(lines[-1], "wirepack run: exit code 0")
        # before the last one, which a limit may have cut short
        self.assertIn("wirepack run: out.h5: going on after increment 19", lines)
        self.assertIn("# stopped by            increments", lines)
        before = (self.folder / "run.log").read_bytes()
        code, _, err = self.run_program(*arguments)
        self.assertEqual(code, 0)
        self.assertIn("is finished", err)
        self.assertEqual((self.folder / "run.log").read_bytes(), before)


class Signals(RunTest):
    def test_usr1_saves_and_the_run_goes_on(self):
        process = self.run_until(30, "out.h5", *ENDLESS, "--set", "output.frame_every_density=1")
        self.assertLess(self.saved(), 30)
        process.send_signal(signal.SIGUSR1)
        for line in process.stdout:
            if int(line.split()[0]) % 60 == 0 and self.saved() >= 30:
                break
        self.assertGreaterEqual(self.saved(), 30)
        self.assertIsNone(process.poll())

    def test_a_hangup_and_the_limit_of_processor_time_save(self):
        for number in (signal.SIGHUP, signal.SIGXCPU):
            process = self.run_until(20, "out.h5", "--force", *ENDLESS)
            process.send_signal(number)
            _, err = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 75, err)
            self.assertGreaterEqual(check_readable(self, self.folder / "out.h5"), 20)
            self.check_goes_on_to_the_same_bits()

    def test_a_limit_of_processor_time_is_noticed(self):
        code, _, err = self.run_program(
            "run",
            "run.toml",
            "-o",
            "out.h5",
            *ENDLESS,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (1, 30)),
        )
        self.assertEqual(code, 75, err)
        self.assertGreater(check_readable(self, self.folder / "out.h5"), 0)

    def test_what_was_ignored_at_the_start_stays_ignored(self):
        def ignore():
            signal.signal(signal.SIGHUP, signal.SIG_IGN)
            signal.signal(signal.SIGINT, signal.SIG_IGN)

        more = ["--set", "stop.increments=300"]
        process = self.run_until(10, "out.h5", *more, preexec_fn=ignore)
        process.send_signal(signal.SIGHUP)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0, err)

    def test_an_interrupt_after_a_stop_ends_at_once_without_harm(self):
        for _ in range(20):
            process = self.run_until(20, "out.h5", "--force", *ENDLESS[:2])
            process.send_signal(signal.SIGTERM)
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=60)
            if process.returncode != 75:  # between the two it may have saved and ended
                break
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.assertGreater(check_readable(self, self.folder / "out.h5"), 0)
        self.check_goes_on_to_the_same_bits()
        self.assertNotIn("out.h5.lock", self.names())

    def test_schedulers_may_repeat_themselves(self):
        process = self.run_until(20, "out.h5", *ENDLESS)
        for _ in range(3):
            process.send_signal(signal.SIGTERM)
            time.sleep(0.001)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 75)


if __name__ == "__main__":
    unittest.main()
