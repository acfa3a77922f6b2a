#!/usr/bin/python3
"""Sweeps under GNU parallel."""

import shutil
import signal
import unittest

from sweep_support import TASKS, Stops, SweepTest


@unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
class UnderParallel(SweepTest):
    def test_killed_twice_it_ends_in_the_same_bits(self):
        code, _, err = self.run_program("sweep", "plan.toml", "-o", "whole", timeout=120)
        self.assertEqual(code, 0, err)
        stops = Stops(self, "part")
        arguments = ["sweep", "plan.toml", "-o", "part", "--executor", "parallel", "--jobs", "2"]
        for done in (4, 9):
            process = self.start(*arguments, start_new_session=True)
            self.wait_for_done("part", done, process)
            process.send_signal(signal.SIGTERM)
            process.communicate(timeout=60)
            self.assertEqual(process.returncode, 75)
            for task in self.tasks("part"):
                self.assertEqual(self.status("part")[task.name][0], self.true_state(task)[0])
            stops.note()
        code, out, err = self.run_program(*arguments, timeout=120)
        self.assertEqual((code, out), (0, f"# {TASKS} tasks: {TASKS} done\n"), err)
        self.check_same_bits("whole", "part")
        stops.check()

    def test_hosts_of_a_file_share_the_tasks_over_ssh(self):
        # in the place of ssh: notes the host, and does here what it is told
        ssh = self.write(
            "ssh",
            f"""#!/bin/bash
echo "$1" >> {self.folder}/calls
exec bash -c "${{*:3}}"  # behind HOST --
""",
        )
        ssh.chmod(0o755)
        self.write("hosts", f"1/{ssh} one\n1/{ssh} other\n")
        arguments = ["sweep", "plan.toml", "-o", "out", "--executor", "parallel"]
        code, out, err = self.run_program(*arguments, "--hosts", "hosts", timeout=120)
        self.assertEqual((code, out), (0, f"# {TASKS} tasks: {TASKS} done\n"), err)
        calls = (self.folder / "calls").read_text().split()
        self.assertEqual(set(calls), {"one", "other"})
        self.assertGreaterEqual(len(calls), TASKS)


if __name__ == "__main__":
    if shutil.which("parallel") is None:
        print("skipped: GNU parallel is not installed")
    unittest.main()
