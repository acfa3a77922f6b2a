#!/usr/bin/python3
"""The page on Python says what wirepack.py does: its code runs."""

import contextlib
import os
import re
import sys
import unittest
from pathlib import Path

from support import ProgramTest

ROOT = Path(__file__).parents[2]
READING, PACKING = (ROOT / "data/docs/python.md").read_text().split("\n## Packing\n")
SCENARIO = "[cavity]\nradius = 4\n[stop]\ndensity = 0.21\n"

sys.path.insert(0, str(ROOT / "apps/python"))


class PythonPage(ProgramTest):
    def run_blocks(self, text):
        """Runs the code of a text, as one program; returns its names."""
        names = {}
        with contextlib.chdir(self.folder):
            for block in re.findall(r"^```python\n(.*?)^```$", text, re.M | re.S):
                exec(block, names)
        return names

    def setUp(self):
        super().setUp()
        self.write("run.toml", SCENARIO)

    def test_results_are_read_as_it_says(self):
        code, _, err = self.run_program("run", "run.toml", "-o", "out.h5")
        self.assertEqual(code, 0, err)
        self.assertGreater(len(self.run_blocks(READING)["run"].frames[0.1:0.2]), 5)

    @unittest.skipUnless(os.environ.get("WIREPACK_MODULE"), "built without the module")
    def test_wires_are_packed_as_it_says(self):
        sys.path.insert(0, os.environ["WIREPACK_MODULE"])
        names = self.run_blocks(PACKING)
        self.assertEqual(names["packer"].stop_reason, "density")
        self.assertEqual(len(names["density"]), 20)
        self.assertTrue((self.folder / "packed.h5").exists())
        for name in re.findall(r"^\| `(\w+)", PACKING, re.M):
            self.assertTrue(hasattr(names["wirepack"], name) or name in ("ValueError", "OSError"))


if __name__ == "__main__":
    unittest.main()
