"""wirepack view: the page holds what it must, and bad input gives one message and no page."""

import os
import unittest

import h5py

from support import SMALL_RUN, ProgramTest


class View(ProgramTest):
    def make_result(self, name="result.h5"):
        self.write("scenario.toml", SMALL_RUN)
        code, _, err = self.run_program("run", "scenario.toml", "-o", name)
        self.assertEqual(code, 0, err)
        return self.folder / name

    def expect_refusal(self, expected_code, part, *arguments):
        before = self.names()
        code, out, err = self.run_program("view", *arguments)
        self.assertEqual(code, expected_code, err)
        self.assertEqual(out, "")
        self.assertEqual(len(err.strip().splitlines()), 1, err)
        self.assertIn(part, err)
        self.assertEqual(self.names(), before)

    def test_the_page_is_one_file_that_names_no_other_and_equal_calls_give_equal_bytes(self):
        self.make_result()
        for page in ("one.html", "two.html"):
            code, out, err = self.run_program("view", "result.h5", "-o", page)
            self.assertEqual((code, out), (0, page + "\n"), err)
        text = (self.folder / "one.html").read_text()
        self.assertEqual(text, (self.folder / "two.html").read_text())
        self.assertIn("default-src 'none'", text)
        for reference in ("src=", "href=", "@import", "url("):
            self.assertNotIn(reference, text)

    def test_a_chosen_number_of_frames_has_the_last_one(self):
        result = self.make_result()
        with h5py.File(result) as file:
            names = [int(name) for name in file["frames"]]
        self.assertGreater(len(names), 3)
        code, _, err = self.run_program("view", "result.h5", "-o", "page.html", "--frames", 2)
        self.assertEqual(code, 0, err)
        text = (self.folder / "page.html").read_text()
        self.assertEqual(text.count('"quantum":'), 2)
        self.assertIn(f'"increment":{max(names)}.0', text)

    def test_one_frame_is_enough_and_none_is_refused(self):
        result = self.make_result()
        with h5py.File(result, "r+") as file:
            for name in sorted(file["frames"])[1:]:
                del file["frames"][name]
        code, _, err = self.run_program("view", "result.h5", "-o", "page.html")
        self.assertEqual(code, 0, err)
        with h5py.File(result, "r+") as file:
            for name in list(file["frames"]):
                del file["frames"][name]
        self.expect_refusal(5, "holds no frame yet", "result.h5", "-o", "none.html")

    def test_what_is_no_result_is_refused(self):
        result = self.make_result()
        self.write("text.h5", "no result")
        with h5py.File(self.folder / "other.h5", "w") as file:
            file["x"] = [1.0]
        whole = result.read_bytes()
        self.write("cut.h5", whole[: len(whole) // 2])
        self.expect_refusal(5, "no such file", "missing.h5", "-o", "page.html")
        self.expect_refusal(5, "not an HDF5 file", "text.h5", "-o", "page.html")
        self.expect_refusal(5, "not a result file of wirepack", "other.h5", "-o", "page.html")
        self.expect_refusal(5, "damaged", "cut.h5", "-o", "page.html")
        self.expect_refusal(5, "not a file", ".", "-o", "page.html")

    def test_a_page_never_takes_the_place_of_something_unasked(self):
        self.make_result()
        old = self.write("old.html", "old")
        self.expect_refusal(2, "--force", "result.h5", "-o", "old.html")
        self.assertEqual(old.read_text(), "old")
        os.symlink("result.h5", self.folder / "link.html")
        for page in ("result.h5", "./result.h5", "link.html"):
            self.expect_refusal(
                2, "is an input of this command", "result.h5", "-o", page, "--force"
            )
        (self.folder / "folder").mkdir()
        self.expect_refusal(2, "is a folder", "result.h5", "-o", "folder", "--force")
        code, _, err = self.run_program("view", "result.h5", "-o", "old.html", "--force")
        self.assertEqual(code, 0, err)
        self.assertTrue(old.read_text().startswith("<!DOCTYPE html>"))

    def test_a_page_that_cannot_be_written_is_a_file_error_with_the_reason(self):
        self.make_result()
        self.expect_refusal(5, "there is no folder missing", "result.h5", "-o", "missing/page.html")

    def test_a_wrong_call_is_bad_input(self):
        self.make_result()
        self.expect_refusal(2, "-o", "result.h5")
        self.expect_refusal(2, "--frames", "result.h5", "-o", "page.html", "--frames", "0")


if __name__ == "__main__":
    unittest.main()
