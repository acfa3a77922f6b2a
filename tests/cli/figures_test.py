"""wirepack figures: the data behind the pictures are right, wrong input is refused."""

import os
import re
import struct
import unittest

import h5py
import numpy

from support import SMALL_RUN, ProgramTest


# Draws nothing, but keeps the scripts of packings.
GNUPLOT = (
    'PATH=/usr/bin:/bin\nname=${1%.gp}\n[[ $name == packing ]] && cat $1 >> "$SCRIPTS"\n'
    "for ending in png pdf svg; do echo $ending > $name.$ending; done\n"
)
FFMPEG = 'PATH=/usr/bin:/bin\necho "$*" > "$SCRIPTS.ffmpeg"\nls ../film > film.mp4\n'


class Figures(ProgramTest):
    def programs(self, **scripts):
        """An environment with these programs alone."""
        folder = self.folder / "bin"
        folder.mkdir(exist_ok=True)
        for name, script in scripts.items():
            (folder / name).write_text("#!/bin/bash\n" + script)
            (folder / name).chmod(0o755)
        return {**os.environ, "PATH": str(folder), "SCRIPTS": str(self.folder / "scripts")}

    def figures(self, *arguments):
        """Only the data and scripts of figures, which takes a tenth of the time."""
        return self.run_program("figures", *arguments, env=self.programs(gnuplot=GNUPLOT))

    def make_result(self, name="result.h5", increments=60, setup="low_torsion"):
        self.write("scenario.toml", SMALL_RUN.replace("60", str(increments)))
        setting = f"packing.setup='{setup}'"
        code, _, err = self.run_program("run", "scenario.toml", "-o", name, "--set", setting)
        self.assertEqual(code, 0, err)

    def test_every_figure_is_drawn_in_three_formats_and_a_film_in_even_sizes(self):
        self.make_result(setup="high_torsion")
        code, out, err = self.run_program(
            "figures", "result.h5", "-o", "figures", "--film", "--frames", "1"
        )
        self.assertEqual(code, 0, err)
        self.assertIn("packing.png", out)
        drawn = ("packing", "force", "energy", "torsion", "bend_distribution")
        for name in drawn:
            for ending, start in ((".png", b"\x89PNG"), (".pdf", b"%PDF"), (".svg", b"<?xml")):
                data = (self.folder / "figures" / (name + ending)).read_bytes()
                self.assertEqual(data[: len(start)], start)
                self.assertGreater(len(data), 4000)
        data = (self.folder / "figures/film/0001.png").read_bytes()
        width, height = struct.unpack(">II", data[16:24])
        self.assertGreater(width, 1000)
        self.assertEqual((width % 2, height % 2), (0, 0))

    def picture(self, name="figures/packing.ppm"):
        """Pixels of the views of a packing."""
        header, _, pixels = (self.folder / name).read_bytes().partition(b"\n255\n")
        width, height = map(int, header.split()[1:])
        return numpy.frombuffer(pixels, numpy.uint8).reshape(height, width, 3)

    def put_a_ring(self, name, radius):
        """A ring of wire about the axis z in the place of a run's last frame, of one energy."""
        with h5py.File(self.folder / name, "r+") as file:
            frame = file["frames"][sorted(file["frames"])[-1]]
            frame.attrs.pop("checksum", None)
            n = 101
            angle = numpy.linspace(0.01, 2 * numpy.pi - 0.01, n)
            values = {
                "position": numpy.stack(
                    [radius * numpy.cos(angle), radius * numpy.sin(angle), 0 * angle], axis=1
                ),
                "quaternion": numpy.tile([1.0, 0, 0, 0], (n - 1, 1)),
                "bend_energy": numpy.full(n, 0.002),
                "twist_energy": numpy.zeros(n),
                "wall_force": numpy.zeros(n),
                "contact_pairs": numpy.zeros((0, 2), int),
                "contact_force": numpy.zeros(0),
            }
            for dataset in list(frame):
                del frame[dataset]
            for key, value in values.items():
                frame[key] = value

    def test_a_ring_is_cut_in_discs_and_seen_from_above_as_an_ellipse(self):
        self.make_result()
        self.put_a_ring("result.h5", 2.5)
        code, _, err = self.figures("result.h5", "-o", "figures")
        self.assertEqual(code, 0, err)
        pixels = self.picture()
        size = pixels.shape[0]
        self.assertEqual(pixels.shape, (size, 2 * size, 3))
        half = 1.05 * 4
        place = (numpy.arange(size) + 0.5) / size * 2 * half - half
        x, z = numpy.meshgrid(place, -place)
        seen = (pixels != 255).any(axis=2)
        pixel = (2 * half / size) ** 2
        cut = pixels[:, size:]
        colours = set()
        for middle in (-2.5, 2.5):
            distance = numpy.hypot(x - middle, z)
            colours |= set(map(tuple, cut[distance < 0.9]))  # the face is flat
        self.assertEqual(len(colours), 1)
        # between its faces the ring is seen from inside, as high as it is thick
        self.assertAlmostEqual(
            seen[:, size:].sum() * pixel, 2 * 2.5 * 2 + numpy.pi, delta=0.01 * (10 + numpy.pi)
        )
        script = (self.folder / "figures/packing.gp").read_text()
        block = script.split("$cavity << EOD\n")[1].split("EOD")[0]
        views = [numpy.loadtxt(part.splitlines()) for part in block.strip().split("\n\n")]
        for view, outline in enumerate(views):  # a circle in each view, of half widths of it
            radius = numpy.hypot(outline[:, 0] - 2 * view, outline[:, 1])
            numpy.testing.assert_allclose(radius, 4 / half, atol=2e-4)
        # from outside, 25 degrees above the plane of the ring: the silhouette of a torus
        angle = numpy.linspace(0, 2 * numpy.pi, 2000)
        height = numpy.sin(numpy.radians(25))
        ring = numpy.stack([2.5 * numpy.cos(angle), 2.5 * height * numpy.sin(angle)])
        outside = seen[:, :size]
        for k in range(0, size, 16):
            for m in range(0, size, 16):
                spot = numpy.array([[place[m]], [-place[k]]])
                distance = numpy.linalg.norm(ring - spot, axis=0).min()
                if abs(distance - 1) > 0.03:
                    self.assertEqual(outside[k, m], distance < 1, (spot, distance))

    def test_the_first_runs_of_both_setups_stand_side_by_side(self):
        self.write("scenario.toml", SMALL_RUN)
        for name, setup in (("a", "high"), ("b", "high"), ("c", "low"), ("d", "low")):
            code, _, err = self.run_program(
                "run",
                "scenario.toml",
                "-o",
                f"{name}.h5",
                "--set",
                f"packing.setup='{setup}_torsion'",
                "--set",
                f"stop.increments={30 + ord(name) % 5}",
            )
            self.assertEqual(code, 0, err)
        code, _, err = self.figures("a.h5", "b.h5", "c.h5", "d.h5", "-o", "figures")
        self.assertEqual(code, 0, err)
        pixels = self.picture()
        self.assertEqual(pixels.shape[0], pixels.shape[1])  # two views, one above the other, each
        for block, name in zip(self.blocks("packing"), ("a", "c"), strict=True):
            with h5py.File(self.folder / f"{name}.h5") as result:
                last = result["frames"][sorted(result["frames"])[-1]]
                numpy.testing.assert_allclose(block[:, :3], last["position"], atol=1e-4)
        script = (self.folder / "figures/packing.gp").read_text()
        self.assertLess(script.find("'high torsion, R = 4 a"), script.find("'low torsion, R = 4 a"))
        self.figures("c.h5", "-o", "alone")
        views = numpy.hsplit(self.picture("alone/packing.ppm"), 2)
        size = len(views[0])
        numpy.testing.assert_array_equal(pixels[size:, size:], views[1])  # the same, alone

    def test_the_frame_is_the_one_that_was_asked_for(self):
        self.make_result()
        for number, option in enumerate((("--frame", "1"), ("--density", "0.01"))):
            code, _, err = self.figures("result.h5", "-o", f"early{number}", *option)
            self.assertEqual(code, 0, err)
        self.assertEqual(
            (self.folder / "early0" / "packing.dat").read_text(),
            (self.folder / "early1" / "packing.dat").read_text(),
        )
        for option in (("--frame", "100000"), ("--density", "0.9")):
            code, _, err = self.figures("result.h5", "-o", "no", *option)
            self.assertEqual(code, 2, err)
            self.assertIn("frames", err)
            self.assertFalse((self.folder / "no").exists())

    def test_names_with_quotes_and_underscores_are_drawn_to_the_letter(self):
        name = 'it\'s a_"b".h5'
        self.make_result(name)
        code, _, err = self.run_program("figures", name, "-o", "fig'ures")
        self.assertEqual(code, 0, err)
        self.assertIn("a_", (self.folder / "fig'ures" / "force.svg").read_text())

    def make_packing(self, name, seed, *more):
        """A run by half edges; returns its columns."""
        if not (self.folder / "packing.toml").exists():
            self.write(
                "packing.toml",
                "[cavity]\nradius = 4\n[stop]\ndensity = 0.6\n"
                "[wire]\nedge_length = 1\n[insertion]\nincrement = 0.5\n",
            )
        code, _, err = self.run_program(
            "run", "packing.toml", "-o", name, "--set", f"packing.seed={seed}", *more
        )
        self.assertEqual(code, 0, err)
        with h5py.File(self.folder / name) as result:
            return {key: column[:] for key, column in result["history"].items()}

    def blocks(self, figure):
        """The blocks of numbers of a figure's data."""
        text = (self.folder / "figures" / (figure + ".dat")).read_text()
        return [
            numpy.loadtxt(block.splitlines(), ndmin=2)
            for block in text.split("\n\n\n")
            if block.strip()
        ]

    def test_seeds_of_one_scenario_are_drawn_as_their_mean_with_its_standard_error(self):
        runs = [self.make_packing(f"{seed}.h5", seed) for seed in (1, 2, 3)]
        code, _, err = self.figures("1.h5", "2.h5", "3.h5", "-o", "figures")
        self.assertEqual(code, 0, err)
        self.assertEqual(len(self.blocks("force")), 2)  # the mean, and the model
        mean = self.blocks("force")[0]
        density = mean[:, 0]
        for column, key, unit in ((1, "scaled_force", 1), (3, "energy_bend", 5 * numpy.pi / 4 / 4)):
            values = [numpy.interp(density, r["packing_density"], r[key] / unit) for r in runs]
            inside = slice(30, -2)
            numpy.testing.assert_allclose(
                mean[inside, column], numpy.mean(values, axis=0)[inside], rtol=1e-3, atol=1e-3
            )
            error = numpy.std(values, axis=0, ddof=1) / numpy.sqrt(3)
            numpy.testing.assert_allclose(
                mean[inside, column + 1], error[inside], rtol=1e-3, atol=1e-3
            )

    @staticmethod
    def mean_force(run, fed=1):
        """Of each row over `fed` (an edge is 1 long); zero until so much after the first coil."""
        length, force = run["inserted_length"], run["scaled_force"]
        work = numpy.concatenate(
            ([0], numpy.cumsum(numpy.diff(length) * (force[1:] + force[:-1]) / 2))
        )
        mean = (work - numpy.interp(length - fed, length, work)) / fed
        after = length[length > 2 * (1 + numpy.pi) * 4]
        mean[length < after[0] + fed - 1e-9] = 0
        return mean

    def test_phi_max_is_the_first_density_after_the_first_coil_whose_mean_force_is_high(self):
        run = self.make_packing("1.h5", 1)
        length, force = run["inserted_length"], run["scaled_force"]
        mean = self.mean_force(run)
        highest = mean.argmax()
        code, _, err = self.figures(
            "1.h5", "-o", "figures", "--threshold", str(0.9999 * mean[highest])
        )
        self.assertEqual(code, 0, err)
        ((ratio, density, error, count, radius, mass, _),) = self.blocks("phi_max")[0]
        self.assertEqual((ratio, error, count, radius), (0.25, 0, 1, 4))
        self.assertAlmostEqual(mass, 64 * density, delta=1e-9)  # of 4/3 pi R^3 phi over 4/3 pi a^3
        self.assertAlmostEqual(density, run["packing_density"][highest], delta=1e-9)
        self.assertIn("Stoop", (self.folder / "figures" / "phi_max.gp").read_text())
        code, out, err = self.figures("1.h5", "-o", "none", "--threshold", str(100 * mean[highest]))
        self.assertEqual(code, 0, err)
        self.assertIn("no phi_max: no run reaches", out)
        self.assertFalse((self.folder / "none" / "phi_max.png").exists())

    def test_phi_max_is_not_read_where_the_force_is_above_from_the_first_coil_on(self):
        run = self.make_packing("1.h5", 1, "--set", "stop.density=0.5")
        mean = self.mean_force(run)
        first = mean[mean.nonzero()[0][0]]
        code, out, err = self.figures("1.h5", "-o", "figures", "--threshold", str(0.5 * first))
        self.assertEqual(code, 0, err)
        self.assertIn("no phi_max: no run reaches", out)

    def test_a_run_below_the_threshold_splits_no_series(self):
        for radius in (4, 5):
            self.make_packing(f"{radius}.h5", 1, "--set", f"cavity.radius={radius}")
        self.make_packing("soft.h5", 1, "--set", "contact.stiffness=2", "--set", "stop.length=20")
        code, _, err = self.figures(
            "4.h5", "5.h5", "soft.h5", "-o", "figures", "--threshold", "1.5"
        )
        self.assertEqual(code, 0, err)
        self.assertEqual([len(block) for block in self.blocks("phi_max")], [2])

    def test_phi_max_can_be_read_from_a_mean_over_more_wire(self):
        run = self.make_packing("1.h5", 1)
        mean = self.mean_force(run, fed=2)  # half the radius
        highest = mean.argmax()
        threshold = ("--threshold", str(0.9999 * mean[highest]))
        code, _, err = self.figures("1.h5", "-o", "figures", *threshold, "--mean-over", "0.5")
        self.assertEqual(code, 0, err)
        density = self.blocks("phi_max")[0][0, 1]
        self.assertAlmostEqual(density, run["packing_density"][highest], delta=1e-9)
        self.assertGreater(self.mean_force(run).max(), mean[highest])
        script = (self.folder / "figures" / "phi_max.gp").read_text()
        self.assertIn("mean over 0.5 R", script)
        code, _, err = self.figures("1.h5", "-o", "none", "--mean-over", "-1")
        self.assertEqual(code, 2)
        self.assertIn("--mean-over: must be between 0 and 1000, not -1", err)
        self.assertFalse((self.folder / "none").exists())

    def test_phi_max_of_seeds_is_one_point_and_other_friction_another_series(self):
        curved = ("--set", "imperfection.natural_curvature=0.3")
        friction = ("--set", "friction.model='coulomb'")
        for key, number in (("static", 0.02), ("dynamic", 0.02)):
            friction += ("--set", f"friction.{key}={number}")
        runs = [self.make_packing(f"{seed}.h5", seed, *curved) for seed in (1, 2)]
        runs.append(self.make_packing("rough.h5", 1, *curved, *friction))
        means = [self.mean_force(run) for run in runs]
        threshold = 0.9 * min(mean.max() for mean in means)
        code, _, err = self.figures(
            "1.h5", "2.h5", "rough.h5", "-o", "figures", "--threshold", str(threshold)
        )
        self.assertEqual(code, 0, err)
        first = [
            run["packing_density"][(mean >= threshold).argmax()] for run, mean in zip(runs, means)
        ]
        smooth, rough = self.blocks("phi_max")
        self.assertNotEqual(first[0], first[1])
        numpy.testing.assert_allclose(
            smooth[:, :4],
            [[0.25, (first[0] + first[1]) / 2, abs(first[0] - first[1]) / 2, 2]],
            rtol=1e-5,
        )
        numpy.testing.assert_allclose(rough[:, :4], [[0.25, first[2], 0, 1]], rtol=1e-5)
        key = (self.folder / "figures" / "phi_max.gp").read_text()
        self.assertIn("low torsion, as 1", key)
        self.assertIn("low torsion, as rough", key)

    def test_bend_energies_over_their_mean_are_spread_with_an_area_of_one(self):
        self.make_packing("1.h5", 1)
        code, _, err = self.figures("1.h5", "-o", "figures")
        self.assertEqual(code, 0, err)
        bars = self.blocks("bend_distribution")[0]
        width = numpy.diff(numpy.log(bars[:, 0]))
        numpy.testing.assert_allclose(width, 0.25, rtol=1e-3)
        self.assertAlmostEqual((bars[:, 1] * 0.25).sum(), 1, delta=0.05)
        with h5py.File(self.folder / "1.h5") as result:
            frames = result["frames"]
            energy = frames[sorted(frames)[-1]]["bend_energy"][:]
        energy = energy[energy > 0]
        logs = numpy.log(energy / energy.mean())
        expected = numpy.average(numpy.log(bars[:, 0]), weights=bars[:, 1])
        self.assertAlmostEqual(expected, logs.clip(-9, 4).mean(), delta=0.13)

    def test_insets_are_drawn_where_the_runs_have_what_they_show(self):
        self.make_packing("1.h5", 1, "--set", "stop.density=0.5")
        self.make_packing("2.h5", 1, "--set", "stop.density=0.5", "--set", "cavity.radius=5")
        low = ("--threshold", "1.5")
        code, out, err = self.figures("1.h5", "-o", "one", *low)
        self.assertEqual(code, 0, err)
        self.assertIn("no inset in phi_max: it takes runs in cavities of two radii\n", out)
        self.assertNotIn("using 5:6:7", (self.folder / "one/phi_max.gp").read_text())
        code, out, err = self.figures("1.h5", "2.h5", "-o", "figures", *low)
        self.assertEqual(code, 0, err)
        self.assertNotIn("no inset in phi_max", out)
        self.assertIn("using 5:6:7", (self.folder / "figures/phi_max.gp").read_text())
        numpy.testing.assert_allclose(self.blocks("phi_max")[0][:, 4], [4, 5])
        # a straight wire that lies straight has no torsion
        self.write("short.toml", "[cavity]\nradius = 4\n[stop]\nincrements = 3\n")
        self.run_program("run", "short.toml", "-o", "short.h5")
        code, out, err = self.figures("short.h5", "-o", "short")
        self.assertEqual(code, 0, err)
        self.assertIn("no torsion, and no inset in energy: the runs have no torsional", out)
        self.assertFalse((self.folder / "short/torsion.png").exists())

    def test_the_axis_of_phi_max_begins_below_every_point(self):
        self.make_packing("10.h5", 1, "--set", "stop.density=0.08", "--set", "cavity.radius=10")
        code, _, err = self.figures("10.h5", "-o", "figures", "--threshold", "0.7")
        self.assertEqual(code, 0, err)
        script = (self.folder / "figures/phi_max.gp").read_text()
        axis = float(re.search(r"set yrange \[([^:]*):1\]", script)[1])
        density = self.blocks("phi_max")[0][0, 1]
        self.assertLess(density, 0.1)
        self.assertLess(axis, density)

    def test_a_figure_of_an_earlier_call_does_not_stay_behind(self):
        self.make_packing("1.h5", 1, "--set", "stop.density=0.5")
        for threshold, there in (("1.5", True), ("1000", False)):
            code, _, err = self.figures(
                "1.h5", "-o", "figures", "--force", "--threshold", threshold
            )
            self.assertEqual(code, 0, err)
            self.assertEqual(any((self.folder / "figures").glob("phi_max.*")), there)

    def film(self, environment, *options, expected=0):
        code, out, err = self.run_program(
            "figures", "result.h5", "-o", "figures", "--film", *options, env=environment
        )
        self.assertEqual(code, expected, err)
        return out, err

    def pictures(self):
        return sorted(path.name for path in (self.folder / "figures/film").iterdir())

    def test_a_film_has_all_frames_in_one_range_of_colours_with_density_and_force(self):
        self.make_result(increments=24)
        self.film(self.programs(gnuplot=GNUPLOT, ffmpeg=FFMPEG))
        with h5py.File(self.folder / "result.h5") as file:
            frames = [dict(file["frames"][name].attrs) for name in sorted(file["frames"])]
        names = [f"{k + 1:04}.png" for k in range(len(frames))]
        self.assertEqual(self.pictures(), names)
        self.assertEqual((self.folder / "figures/film.mp4").read_text().split(), names)
        scripts = (self.folder / "scripts").read_text().split("set terminal")[4:]  # of the film
        self.assertEqual(len(scripts), len(frames))
        self.assertEqual(len({re.search("set cbrange .*", script)[0] for script in scripts}), 1)
        for script, frame in zip(scripts, frames):
            force = frame["force"] * 16 / (5 * numpy.pi / 4)
            self.assertIn(f"φ = {frame['packing_density']:.3f}, F R²/YI = {force:.2f}'", script)
        words = (self.folder / "scripts.ffmpeg").read_text()
        self.assertIn("-i ../film/%04d.png", words)
        self.assertIn("-c:v libx264 -pix_fmt yuv420p", words)

    def test_a_film_takes_the_place_of_an_earlier_one_and_needs_no_ffmpeg(self):
        self.make_result(increments=24)
        self.film(self.programs(gnuplot=GNUPLOT, ffmpeg=FFMPEG), "--frames", "3")
        for path in (self.folder / "figures").iterdir():  # the third picture is in the way, too
            if path.is_file():
                path.unlink()
        for name in ("0001.png", "0002.png"):
            (self.folder / "figures/film" / name).unlink()
        _, err = self.film(self.programs(), "--frames", "2", expected=2)
        self.assertIn("--force", err)
        self.assertEqual(self.pictures(), ["0003.png"])
        (self.folder / "bin/ffmpeg").unlink()
        out, _ = self.film(self.programs(), "--force", "--frames", "2")
        self.assertIn("no film.mp4: there is no ffmpeg; elsewhere, in figures: ffmpeg ", out)
        self.assertEqual(self.pictures(), ["0001.png", "0002.png"])
        self.assertFalse((self.folder / "figures/film.mp4").exists())

    def test_an_ffmpeg_that_fails_is_trouble_with_files_and_leaves_the_pictures(self):
        self.make_result(increments=24)
        for script, code in (("exit 3\n", 3), ("kill -9 $$\n", 137)):
            environment = self.programs(gnuplot=GNUPLOT, ffmpeg=script)
            _, err = self.film(environment, "--frames", "1", "--force", expected=5)
            self.assertIn(f"film.mp4: not made: ffmpeg ended with code {code}; its pictures", err)
            self.assertEqual(self.pictures(), ["0001.png"])
            self.assertFalse((self.folder / "figures/film.mp4").exists())

    def test_what_is_not_a_result_is_a_file_error_and_leaves_nothing(self):
        self.write("text.h5", "no result")
        for name in ("missing.h5", "text.h5"):
            code, _, err = self.figures(name, "-o", "figures")
            self.assertEqual(code, 5)
            self.assertEqual(len(err.strip().splitlines()), 1, err)
            self.assertFalse((self.folder / "figures").exists())


if __name__ == "__main__":
    unittest.main()
