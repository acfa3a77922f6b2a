#!/usr/bin/python3
"""A large packing ends in the same bits by any number of threads, stopped in between or not."""

import unittest

from support import ProgramTest, differing

# Some 670 nodes, and snaps of hundreds of evaluations in which any other rounding shows.
LARGE_RUN = """
[packing]
setup = "low_torsion"
[cavity]
radius = 20
[wire]
edge_length = 2
[insertion]
increment = 2
[stop]
increments = 700
"""


class LargeRun(ProgramTest):
    def pack(self, name, *arguments):
        code, _, err = self.run_program("run", "run.toml", "-o", name, *arguments, timeout=280)
        self.assertEqual(code, 0, err)
        return self.folder / name

    def test_neither_threads_nor_a_stop_change_a_bit(self):
        self.write("run.toml", LARGE_RUN)
        whole = self.pack("whole.h5")
        by_two = self.pack("by_two.h5", "--threads", "2")
        self.assertEqual(differing(whole, by_two), [])
        self.pack("stopped.h5", "--set", "stop.increments=600")
        stopped = self.pack("stopped.h5", "--resume", "--threads", "3")
        # where it stopped a run leaves a frame, and counts the next from there
        others = [name for name in differing(whole, stopped) if not name.startswith("frames/")]
        self.assertEqual(others, [])


if __name__ == "__main__":
    unittest.main()
