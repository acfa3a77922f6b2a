"""wirepack fit: shapes from points, bad points, and runs that use a shape."""

import json
import math
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import h5py

from support import ProgramTest, differing

DATA = Path(__file__).resolve().parents[2] / "data"

SHAPED_RUN = """
[wire]
reference_shape = "shapes/helix.toml"
reference_shape_beyond = "extend"
[cavity]
radius = 5
[stop]
increments = 40
[output]
checkpoint_every_seconds = 0
"""


class Fit(ProgramTest):
    def fit(self, points, model, *more, code=0):
        returned, out, err = self.run_program(
            "fit", points, "--model", model, "-o", "shape.toml", "--force", *more
        )
        self.assertEqual(returned, code, err)
        return out, err

    def helix_text(self, sign=1):
        lines = ["# a comment", "x,y,z"]
        for i in range(60):
            a = 0.2 * i
            lines.append(f"{2 * math.cos(a)},{2 * math.sin(a)},{sign * 0.5 * a}")
        return "\n".join(lines) + "\n"

    def refuse(self, text, *parts, model="circle", more=()):
        self.write("points.csv", text)
        before = self.names()
        out, err = self.fit("points.csv", model, *more, code=2)
        self.assertEqual(out, "")
        self.assertEqual(len(err.splitlines()), 1, err)
        for part in parts:
            self.assertIn(part, err)
        self.assertEqual(self.names(), before)

    def test_json_has_the_parameters_with_their_errors(self):
        for name, expected in {
            "circle": {"radius": 20, "curvature": 1 / 20},
            "helix": {"radius": 3, "pitch": 4},
        }.items():
            out, _ = self.fit(DATA / "shapes" / (name + ".csv"), name, "--json")
            result = json.loads(out)
            self.assertEqual(result["model"], name)
            self.assertEqual(set(result["parameters"]), {"curvature", "torsion", "radius", "pitch"})
            for key, value in expected.items():
                found = result["parameters"][key]
                self.assertGreater(found["standard_error"], 0)
                self.assertLess(abs(found["value"] - value), 4 * found["standard_error"])
            self.assertIn("residual_rms", result)
            self.assertGreater(result["length"], 0)
        self.assertEqual(result["points"], 300)
        out, _ = self.fit(DATA / "shapes" / "coil.csv", "spline", "--json", "--ordered")
        result = json.loads(out)
        self.assertEqual(set(result["parameters"]), {"curvature", "torsion"})
        self.assertLess(abs(result["length"] - 120), 0.3)

    def test_the_samples_are_what_their_script_makes(self):
        shutil.copy(DATA / "shapes" / "make.py", self.folder)
        subprocess.run([sys.executable, "-B", "make.py"], cwd=self.folder, check=True)
        for name in ("circle.csv", "helix.csv", "coil.csv"):
            made = (self.folder / name).read_text()
            self.assertEqual(made, (DATA / "shapes" / name).read_text())

    def test_the_table_and_the_shape_agree_for_either_hand(self):
        for sign in (1, -1):
            self.write("points.csv", self.helix_text(sign))
            out, _ = self.fit("points.csv", "helix", "--ordered")
            self.assertIn("pitch", out)
            row = (self.folder / "shape.toml").read_text().split("k0 = [\n  [")[1].split("]")[0]
            _, k1, k2, k3 = map(float, row.split(","))
            self.assertAlmostEqual(k1, 0, 12)
            self.assertAlmostEqual(k2, 2 / 4.25, 9)
            self.assertAlmostEqual(k3, sign * 0.5 / 4.25, 9)

    def test_points_that_are_wrong_are_refused_with_their_line(self):
        good = self.helix_text()
        for bad, parts in {
            "1,2,x": ("points.csv:63", "column 3 (z) = x: must be a number"),
            "1,2,nan": ("points.csv:63", "column 3 (z) = nan: must be finite"),
            "1,,2": ("points.csv:63", "column 2 (y)"),
            "1,2": ("points.csv:63", "has 2 columns where the lines before have 3"),
            "1,2,3,4": ("points.csv:63", "has 4 columns where the lines before have 3"),
        }.items():
            with self.subTest(bad):
                self.refuse(good + bad + "\n", *parts)
        self.refuse("1,2,3\n4,5,6\n", "2 points", "at least 4")
        self.refuse("1,2,3\n" * 20, "1 of them different")
        self.refuse("1,2,zero\n", "column 3", "zero")
        self.refuse("x,y,w\n1,2,3\n", "names no column z", "'w'")
        self.refuse("x,y\n1,2\n", "names no column z")
        self.refuse("", "holds no points")
        self.refuse("1,2\n3,4\n", "has 2 columns; must be x, y, z")
        self.refuse("1,2,3,0,0\n", "column 5 (sigma) = 0: must be positive")
        self.refuse(
            "0,0,0,1\n1,0,0,1\n2,1,0,1\n3,1,0,1\n",
            "shorter than the way between the points",
            "line 1 and line 3",
        )
        self.refuse(b"\x89HDF\x00", "is not a text file")
        self.refuse(good, "--intervals is for --model spline", more=("--intervals", "3"))

    def test_a_closed_loop_and_a_straight_line_have_a_clear_answer(self):
        loop = "\n".join(
            f"{5 * math.cos(2 * math.pi * i / 90)} {5 * math.sin(2 * math.pi * i / 90)} 0"
            for i in range(90)
        )
        self.write("loop.txt", loop)
        out, err = self.fit("loop.txt", "circle", "--json")
        self.assertIn("close a circle", err)
        self.assertAlmostEqual(json.loads(out)["length"], 10 * math.pi, 6)
        line = "\n".join(f"{i},{2 * i},{-i}" for i in range(30))
        self.write("line.csv", line)
        for model in ("circle", "helix", "spline"):
            out, err = self.fit("line.csv", model, "--json", "--ordered")
            self.assertIn("do not tell", err)
            self.assertAlmostEqual(json.loads(out)["length"], 29 * math.sqrt(6), 6)
            if model != "spline":
                self.assertIsNone(json.loads(out)["parameters"]["radius"]["value"])

    def test_the_figure_holds_points_shape_and_residuals(self):
        self.fit(DATA / "shapes" / "coil.csv", "spline", "--figures", "figures")
        folder = self.folder / "figures"
        for ending, start in ((".png", b"\x89PNG"), (".pdf", b"%PDF"), (".svg", b"<?xml")):
            data = (folder / ("fit" + ending)).read_bytes()
            self.assertEqual(data[: len(start)], start)
            self.assertGreater(len(data), 4000)
        blocks = (folder / "fit.dat").read_text().split("\n\n\n")
        self.assertEqual(len(blocks[0].splitlines()), 402)

    def test_points_in_no_order_give_the_same_helix(self):
        lines = self.helix_text().splitlines()
        shape = []
        for text in (lines, lines[:2] + sorted(lines[2:])):
            self.write("points.csv", "\n".join(text))
            out, _ = self.fit("points.csv", "helix", "--json")
            shape.append(json.loads(out)["parameters"])
        for key in ("curvature", "torsion", "radius", "pitch"):
            self.assertAlmostEqual(shape[0][key]["value"], shape[1][key]["value"], 9)
        self.assertAlmostEqual(shape[0]["pitch"]["value"], math.pi, 9)

    def test_layouts_of_other_programs_give_the_same_helix(self):
        points = [tuple(map(float, line.split(","))) for line in self.helix_text().splitlines()[2:]]
        rows = [[f"{v:.6f}" for v in p] for p in points]
        markups = {
            "markups": [
                {
                    "type": "Curve",
                    "coordinateSystem": "LPS",
                    "controlPoints": [
                        {"id": str(i), "position": list(p), "positionStatus": "defined"}
                        for i, p in enumerate(points)
                    ],
                }
            ]
        }
        comma = [[v.replace(".", ",") for v in row] for row in rows]
        slicer = "# Markups fiducial file version = 5.0\n# CoordinateSystem = LPS\n"
        slicer += "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
        paraview = '"Point ID","Points:0","Points:1","Points:2","Points_Magnitude"\n'
        layouts = {
            "slicer.fcsv": slicer
            + "".join(f"{i},{','.join(r)},0,0,0,1,1,1,0,P-{i},,\n" for i, r in enumerate(rows)),
            "slicer.mrk.json": json.dumps(markups),
            "vmtk.dat": "X Y Z MaximumInscribedSphereRadius\n"
            + "".join(f"{' '.join(r)} 1.2\n" for r in rows),
            "paraview.csv": paraview
            + "".join(f"{i},{','.join(r)},3\n" for i, r in enumerate(rows)),
            "units.csv": "\ufeffx [mm];y [mm];z [mm]\r\n"
            + "".join(";".join(r) + "\r\n" for r in comma),
            "tabs.txt": "".join("\t".join(r) + "\n" for r in comma),
            "blanks.txt": "".join("  ".join(r) + "\n" for r in comma),
            "quoted.csv": '"x","y","z"\n'
            + "".join(",".join(f'"{v}"' for v in r) + "\n" for r in comma),
            "numpy.txt": "# x y z\n" + "".join(" ".join(r) + "\n" for r in rows),
            "named.csv": "a,b,c,name\n" + "".join(",".join(r) + ",p\n" for r in rows),
        }
        for name, text in layouts.items():
            with self.subTest(name):
                self.write(name, text.encode())
                more = ("--columns", "a,b,c") if name == "named.csv" else ()
                out, err = self.fit(name, "helix", "--json", *more)
                self.assertAlmostEqual(json.loads(out)["parameters"]["pitch"]["value"], math.pi, 5)
        self.write("numbers.csv", "".join(f"7,{','.join(r)},8,9,0\n" for r in rows))
        out, _ = self.fit("numbers.csv", "helix", "--json", "--columns", "2,3,4")
        self.assertAlmostEqual(json.loads(out)["parameters"]["pitch"]["value"], math.pi, 5)

    def test_layouts_that_cannot_be_read_are_refused_with_their_cause(self):
        self.refuse("1,5,2,5,3,5\n2,5,1,5,4,5\n", "decimal commas")
        self.refuse("x,y,z\n1,5,2,5,3,5\n", "decimal commas")
        self.refuse("x [mm],y [mm],z [cm]\n1,2,3\n", "y is in mm, but z in cm")
        self.refuse("1,2,3,4,5,6,7\n", "has 7 columns", "--columns")
        self.refuse("x,y,z\n1,2,3\n", "no column 'r'", more=("--columns", "x,y,r"))
        self.refuse("x,y,z\n1,2,3\n", "'x' is given twice", more=("--columns", "x,x,z"))
        self.refuse("x,y,z\n1,2,3\n".encode("utf-16"), "is UTF-16")

    def test_what_the_points_do_not_tell_is_said_and_is_no_nan(self):
        self.write("line.csv", "".join(f"0,0,{i / 2}\n" for i in range(40)))
        out, err = self.fit("line.csv", "circle")
        self.assertIn("straight line", err)
        shape = (self.folder / "shape.toml").read_text()
        self.assertNotRegex((out + shape).lower(), r"\bnan\b")
        self.assertRegex(out, r"curvature +0 +\+- ")
        self.write("helix.csv", self.helix_text())
        out, err = self.fit("helix.csv", "circle")
        self.assertIn("the model does not fit", err)
        self.assertIn("misfit = ", (self.folder / "shape.toml").read_text())
        self.assertNotIn("does not fit", self.fit("helix.csv", "helix")[1])

    def make_shape(self):
        (self.folder / "shapes").mkdir(exist_ok=True)
        self.write("points.csv", self.helix_text())
        self.fit("points.csv", "helix")
        shutil.move(self.folder / "shape.toml", self.folder / "shapes" / "helix.toml")

    def test_a_run_uses_the_shape_and_keeps_it(self):
        self.make_shape()
        (self.folder / "runs").mkdir()
        self.write("run.toml", SHAPED_RUN)
        self.write("runs/run.toml", SHAPED_RUN.replace("shapes/", "../shapes/"))
        for config, out in (("run.toml", "a.h5"), ("runs/run.toml", "b.h5")):
            code, _, err = self.run_program("run", config, "-o", out)
            self.assertEqual(code, 0, err)
        self.assertEqual(differing(self.folder / "a.h5", self.folder / "b.h5"), [])
        with h5py.File(self.folder / "a.h5") as file:
            config = file.attrs["config"]
            config = config.decode() if isinstance(config, bytes) else config
            self.assertIn("reference_shape = [\n  [0.0, ", config)
            self.assertNotIn("precurvature", config)
        # what the file keeps is a configuration of its own
        self.write("kept.toml", config)
        shutil.rmtree(self.folder / "shapes")
        code, _, err = self.run_program("run", "kept.toml", "-o", "c.h5")
        self.assertEqual(code, 0, err)
        self.assertEqual(differing(self.folder / "a.h5", self.folder / "c.h5"), [])

    def test_a_uniform_shape_is_a_precurved_wire_at_rest_and_in_time(self):
        start = (
            "[packing]\nsetup = 'high_torsion'\n[cavity]\nradius = 5\n"
            "[stop]\nincrements = 5\n[wire]\n"
        )
        self.write("curved.toml", start + "precurvature = 0.08\n")
        self.write(
            "shaped.toml",
            start
            + "reference_shape_beyond = 'repeat'\n"
            + "reference_shape = [[0, 0, 0.08, 0], [1, 0, 0.08, 0]]\n",
        )
        for method in ("quasistatic", "dynamic"):
            last = []
            for config in ("curved.toml", "shaped.toml"):
                arguments = ("run", config, "-o", "out.h5", "--force", "--method", method)
                code, _, err = self.run_program(*arguments)
                self.assertEqual(code, 0, err)
                with h5py.File(self.folder / "out.h5") as file:
                    last.append([file["history/" + name][-1] for name in ("energy_bend", "force")])
            self.assertGreater(last[0][0], 0)
            for one, other in zip(*last):
                # sums of halves of an edge against its whole: round-off, which the minimizer
                # multiplies
                self.assertAlmostEqual(one / other, 1, 3)

    def test_a_run_is_not_continued_with_another_shape(self):
        self.make_shape()
        self.write("run.toml", SHAPED_RUN)
        self.assertEqual(self.run_program("run", "run.toml", "-o", "a.h5")[0], 0)
        shape = self.folder / "shapes" / "helix.toml"
        text = shape.read_text()
        shape.write_text(text.replace("\n  [0.0, 0.0, 0.47", "\n  [0.0, 0.0, 0.48"))
        self.assertNotEqual(text, shape.read_text())
        more = ("--set", "stop.increments=50", "--resume")
        code, _, err = self.run_program("run", "run.toml", "-o", "a.h5", *more)
        self.assertEqual(code, 2)
        self.assertIn("wire.reference_shape: is another one than it was", err)
        shape.write_text(text)
        self.assertEqual(self.run_program("run", "run.toml", "-o", "a.h5", *more)[0], 0)

    def test_shapes_that_cannot_be_used_are_refused(self):
        self.make_shape()
        self.write("no_table.toml", "[shape]\nlength = 3\n")
        self.write("short.toml", "[shape]\nk0 = [[0, 0, 1, 0]]\n")
        self.write("text.toml", "[shape]\nk0 = [[0, 0, 1, 'a'], [1, 0, 1, 0]]\n")
        start = "[wire]\nreference_shape = "
        good = start + '"shapes/helix.toml"\n'
        extend = "reference_shape_beyond = 'extend'\n"
        tight = f"[wire]\n{extend}reference_shape = [[0, 0, 300, 0], [1, 0, 300, 0]]"
        coarse = extend + "edge_length = 2.2\n[cavity]\nradius = 10"
        none = 'run.toml:2:1: wire.reference_shape = "none.toml": none.toml: there is no such file'
        for text, part in {
            start + '"none.toml"': none,
            start + '"no_table.toml"': "has no `k0",
            start + '"short.toml"': "short.toml:2:6: k0 needs two rows",
            start + '"text.toml"': "must be rows [s, k1, k2, k3]",
            start + "5": "must be the name of a shape file, or rows",
            start + "[[0, 0, 1]]": "must be the name of a shape file, or rows",
            good
            + "precurvature = 0.1": "wire.precurvature = 0.1: wire.reference_shape is given, too",
            good: "the run may insert any length",
            good + "[stop]\nlength = 60": "the run may insert 60",
            good + "reference_shape_beyond = 'end'": 'must be "error" or "repeat" or "extend"',
            tight: "0.00333333, the wire's own radius is 1: are both in the same unit",
            good + coarse: "wire.edge_length = 2.2: must be at most",
            "[wire]\nreference_shape_beyond = 'extend'": "which is not given",
        }.items():
            with self.subTest(text):
                self.write("run.toml", text)
                code, _, err = self.run_program("run", "run.toml", "--dry-run")
                self.assertEqual(code, 2, err)
                self.assertEqual(len(err.splitlines()), 1, err)
                self.assertIn(part, err)
        self.write("run.toml", good + "[stop]\nlength = 20\n")
        self.assertEqual(self.run_program("run", "run.toml", "--dry-run")[0], 0)


if __name__ == "__main__":
    unittest.main()
