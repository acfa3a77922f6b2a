#!/usr/bin/python3
"""The README does what it says: its commands run, its table is printed, its code blocks work."""

import contextlib
import io
import os
import re
import shlex
import unittest
from pathlib import Path

from support import ProgramTest

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text()
# Machines round differently; a coiling wire makes more of that than the digits of the table.
RELATIVE_TOLERANCE = 0.01
# Columns of the table that rounding does not rule: increment, L, phi, F, dE/dL, E_bend.
COMPARED = slice(0, 6)


def blocks(language):
    return re.findall(rf"^```{language}\n(.*?)^```$", README, re.M | re.S)


def commands():
    """Command lines of the README's transcript, each with the lines that it prints there."""
    found = []
    for line in README.splitlines():
        if line.startswith("    $ "):
            found.append((line.removeprefix("    $ "), []))
        elif found and line.startswith("    "):
            found[-1][1].append(line.removeprefix("    "))
        elif found:
            break
    return found


class Readme(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "data").symlink_to(ROOT / "data")

    def run_readme(self):
        """Runs the transcript here: what each command prints, beside what the README says."""
        results = []
        for command, shown in commands():
            program, *arguments = shlex.split(command)
            self.assertEqual(program, "build/wirepack")
            code, out, err = self.run_program(*arguments)
            self.assertEqual(code, 0, f"{command}: {err}")
            results.append((shown, out.splitlines()))
        return results

    def assert_row(self, shown, printed):
        expected = [float(number) for number in shown.split()[COMPARED]]
        found = [float(number) for number in printed.split()[COMPARED]]
        for one, other in zip(expected, found, strict=True):
            self.assertAlmostEqual(one, other, delta=RELATIVE_TOLERANCE * abs(other))

    def test_commands_run_and_the_first_prints_the_rows_that_are_shown(self):
        results = self.run_readme()
        self.assertGreaterEqual(len(results), 3)
        shown, printed = results[0]
        self.assertEqual(shown[:2], printed[:2])  # names and units of the columns
        self.assertGreater(len(shown), 2)
        rows = {line.split()[0]: line for line in printed[2:] if line.strip()}
        for row in shown[2:]:
            if row.strip() != "...":
                self.assert_row(row, rows[row.split()[0]])
        self.assertIn("quickstart.html", self.names())
        self.python_blocks_print_their_last_row(printed)

    def python_blocks_print_their_last_row(self, printed):
        (block,) = blocks("python")
        self.assertLessEqual(len(block.splitlines()), 7)
        code = block.replace('"quickstart.h5"', repr(str(self.folder / "quickstart.h5")))
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(compile(code, "README.md", "exec"), {})
        density, force, nodes = re.match(
            r"phi = (\S+), F R\^2/YI = (\S+), (\d+) nodes", out.getvalue()
        ).groups()
        last = [line.split() for line in printed if re.match(r" *\d+ +\d+\.\d{4} ", line)][-1]
        self.assertAlmostEqual(float(density), float(last[2]), delta=0.005)
        self.assertAlmostEqual(float(force), float(last[3]), delta=0.005)
        self.assertGreater(int(nodes), 250)
        self.assertIn("stopped by density", out.getvalue())

    def test_the_configuration_is_accepted_and_asks_for_what_it_says(self):
        (block,) = blocks("toml")
        self.write("config.toml", block)
        code, out, err = self.run_program("run", "config.toml", "--dry-run")
        self.assertEqual(code, 0, err)
        for line in ("radius = 10", "density = 0.2", 'setup = "low_torsion"'):
            self.assertRegex(out, rf"(?m)^{re.escape(line)}(\.0)?$")

    def test_the_program_is_an_example_that_is_compiled_and_run(self):
        (block,) = blocks("cpp")
        self.assertEqual(block, (ROOT / "apps/examples/injection_force.cpp").read_text())

    def test_commands_named_are_commands_of_the_program(self):
        _, help_text, _ = self.run_program("--help")
        known = set(re.findall(r"^  (\w+) ", help_text, re.M))
        named = set(re.findall(r"`(?:wirepack )?([a-z]+)` (?:\(|draws|writes|repeats)", README))
        self.assertTrue({"compare", "fit", "analyze", "verify"} <= named)
        self.assertTrue(named <= known, named - known)

    def test_it_has_a_hundred_lines_at_most(self):
        self.assertLessEqual(len(README.splitlines()), 100)

    def test_both_scripts_are_there(self):
        for script in ("apps/quickstart", "tests/run"):
            self.assertIn(f"    {script} ", README)
            self.assertTrue(os.access(ROOT / script, os.X_OK), script)


if __name__ == "__main__":
    unittest.main()
