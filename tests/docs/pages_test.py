#!/usr/bin/python3
"""Pages name files, headings, datasets and tests that are there."""

import re
import unittest
from pathlib import Path

import h5py

from support import ProgramTest

ROOT = Path(__file__).parents[2]
PAGES = [
    ROOT / "README.md",
    ROOT / ".github/CONTRIBUTING.md",
    *sorted((ROOT / "data/docs").glob("*.md")),
]
FRICTION_IN_TIME = """
[packing]
method = "dynamic"
[cavity]
radius = 4
[stop]
increments = 3
"""


def anchors(page):
    """Headings as links name them."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(), re.M)
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}


class Links(unittest.TestCase):
    def test_every_link_leads_to_a_file_and_a_heading_that_are_there(self):
        count = 0
        for page in PAGES:
            for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text()):
                if "://" in target:
                    continue
                name, _, anchor = target.partition("#")
                linked = page.parent / name if name else page
                self.assertTrue(linked.exists(), f"{page.name}: {target}")
                if anchor:
                    self.assertIn(anchor, anchors(linked), f"{page.name}: {target}")
                count += 1
        self.assertGreater(count, 30)

    def test_every_page_is_in_the_index_of_the_readme(self):
        readme = PAGES[0].read_text()
        for page in PAGES[2:]:
            self.assertIn(f"(data/docs/{page.name})", readme)

    def test_paths_in_pages_are_files_of_the_tree(self):
        path = re.compile(r"`((?:src|include|apps|tests|data)/[\w./-]+)`")
        for page in PAGES:
            for name in path.findall(page.read_text()):
                self.assertTrue((ROOT / name).exists() or "NAME" in name, f"{page.name}: {name}")

    def test_tests_that_the_page_on_validation_names_are_there(self):
        sources = "".join(file.read_text() for file in (ROOT / "tests").rglob("*_test.cpp"))
        suites = set(re.findall(r"TEST(?:_[PF])?\(\s*(\w+),", sources))
        named = re.findall(r"`(\w+)\.\*`", (ROOT / "data/docs/validation.md").read_text())
        self.assertGreater(len(named), 20)
        self.assertEqual(set(named) - suites, set())


class ResultFile(ProgramTest):
    def test_the_page_names_every_group_dataset_and_attribute_of_a_run(self):
        page = (ROOT / "data/docs/result_file.md").read_text()
        # `energy_, list_seconds` stands for energy_seconds and list_seconds
        known = set(re.findall(r"\w+", page))
        known |= {word + "seconds" for word in known if word.endswith("_")}
        self.write("run.toml", FRICTION_IN_TIME)
        for method in ("quasistatic", "dynamic"):
            code, _, err = self.run_program(
                "run", "run.toml", "-o", f"{method}.h5", "--method", method
            )
            self.assertEqual(code, 0, err)
            with h5py.File(self.folder / f"{method}.h5") as file:
                self.assertEqual(self.unnamed(file, known), set())

    def unnamed(self, file, known):
        names = set(file.attrs)

        def note(path, item):
            if path.startswith("checkpoint"):  # for the program alone
                return
            names.update(part for part in path.split("/") if not part.isdigit())
            names.update(item.attrs)

        file.visititems(note)
        return names - known


if __name__ == "__main__":
    unittest.main()
