"""wirepack compare: both methods on one scenario."""

import json
import re
import shutil
import unittest

from support import ProgramTest

SCENARIO = '[packing]\nsetup = "low_torsion"\n\n[cavity]\nradius = 4\n'


def numbers(value, name=""):
    """All numbers of a JSON document that are not of the machine, by name."""
    if isinstance(value, dict):
        for key, part in value.items():
            if key not in ("seconds", "configuration"):
                yield from numbers(part, f"{name}/{key}")
    elif isinstance(value, list):
        for i, part in enumerate(value):
            yield from numbers(part, f"{name}/{i}")
    elif isinstance(value, (int, float)):
        yield name, value


class Compare(ProgramTest):
    def test_both_methods_agree_and_the_second_call_goes_on_with_what_is_there(self):
        self.write("run.toml", SCENARIO)
        command = ["compare", "run.toml", "-o", "out", "--density", "0.23"]
        code, out, err = self.run_program(*command)
        self.assertEqual(code, 0, err)
        result = json.loads((self.folder / "out" / "comparison.json").read_text())
        energy = result["quantities"]["bend_energy"]
        self.assertTrue(energy["agrees"], out)
        self.assertLess(abs(energy["mean_difference"]), 0.03)
        budget = result["force_budget"]["dynamic_friction"]
        self.assertGreater(budget["force"], budget["stored"])
        page = (self.folder / "out" / "comparison.html").read_text()
        self.assertIn("<svg", page)
        self.assertNotIn("src=", page)
        self.assertFalse("<a " in page)
        history = (self.folder / "out" / "dynamic.h5").read_bytes()
        code, again, err = self.run_program(*command, "--page")
        self.assertEqual((code, again), (0, out), err)
        page = (self.folder / "out" / "comparison.html").read_text()
        links = re.findall(r'<a href="\./([^"]*)">([^<]*)</a>', page)
        ways = ("quasistatic", "dynamic", "quasistatic_friction", "dynamic_friction")
        self.assertEqual(links, [(f"{way}.html", f"{way}, seed 1") for way in ways])
        for file, _ in links:
            self.assertIn("<canvas", (self.folder / "out" / file).read_text())
        self.assertEqual(history, (self.folder / "out" / "dynamic.h5").read_bytes())
        code, _, err = self.run_program(*command, "--set", "wire.poisson_ratio=0.2")
        self.assertEqual(code, 2)
        self.assertIn("out/quasistatic.h5 cannot be continued with this configuration", err)

    def test_other_units_give_the_same_comparison(self):
        def compared(text):
            self.write("run.toml", text)
            command = ["compare", "run.toml", "-o", "out", "--density", "0.15"]
            code, out, err = self.run_program(*command)
            self.assertEqual(code, 0, err)
            result = json.loads((self.folder / "out" / "comparison.json").read_text())
            shutil.rmtree(self.folder / "out")
            return list(numbers(result))

        one = '[cavity]\nradius = 5\n[wire]\nedge_length = 2\n[insertion]\nincrement = 2\n'
        other = (
            "[cavity]\nradius = 5e-9\n[wire]\nradius = 1e-9\nyoungs_modulus = 2.6e8\n"
            "density = 1100\nedge_length = 2e-9\n[insertion]\nincrement = 2e-9\n"
        )
        first, second = compared(one), compared(other)
        self.assertEqual(len(first), len(second))
        for (name, value), (other_name, other_value) in zip(first, second):
            self.assertEqual(name, other_name)
            self.assertAlmostEqual(value, other_value, delta=1e-12 * abs(value), msg=name)

    def test_bad_input_leaves_nothing_behind(self):
        self.write("run.toml", SCENARIO)
        code, _, err = self.run_program("compare", "run.toml", "-o", "out", "--density", "1.5")
        self.assertEqual(code, 2)
        self.assertIn("--density = 1.5", err)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
