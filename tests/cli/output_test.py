"""No output destroys: what -o may name, and what is there afterwards, for every command."""

import math
import os
import unittest

from support import SMALL_RUN, ProgramTest

POINTS = "".join(f"{3 * math.cos(i / 9)},{3 * math.sin(i / 9)},{i / 50}\n" for i in range(60))


class Output(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("points.csv", POINTS)
        self.write(
            "run.toml",
            SMALL_RUN
            + "[wire]\nreference_shape = 'rest.toml'\nreference_shape_beyond = 'extend'\n",
        )
        self.write("rest.toml", "[shape]\nk0 = [[0, 0, 0.1, 0], [1, 0, 0.1, 0]]\n")
        self.commands = {
            "fit": ("fit", "points.csv", "--model", "helix"),
            "run": ("run", "run.toml", "--set", "stop.increments=2"),
            "view": ("view", "made.h5"),
        }
        self.assertEqual(self.call("run", "made.h5")[0], 0)

    def call(self, command, output, *more):
        return self.run_program(*self.commands[command], "-o", output, *more)

    def refused(self, command, output, part, *more, code=2):
        returned, out, err = self.call(command, output, *more)
        self.assertEqual((returned, out), (code, ""), err)
        self.assertEqual(len(err.splitlines()), 1, err)
        self.assertIn(part, err)

    def test_what_is_there_is_replaced_only_when_forced(self):
        for command in self.commands:
            with self.subTest(command):
                self.write("there", "something")
                self.refused(command, "there", "there exists; ")
                self.assertEqual((self.folder / "there").read_text(), "something")
                self.assertEqual(self.call(command, "there", "--force")[0], 0)
                self.assertNotEqual((self.folder / "there").read_bytes(), b"something")

    def test_an_input_is_never_replaced_under_any_name(self):
        for command, inputs in {
            "fit": ["points.csv"],
            "run": ["run.toml", "rest.toml"],
            "view": ["made.h5"],
        }.items():
            for name in inputs:
                for link in (None, os.symlink, os.link):
                    with self.subTest((command, name, link)):
                        output = name if link is None else "other_name"
                        if link is not None:
                            link(self.folder / name, self.folder / output)
                        before = (self.folder / name).read_bytes()
                        self.refused(command, output, "is an input of this command", "--force")
                        self.assertEqual((self.folder / name).read_bytes(), before)
                        if link is not None:
                            (self.folder / output).unlink()

    def test_a_log_is_added_neither_to_an_input_nor_to_the_result(self):
        os.symlink(self.folder / "new.h5", self.folder / "name_of_the_result")
        os.link(self.folder / "rest.toml", self.folder / "name_of_the_shape")
        for log, part in {
            "run.toml": "is an input of this command",
            "name_of_the_shape": "is an input of this command",
            "new.h5": "is the result, new.h5",
            "name_of_the_result": "is the result, new.h5",
            ".": "is a folder",
            "/dev/full": "is not a regular file",
        }.items():
            with self.subTest(log):
                before = {name: (self.folder / name).read_bytes() for name in self.files()}
                self.refused("run", "new.h5", part, "--log", log)
                after = {name: (self.folder / name).read_bytes() for name in self.files()}
                self.assertEqual(after, before)
        self.write("run.log", "earlier\n")
        self.assertEqual(self.call("run", "new.h5", "--log", "run.log")[0], 0)
        log = (self.folder / "run.log").read_text()
        self.assertTrue(log.startswith("earlier\n") and log.endswith("exit code 0\n"), log)

    def files(self):
        return [path.name for path in self.folder.iterdir() if path.is_file()]

    def test_folders_devices_and_pipes_are_refused(self):
        (self.folder / "folder").mkdir()
        os.mkfifo(self.folder / "pipe")
        (self.folder / "to_pipe").symlink_to("pipe")
        for command in self.commands:
            self.refused(command, "folder", "is a folder", "--force")
            self.refused(command, "new/", "is a folder")
            for name in ("pipe", "to_pipe", "/dev/null", "/dev/full"):
                self.refused(command, name, "is not a regular file", "--force")
            self.refused(command, "none/out", "there is no folder none", code=5)
            self.refused(command, "points.csv/out", "cannot be written", code=5)

    def test_links_are_followed_also_to_where_nothing_is_yet(self):
        (self.folder / "scratch").mkdir()
        for command in self.commands:
            with self.subTest(command):
                target = self.folder / "scratch" / command
                link = self.folder / ("link_" + command)
                link.symlink_to("scratch/" + command)
                self.assertEqual(self.call(command, link.name)[0], 0)
                self.assertTrue(link.is_symlink() and target.is_file())
                self.refused(command, link.name, "exists; ")
                self.assertEqual(self.call(command, link.name, "--force")[0], 0)
                self.assertTrue(link.is_symlink())
                self.assertEqual([p.name for p in target.parent.iterdir() if ".tmp" in p.name], [])
        (self.folder / "loop").symlink_to("loop")
        self.refused("fit", "loop", "is a symbolic link to itself")

    def test_figures_and_pages_are_replaced_only_when_forced(self):
        self.assertEqual(self.call("run", "out.h5")[0], 0)
        fit = (*self.commands["fit"], "-o", "shape.toml", "--figures", "figures")
        for command, name in (
            (("figures", "out.h5", "-o", "figures"), "force.pdf"),
            (fit, "fit.dat"),
        ):
            with self.subTest(command[0]):
                (self.folder / "figures").mkdir(exist_ok=True)
                self.write("figures/" + name, "mine")
                code, out, err = self.run_program(*command)
                self.assertEqual((code, out), (2, ""), err)
                self.assertIn(f"figures/{name} exists", err)
                self.assertEqual((self.folder / "figures" / name).read_text(), "mine")
                code, _, err = self.run_program(*command, "--force")
                self.assertEqual(code, 0, err)
                self.assertNotEqual((self.folder / "figures" / name).read_bytes(), b"mine")
                self.assertEqual(
                    [p.name for p in (self.folder / "figures").iterdir() if p.name[0] == "."], []
                )
        for name in ("comparison.html", "max_overlap.png"):
            (self.folder / "pages").mkdir(exist_ok=True)
            self.write("pages/" + name, "mine")
            code, out, err = self.run_program("compare", "run.toml", "-o", "pages")
            self.assertEqual((code, out), (2, ""), err)
            self.assertIn(f"pages/{name} exists", err)
            (self.folder / "pages" / name).unlink()


if __name__ == "__main__":
    unittest.main()
