#!/usr/bin/python3
"""A hundred kills at random moments: each leaves a whole file, and in the end no bit differs."""

import random
import time
import unittest

from support import ProgramTest, SMALL_RUN, check_readable, differing

KILLS = 100


class Kills(ProgramTest):
    def test_a_hundred_kills_lose_nothing(self):
        self.write("run.toml", SMALL_RUN.replace("radius = 4", "radius = 6").replace("60", "150"))
        code, _, err = self.run_program("run", "run.toml", "-o", "whole.h5", timeout=200)
        self.assertEqual(code, 0, err)
        killed = self.folder / "killed.h5"
        choice = random.Random(11)
        kills, saved = 0, 0
        while kills < KILLS:
            process = self.start("run", "run.toml", "-o", "killed.h5", "--resume")
            time.sleep(choice.uniform(0.0, 0.4))
            process.kill()
            process.communicate()
            if process.returncode == 0:  # it was through: once more from the start
                self.assertEqual(differing(self.folder / "whole.h5", killed), [])
                killed.unlink()
                saved = 0
                continue
            kills += 1
            if killed.exists():
                now = check_readable(self, killed)
                self.assertGreaterEqual(now, saved)
                saved = now
        code, _, err = self.run_program(
            "run", "run.toml", "-o", "killed.h5", "--resume", timeout=200
        )
        self.assertEqual(code, 0, err)
        self.assertEqual(differing(self.folder / "whole.h5", killed), [])
        self.assertEqual(self.names(), ["killed.h5", "run.toml", "whole.h5"])


if __name__ == "__main__":
    unittest.main()
