#!/usr/bin/python3
"""Wrong input of any kind: one message, exit code 2, nothing written."""

import unittest

from support import ProgramTest, SMALL_RUN


class BadInput(ProgramTest):
    def refuse(self, arguments, *parts, code=2, lines=1):
        before = self.names()
        returned, out, err = self.run_program(*arguments)
        self.assertEqual(returned, code, err)
        self.assertEqual(out, "")
        self.assertEqual(len(err.splitlines()), lines, err)
        for part in parts:
            self.assertIn(part, err)
        self.assertEqual(self.names(), before)

    def refuse_config(self, text, *parts, lines=1):
        config = self.write("run.toml", text)
        self.refuse(["run", config.name, "-o", "out.h5"], *parts, lines=lines)

    def refuse_set(self, assignment, *parts):
        self.write("run.toml", SMALL_RUN)
        self.refuse(["run", "run.toml", "-o", "out.h5", "--set", assignment], *parts)

    def test_values_that_are_impossible(self):
        for text, allowed in [
            ("[cavity]\nradius = -4", "run.toml:2:1: cavity.radius = -4: must be positive"),
            ("[cavity]\nradius = 0", "cavity.radius = 0: must be positive"),
            ("[cavity]\nradius = nan", "must be a finite number"),
            ("[cavity]\nradius = inf", "must be a finite number"),
            ("[cavity]\nradius = 1.5", "must be at least twice wire.radius"),
            ("[wire]\npoisson_ratio = -1", "run.toml:2:1: wire.poisson_ratio = -1"),
            ("[wire]\ndensity = 0", "must be positive and finite"),
            ("[wire]\nedge_length = -1", "wire.edge_length = -1: must be positive"),
            ("[wire]\nradius = 1e-31", "2:1: wire.radius = 1e-31: must be between 1e-30 and 1e30"),
            ("[wire]\nyoungs_modulus = 1e61", "must be between 1e-60 and 1e60"),
            ("[wire]\ndensity = 1e-300", "wire.density = 1e-300: must be between 1e-60 and 1e60"),
            ("[contact]\nstiffness = 1e13", "must be between 5e-12 and 5e+12"),
            ("[dynamics]\ninsertion_speed = 1e-300", "dynamics.insertion_speed = 1e-300: its size"),
            ("[packing]\nseed = -1", "from 0 to"),
            ("[minimizer]\nmemory = 3000000000", "minimizer.memory"),
            ("[stop]\nincrements = 0", "stop.increments = 0: must be at least 1"),
            (
                "[stop]\ndensity = 1.5",
                "must be below 1 and above the density of the first two edges",
            ),
        ]:
            with self.subTest(text):
                self.refuse_config(text, allowed)

    def test_runs_that_no_machine_can_do_are_refused_with_an_estimate(self):
        for text in (
            "[cavity]\nradius = 1000",
            "[cavity]\nradius = 10\n[output]\nframe_every_density = 1e-12",
        ):
            parts = ["a run at R = 10", " is impossible: about ", " nodes", " GB", "years", "stop"]
            self.refuse_config(text, *parts)
            self.refuse(["run", "run.toml", "--dry-run"], *parts)
        self.write("run.toml", "[cavity]\nradius = 1000\n[stop]\nlength = 100")
        code, out, err = self.run_program("run", "run.toml", "--dry-run")
        self.assertEqual(code, 0, err)

    def test_wrong_types(self):
        for text, allowed in [
            (
                '[cavity]\nradius = "5"',
                'run.toml:2:1: cavity.radius = "5": must be a finite number',
            ),
            ("[cavity]\nradius = [5]", "must be a finite number"),
            ("[cavity]\nradius = 2020-01-01", "must be a finite number"),
            ("[contact]\nenabled = 1", "must be true or false"),
            ("[stop]\nincrements = 5.0", "must be an integer"),
            ("[packing]\nsetup = 5", 'must be "low_torsion" or "high_torsion"'),
            ('[packing]\nsetup = "low"', 'must be "low_torsion" or "high_torsion"'),
            ("cavity = 5", "is outside of a section"),
            ("[cavity]\nradius = 5\nradius = 6", "run.toml:3:"),
            ("[cavity]\nradius = 5\nradius = 6", "redefine"),
            ("[cavity]\nradius = 10\n[nozzle]\nposition = [0, 12, 0]", "the wall at [0, 9, 0]"),
        ]:
            with self.subTest(text):
                self.refuse_config(text, allowed)

    def test_unknown_names(self):
        self.refuse_config("[cavity]\nraduis = 5", "did you mean cavity.radius?")
        self.refuse_config("[cavty]\nradius = 5", "did you mean [cavity]?")
        self.refuse_config("[cavity]\nexcluded_arc_length = 5", "did you mean contact.excluded")
        self.refuse_config(
            "[cavity]\nqqqqqqqq = 5", "[cavity] has shape, radius, semi_axes, wall_stiffness"
        )

    def test_friction_and_dynamics_that_cannot_be(self):
        dynamic = '[packing]\nmethod = "dynamic"\n'
        for text, allowed in [
            ("[friction]\nstatic = 0.1", "friction.dynamic = 0.18: must be between 0 and friction"),
            ("[friction]\nstatic = -1\ndynamic = 0", "friction.static = -1: must be between 0 and"),
            ("[friction]\nslip_tolerance = 1", "friction.slip_tolerance = 1: must be between"),
            ("[dynamics]\ndamping = -0.1", "dynamics.damping = -0.1: must be finite and not neg"),
            ("[dynamics]\ninsertion_speed = 0", "dynamics.insertion_speed = 0: must be positive"),
            ('[dynamics]\ntime_step = "slow"', 'must be a finite number or "auto"'),
        ]:
            with self.subTest(text):
                self.refuse_config(dynamic + text, allowed)

    def test_imperfections_that_cannot_be(self):
        for text, allowed in [
            ("nozzle_tilt = 1", "imperfection.nozzle_tilt = 1: must be between 0 and 0.5 (rad)"),
            ("nozzle_offset = -1", "imperfection.nozzle_offset = -1: must be between 0 and"),
            (
                "natural_curvature = 2",
                "imperfection.natural_curvature = 2: must be between 0 and 1",
            ),
            ("nozle_tilt = 1", "did you mean imperfection.nozzle_tilt?"),
            ("tilt = 1", "unknown key; [imperfection] has natural_curvature, nozzle_offset"),
        ]:
            with self.subTest(text):
                self.refuse_config("[imperfection]\n" + text, allowed)

    def test_all_problems_are_named_at_once(self):
        text = "[cavity]\nradius = -1\nraduis = 2\n[stop]\nforce = true\n[packing]\nsetup = 1"
        self.refuse_config(text, ":2:1:", ":3:1:", ":5:1:", ":7:1:", lines=4)

    def test_files_that_are_no_configuration(self):
        self.refuse_config("", "has no key at all")
        self.refuse_config("# only a comment\n[cavity]\n", "has no key at all")
        self.refuse_config("[cavity\nradius = 5", "run.toml:1:8")
        self.refuse_config("[cavity]\nradius = 5\nradius = 6", "run.toml:3:")
        self.refuse_config(b"\x89HDF\r\n\x1a\n\x00\x00", "is not a text file")
        self.refuse_config(b'[packing]\nsetup = "\xff"', "UTF-8")
        self.refuse_config("#" * 2_000_000, "larger than 1 MB")
        self.refuse(["run", "none.toml", "-o", "out.h5"], "none.toml: there is no such file")
        self.refuse(["run", ".", "-o", "out.h5"], "is a folder")
        self.refuse(["run", "/dev/zero", "-o", "out.h5"], "is not a regular file")

    def test_texts_that_are_too_deep_for_a_stack_are_refused_wherever_toml_is_read(self):
        for text, part in {
            "a." * 200_000 + "b = 1": "joined by more than 32 dots",
            "[" + "1." * 200_000 + "1]\nb = 1": "joined by more than 32 dots",
            "a = {b" + '."b"' * 200_000 + " = 1}": "joined by more than 32 dots",
            "[a]\nb = " + "[" * 200_000: "nested",
            "[" * 200_000: ":1:",
            "[a]\n" + (' = [\n{"y"' + " . 1.1 . y" * 10).join(["b"] * 250): "nested",
        }.items():
            with self.subTest(text[:20]):
                self.refuse_config(text, part)
                self.write("plan.toml", text)
                self.refuse(["sweep", "plan.toml", "-o", "out"], "plan.toml:", part)
                (self.folder / "plan.toml").unlink()
                self.write("shape.toml", text)
                self.refuse_config('[wire]\nreference_shape = "shape.toml"', "shape.toml:", part)
                (self.folder / "shape.toml").unlink()

    def test_names_deep_within_values_deep_within_each_other_are_read(self):
        opened = ["b"] + 119 * ['[\n{"y"' + " . 1.1 . y" * 10]
        self.refuse_config("[a]\n" + " = ".join(opened) + " = 1" + "}]" * 119, "unknown section")

    def test_overrides(self):
        form = "must have the form section.key=value"
        for assignment in ["", "radius", "radius=5", ".radius=5", "cavity.=5", "cavity.radius="]:
            with self.subTest(assignment):
                self.refuse_set(assignment, form if assignment else "--set")
        self.refuse_set("cavity.radius=-3", "--set cavity.radius=-3: cavity.radius = -3: must be")
        self.refuse_set("cavity.radius=abc", 'cavity.radius = "abc": must be a finite number')
        self.refuse_set("cavity.raduis=3", "did you mean cavity.radius?")
        self.refuse_set("stop.force=1\nx=2", "stop.force")

    def test_command_line(self):
        self.write("run.toml", SMALL_RUN)
        self.refuse([], "subcommand")
        self.refuse(["rnu"], "rnu")
        self.refuse(["run"], "CONFIG.toml is required")
        self.refuse(["run", "run.toml"], "-o OUT.h5 is needed")
        self.refuse(["run", "run.toml", "-o"], "wirepack run", "--output")
        self.refuse(["run", "run.toml", "-o", "out.h5", "--fast"], "--fast")
        self.refuse(["run", "run.toml", "-o", "out.h5", "other"], "other")
        for threads in ["0", "-1", "many"]:
            self.refuse(["run", "run.toml", "-o", "out.h5", "--threads", threads], "--threads")
        self.refuse(["run", "run.toml", "-o", "out.h5", "--resume", "--force"], "--force")

    def test_outputs_that_cannot_be(self):
        self.write("run.toml", SMALL_RUN)
        self.write("there.h5", "something")
        self.refuse(["run", "run.toml", "-o", "there.h5"], "there.h5 exists; --resume")
        self.assertEqual((self.folder / "there.h5").read_text(), "something")
        self.refuse(["run", "run.toml", "-o", "."], "is a folder")
        self.refuse(["run", "run.toml", "-o", "no/out.h5"], "no/out.h5: cannot be written", code=5)
        self.refuse(["run", "run.toml", "-o", "/proc/out.h5"], "cannot be written", code=5)


class Help(ProgramTest):
    def test_help_and_version(self):
        for arguments in [["--help"], ["run", "--help"], ["--version"]]:
            code, out, err = self.run_program(*arguments)
            self.assertEqual((code, err), (0, ""))
            self.assertIn("wirepack", out)

    def test_the_examples_of_the_help_are_accepted(self):
        _, out, _ = self.run_program("run", "--help")
        examples = [line.split() for line in out.splitlines() if line.startswith("  wirepack run ")]
        self.assertGreaterEqual(len(examples), 3)
        (self.folder / "data/scenarios").mkdir(parents=True)
        self.write("data/scenarios/quickstart.toml", SMALL_RUN)
        for words in examples:
            code, out, err = self.run_program(*words[1:], "--dry-run")
            self.assertEqual(code, 0, err)

    def test_a_dry_run_prints_a_configuration_that_gives_itself(self):
        self.write("run.toml", "[cavity]\nradius = 13.7\n[packing]\nsetup = 'high_torsion'\n")
        code, first, _ = self.run_program("run", "run.toml", "--dry-run")
        self.assertEqual(code, 0)
        self.write("again.toml", first)
        _, second, _ = self.run_program("run", "again.toml", "--dry-run")
        self.assertEqual(first, second)
        self.assertEqual(self.names(), ["again.toml", "run.toml"])


if __name__ == "__main__":
    unittest.main()
