"""wirepack.py packs wires: as the program does, with its messages, and with energies on arrays."""

import functools
import json
import os
import shutil
import signal
import sys
import threading
import tomllib
import unittest
import warnings
from concurrent.futures import ThreadPoolExecutor

import numpy

from support import SMALL_RUN, ProgramTest, differing

sys.path.insert(0, os.environ["WIREPACK_READER"])
import wirepack  # noqa: E402

RUN = SMALL_RUN.replace("checkpoint_every_seconds = 0", "frame_every_density = 0.01")
SETUPS = ("low_torsion", "high_torsion")


@functools.cache
def dense(setup):
    """A packing in which strands touch."""
    packer = wirepack.Packer({"cavity": {"radius": 4}, "packing": {"setup": setup}})
    packer.advance(density=0.3)
    return packer


class PackerTest(ProgramTest):
    def setUp(self):
        super().setUp()
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        self.write("run.toml", RUN)

    def run_it(self, output, *arguments):
        code, _, err = self.run_program("run", "run.toml", "-o", output, *arguments)
        self.assertEqual(code, 0, err)
        return self.folder / output


class Packing(PackerTest):
    def test_a_run_has_the_bits_of_the_program_in_one_go_and_in_parts(self):
        program = self.run_it("program.h5")
        whole = wirepack.Packer("run.toml")
        self.assertEqual(len(whole.history.force), 0)
        self.assertEqual(whole.advance(), "increments")
        parts = wirepack.Packer("run.toml")
        self.assertIsNone(parts.advance(increments=7))
        self.assertEqual(parts.advance(density=0.1), "density")
        self.assertAlmostEqual(parts.history.packing_density[-1], 0.1)
        self.assertIsNone(parts.advance(increments=1, force=1e9))
        self.assertEqual(parts.advance(), "increments")
        for packer in (whole, parts):
            self.assertEqual(differing(program, packer.path), [])
            for name, column in wirepack.Run(program).history.items():
                if name != "wall_seconds":
                    self.assertEqual(packer.history[name].tobytes(), column.tobytes(), name)

    def test_a_limit_is_that_of_the_program(self):
        for limit in ("density=0.123", "length=9.7", "scaled_force=0.4", "force=0.01"):
            name, value = limit.split("=")
            self.write("run.toml", RUN.replace("increments = 60", limit))
            packer = wirepack.Packer({"cavity": {"radius": 4}})
            self.assertEqual(packer.advance(**{name: float(value)}), name)
            program = wirepack.Run(self.run_it(f"{name}.h5"))
            self.assertEqual(program.history.force.tobytes(), packer.history.force.tobytes())

    def test_a_configuration_is_a_file_a_text_or_a_dict(self):
        changed = {"cavity.radius": numpy.float64(5), "packing": {"setup": "high_torsion"}}
        runs = [
            wirepack.Packer("run.toml", set=changed),
            wirepack.Packer(RUN, set=changed),
            wirepack.Packer(tomllib.loads(RUN), set=changed),
        ]
        runs.append(wirepack.Packer(runs[0].config))
        for run in runs:
            self.assertEqual((run.cavity_radius, run.semi_axes.tolist()), (5, [5, 5, 5]))
            self.assertEqual(run.config, runs[0].config)
        self.assertEqual(runs[0].config["packing"]["setup"], "high_torsion")
        rows = [[0, 0, 0.1, 0], [1, 0, 0.1, 0]]
        shape = {"wire.reference_shape": rows, "wire.reference_shape_beyond": "extend"}
        shaped = wirepack.Packer(RUN, shape)
        self.assertEqual(shaped.config["wire"]["reference_shape"], rows)

    def test_the_program_goes_on_with_a_result_and_is_gone_on_with(self):
        whole = self.run_it("whole.h5", "--set", "stop.increments=30")
        packer = wirepack.Packer("run.toml", {"stop.increments": 30}, output="kept.h5")
        packer.advance(increments=11)
        packer.save("copy.h5")
        self.assertEqual(len(wirepack.Run("copy.h5").history.force), 11)
        self.run_it("copy.h5", "--set", "stop.increments=30", "--resume")
        again = wirepack.Packer("run.toml", {"stop.increments": 30}, output="kept.h5", resume=True)
        self.assertEqual(len(again.history.force), 11)
        os.mkdir("elsewhere")
        os.chdir("elsewhere")
        again.advance()
        os.chdir("..")
        for name in ("copy.h5", "kept.h5"):
            self.assertEqual(differing(whole, self.folder / name), [])
        self.assertEqual(again.advance(), "increments")  # is over
        anew = wirepack.Packer("run.toml", output="kept.h5", replace=True)
        self.assertEqual(len(anew.history.force), 0)
        os.remove("kept.h5")
        with self.assertRaisesRegex(FileNotFoundError, "kept.h5"):
            anew.advance(increments=1)
        self.assertNotIn("kept.h5", self.names())

    def test_the_frame_now_is_what_a_limit_saves(self):
        self.assertEqual(len(wirepack.Packer("run.toml").frame()), 3)
        for packer in map(dense, SETUPS):
            now, saved = packer.frame(), packer.frames[-1]
            self.assertGreater(len(now.contact_pairs), 2)
            self.assertEqual(vars(now).keys(), vars(saved).keys())
            for name, value in vars(saved).items():
                self.assertEqual(numpy.asarray(getattr(now, name)).tobytes(),
                                 numpy.asarray(value).tobytes(), name)
                self.assertEqual(getattr(getattr(now, name), "unit", None),
                                 getattr(value, "unit", None))

    def test_ctrl_c_stops_between_increments_and_loses_none(self):
        packer = wirepack.Packer("run.toml", {"stop.increments": 100000})
        # Comes while the wire is packed, and only if that lets other threads go on.
        timer = threading.Timer(0.4, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            packer.advance()
        timer.join()
        done = len(packer.history.force)
        self.assertGreater(done, 0)
        packer.advance(increments=2)
        self.run_it("whole.h5", "--set", f"stop.increments={done + 2}")
        whole = wirepack.Run("whole.h5").history.force
        self.assertEqual(whole.tobytes(), packer.history.force.tobytes())

    def test_packers_in_threads_find_what_they_find_alone(self):
        def force(seed):
            packer = wirepack.Packer("run.toml", {"packing.seed": seed})
            packer.advance(increments=20)
            return packer.history.force.tobytes()

        alone = [force(1), force(2)]
        self.assertNotEqual(*alone)
        with ThreadPoolExecutor(4) as pool:
            self.assertEqual(list(pool.map(force, [1, 2] * 4)), alone * 4)

    def test_packers_in_forks_find_what_they_find_alone(self):
        def work(seed):
            wire = wirepack.writhe(numpy.random.default_rng(seed).normal(size=(2000, 3)))
            packer = wirepack.Packer("run.toml", {"packing.seed": seed})
            packer.advance(increments=3)
            return wire, packer.energy().total

        alone = [work(1), work(2)]
        children = []
        for seed in (1, 2):
            child = os.fork()
            if child == 0:
                os._exit(0 if work(seed) == alone[seed - 1] else 1)
            children.append(child)
        self.assertEqual([os.waitpid(child, 0)[1] for child in children], [0, 0])

    def test_no_equilibrium_is_an_error_and_keeps_what_was_found(self):
        settings = {"minimizer.max_evaluations": 3}
        packer = wirepack.Packer("run.toml", settings, output="lost.h5")
        with self.assertRaisesRegex(wirepack.NoEquilibrium, "no_equilibrium.*minimizer"):
            packer.advance()
        self.assertTrue(issubclass(wirepack.NoEquilibrium, RuntimeError))
        self.assertEqual(packer.frame().increment, len(packer.history.force))
        self.assertEqual(packer.stop_reason, "no_equilibrium")
        wirepack.Packer("run.toml", output="lost.h5", resume=True).advance()
        self.assertEqual(wirepack.Run("lost.h5").stop_reason, "increments")


class Energies(PackerTest):
    def test_of_an_equilibrium_are_those_of_its_row_with_no_force_on_a_free_node(self):
        for packer in map(dense, SETUPS):
            row = {name: column[-1] for name, column in packer.history.items()}
            frame, energy = packer.frame(), packer.energy()
            for term, value in energy.terms.items():
                scale = row["energy_total"]  # 1e-12: sums in units of the wire, or of the scenario
                self.assertAlmostEqual(value, row["energy_" + term], delta=1e-12 * scale)
            self.assertGreater(min(energy.terms["wall"], energy.terms["contact"]), 0)
            self.assertAlmostEqual(energy.total, row["energy_total"], delta=1e-12 * scale)
            self.assertAlmostEqual(energy.force, row["force"], delta=1e-9 * row["force"])
            unit = packer.bend_stiffness / packer.cavity_radius**2
            tolerance = packer.config["minimizer"]["tolerance"] * unit
            self.assertLessEqual(abs(energy.gradient[:-1]).max(), 1.001 * tolerance)
            self.assertGreater(abs(energy.gradient[-1]).max(), 100 * tolerance)  # the nozzle's
            self.assertEqual((energy.gradient.unit, energy.moment.unit), ("force", "force length"))
            same = packer.energy(frame)  # without the nozzle's frame, known in both setups
            self.assertAlmostEqual(same.total, energy.total, delta=1e-12 * scale)
            numpy.testing.assert_allclose(same.gradient, energy.gradient, atol=1e-3 * tolerance)

    def test_relaxing_lets_go_of_friction_and_leaves_alone_what_has_none(self):
        for setup in SETUPS:
            at_rest = dense(setup)
            frame, same = at_rest.frame(), at_rest.relax(at_rest.frame())
            numpy.testing.assert_allclose(same.position, frame.position, atol=0.01)
            rubbing = wirepack.Packer(at_rest.config, {"friction.model": "coulomb"})
            rubbing.advance(density=0.3)
            frame, rows = rubbing.frame(), len(rubbing.history.force)
            relaxed = rubbing.relax(frame)
            self.assertEqual(relaxed.inserted_length, frame.inserted_length)
            before, after = rubbing.energy(frame), rubbing.energy(relaxed)
            self.assertLess(after.total, 0.98 * before.total)
            unit = rubbing.bend_stiffness / rubbing.cavity_radius**2
            tolerance = rubbing.config["minimizer"]["tolerance"] * unit
            self.assertLessEqual(abs(after.gradient[:-1]).max(), 1.001 * tolerance)
            self.assertGreater(abs(before.gradient[:-1]).max(), 10 * tolerance)
            self.assertAlmostEqual(relaxed.force, after.force, delta=1e-6 * after.force)
            given = rubbing.relax(frame.position, frame.quaternion, frame.inserted_length)
            self.assertEqual(given.position.tobytes(), relaxed.position.tobytes())
            self.assertEqual(len(rubbing.history.force), rows)

    def test_the_spool_of_a_density_has_the_energy_of_its_hoops(self):
        packer = wirepack.Packer({"cavity": {"radius": 20}})
        # hoops of radius r: sqrt(20^2 - r^2) high on both sides of the plane, YI pi / r each
        per_area = 2 / 3**0.5 / 2.5**2
        r = numpy.linspace(12, 20, 100001)
        height = 2 * numpy.sqrt(20**2 - r**2)
        energy = numpy.trapz(height * packer.bend_stiffness * numpy.pi / r, r) * per_area
        length = numpy.trapz(height * 2 * numpy.pi * r, r) * per_area
        density = 0.75 * length / 20**3
        self.assertAlmostEqual(packer.spool_energy(density, 2.5) / energy, 1, 6)
        with self.assertRaisesRegex(ValueError, "density = 0.5.*: an inverse spool needs"):
            packer.spool_energy(0.5)

    def test_what_comes_to_no_rest_is_an_error(self):
        packer = wirepack.Packer("run.toml", {"minimizer.max_evaluations": 1})
        position = numpy.cumsum(numpy.tile([0, 0.1, 0.5], (6, 1)), axis=0) - [0, 0.6, 0]
        with self.assertRaisesRegex(wirepack.NoEquilibrium, "no equilibrium: forces are .* times"):
            packer.relax(position)
        with self.assertRaisesRegex(ValueError, "position: ends 0.6 from the nozzle"):
            packer.relax(position + [0, 0.6, 0])
        with self.assertRaisesRegex(ValueError, "inserted_length: leaves .* to the last edge"):
            packer.relax(position, inserted_length=20)
        for spacing in (0, 1.9, float("nan")):
            with self.assertRaisesRegex(ValueError, "spacing = .*: must be finite and at least 2"):
                packer.spool_energy(0.1, spacing)

    def test_gradients_are_those_of_differences(self):
        for packer in map(dense, SETUPS):  # off the equilibrium, where every term has a share
            frame, step = packer.frame(), 1e-6
            noise = numpy.random.default_rng(1).uniform(-0.02, 0.02, frame.position.shape)
            position, length = frame.position + noise, frame.inserted_length + 0.1
            quaternion = self.turned(frame.quaternion, 7, 0.1)

            def at(position=position, quaternion=quaternion, length=length):
                return packer.energy(position, quaternion, length)

            here = at()
            self.assertGreater(min(here.terms.values()), 1e-4)
            scale = abs(here.gradient).max()
            for seed in range(5):  # frames are carried along the way that nodes go
                way = numpy.random.default_rng(seed).normal(size=position.shape)
                slope = (at(position + step * way).total - at(position - step * way).total) / (
                    2 * step)
                self.assertAlmostEqual(
                    slope, numpy.sum(way * here.gradient), delta=1e-6 * scale * len(position))
            longer, shorter = at(length=length + step), at(length=length - step)
            slope = (longer.total - shorter.total) / (2 * step)
            self.assertAlmostEqual(slope, here.force, delta=1e-6 * abs(here.force))

            for edge in (0, 5, len(quaternion) - 1):
                slopes = [at(quaternion=self.turned(quaternion, edge, turn)).total
                          for turn in (1e-5, -1e-5)]
                slope = (slopes[0] - slopes[1]) / 2e-5
                self.assertAlmostEqual(slope, here.moment[edge],
                                       delta=1e-5 * max(abs(here.moment).max(), 1e-3))

    def turned(self, quaternion, edge, angle):
        """The frame of an edge turned about its own third axis."""
        w, x, y, z = quaternion[edge]
        c, s = numpy.cos(angle / 2), numpy.sin(angle / 2)
        result = numpy.array(quaternion)
        result[edge] = [w * c - z * s, x * c + y * s, y * c - x * s, z * c + w * s]
        return result

    def test_a_straight_stretched_wire_has_the_energy_of_a_spring(self):
        packer = wirepack.Packer({"cavity": {"radius": 30}, "wire": {"edge_length": 1}})
        position = numpy.zeros((11, 3))
        position[:, 2] = numpy.linspace(0, 10.2, 11) + 10
        energy = packer.energy(position)
        stiffness = packer.youngs_modulus * numpy.pi
        self.assertAlmostEqual(energy.total, stiffness * 0.02**2 / 2 * 10)
        self.assertAlmostEqual(energy.terms["stretch"], energy.total)
        self.assertAlmostEqual(energy.gradient[-1, 2], stiffness * 0.02)
        self.assertAlmostEqual(energy.gradient[0, 2], -stiffness * 0.02)


class Observables(PackerTest):
    def test_are_those_that_analyze_prints(self):
        dense("low_torsion").save("run.h5")
        code, out, err = self.run_program("analyze", "run.h5", "--json")
        self.assertEqual(code, 0, err)
        (shown,) = json.loads(out)["frames"]
        frame = wirepack.Run("run.h5").frames[-1]
        r = frame.position
        curvature, loops = wirepack.local_curvatures(r), wirepack.loop_lengths(r)
        found = {
            **wirepack.coils(r),
            "tangent_order": wirepack.tangent_order(r),
            "twist": wirepack.twist(r, frame.quaternion),
            "knot_determinant": wirepack.knot_type(r)[1],
            "curvature": curvature.mean() * 4,
            "loop_length": loops.mean() / (8 * numpy.pi),
        }
        spacing = wirepack.strand_spacing(r)
        found |= {name: spacing[name] for name in ("spacing", "spacing_across")}
        self.assertGreater(spacing["pairs"], 0)
        self.assertEqual((spacing["ordered"], shown.pop("hexagonal_order")), (0, None))
        for name in found.keys() & shown.keys():
            self.assertAlmostEqual(found[name], shown[name], delta=1e-9, msg=name)
        self.assertEqual(wirepack.writhe(r, threads=2), found["writhe"])
        self.assertEqual(wirepack.average_crossings(r), found["average_crossings"])
        shells = len(shown["radial_density"])
        tables = {"radial_density": wirepack.radial_density(r, 1, 4, shells)[2],
                  "order_by_shell": wirepack.order_by_shell(r, 4, 2)[3]}
        for name, values in tables.items():
            key = "density" if name == "radial_density" else "order"
            numpy.testing.assert_allclose(values, [shell[key] for shell in shown[name]], atol=1e-12)

    def test_a_trefoil_is_known_open_and_closed_and_its_axes_are_unit_vectors(self):
        t = numpy.linspace(0, 2 * numpy.pi, 100, endpoint=False)
        trefoil = numpy.stack([numpy.sin(t) + 2 * numpy.sin(2 * t),
                               numpy.cos(t) - 2 * numpy.cos(2 * t), -numpy.sin(3 * t)], axis=1)
        self.assertEqual(wirepack.knot_type(trefoil, closed=True)[:2], ("3_1", 3))
        self.assertEqual(wirepack.knot_type(trefoil[:3])[0], "unknot")
        self.assertGreater(abs(wirepack.writhe(trefoil.tolist(), closed=True)), 3)
        mirrored = trefoil * [1, 1, -1]
        self.assertAlmostEqual(wirepack.writhe(mirrored, closed=True),
                               -wirepack.writhe(position=trefoil, closed=True))
        axes = wirepack.coil_axes(trefoil)
        numpy.testing.assert_allclose(numpy.linalg.norm(axes, axis=1), 1)


class Refusals(PackerTest):
    def test_messages_are_those_of_the_program(self):
        self.write("bad.toml", "[cavity]\nradius = -4\nradios = 3\n[wire]\nradius = 'thick'\n")
        self.write("worse.toml", "[cavity\n")
        for name in ("bad.toml", "worse.toml", "missing.toml"):
            code, _, err = self.run_program("run", name, "-o", "out.h5")
            self.assertEqual(code, 2)
            with self.assertRaises(ValueError) as caught:
                wirepack.Packer(name)
            self.assertEqual(f"wirepack run: {caught.exception}\n", err)
        self.assertEqual(self.names(), ["bad.toml", "run.toml", "worse.toml"])

    def test_wrong_values_are_named(self):
        for config, message in (
            ({"cavity": {"radius": -4}}, "config: cavity.radius = -4: must be"),
            ({"cavity": {"radius": None}}, 'config: cavity.radius = "None": must be'),
            ({"cavity": {"radios": 4}}, "config: cavity.radios.*radius"),
            ({"radius": 4}, "config: must have the form section.key=value"),
            ({}, "config: has no key at all"),
            ("[cavity]\nradius = -4", "config:2:1: cavity.radius = -4: must be"),
        ):
            with self.assertRaisesRegex(ValueError, message):
                wirepack.Packer(config)
        with self.assertRaisesRegex(ValueError, "set: cavity.radius = nan"):
            wirepack.Packer("run.toml", set={"cavity.radius": float("nan")})
        for wrong in (lambda: wirepack.Packer(4), lambda: wirepack.Packer("run.toml", set="x=1"),
                      lambda: wirepack.Packer("run.toml", output=4),
                      lambda: wirepack.writhe(numpy.eye(3), shut=True)):
            with self.assertRaisesRegex(TypeError, r"int|'x=1': must be a dict|closed: bool"):
                wrong()
        packer = wirepack.Packer("run.toml")
        for limits, kind, message in (
            ({"density": -1}, ValueError, "stop.density = -1: must be"),
            ({"density": "all"}, ValueError, "all"),
            ({"length": [1]}, TypeError, "list"),
            ({"increments": 0}, ValueError, "increments = 0: must be 1 or more"),
            ({"increments": 1.5}, TypeError, "float"),
        ):
            with self.assertRaisesRegex(kind, message):
                packer.advance(**limits)
        self.assertEqual(len(packer.history.force), 0)
        self.assertIsNone(packer.advance(increments=1))  # goes on after all of them

    def test_outputs_destroy_nothing_and_trouble_with_files_is_an_oserror(self):
        self.write("there.h5", "something")
        packer = wirepack.Packer("run.toml")
        for call in (lambda: wirepack.Packer("run.toml", output="there.h5"),
                     lambda: packer.save("there.h5")):
            with self.assertRaisesRegex(ValueError, "there.h5 exists; .*replace=True"):
                call()
        with self.assertRaisesRegex(ValueError, "is an input"):
            packer.save("run.toml", replace=True)
        with self.assertRaisesRegex(ValueError, "is an input"):
            packer.save(packer.path, replace=True)
        self.assertEqual((self.folder / "there.h5").read_text(), "something")
        for call in (lambda: wirepack.Packer("run.toml", output="no/out.h5"),
                     lambda: packer.save("no/out.h5"),
                     lambda: packer.save("/proc/out.h5"),
                     lambda: wirepack.Packer("run.toml", output="there.h5", resume=True)):
            with self.assertRaisesRegex(OSError, r"no/out.h5|/proc/out.h5|there.h5"):
                call()
        self.write("there.h5.lock", "something")  # in place of that of a run
        with self.assertRaisesRegex(OSError, "there.h5.lock: is in the way"):
            packer.save("there.h5", replace=True)
        (self.folder / "there.h5.lock").unlink()
        packer.save("there.h5", replace=True)
        self.assertEqual((self.folder / "there.h5").read_bytes(), packer.path.read_bytes())
        self.assertEqual(self.names(), ["run.toml", "there.h5"])
        shutil.copy("there.h5", "other.h5")
        with self.assertRaisesRegex(ValueError, "cannot be continued.*cavity.radius: was 4"):
            wirepack.Packer("run.toml", {"cavity.radius": 5}, output="other.h5", resume=True)

    def test_positions_are_looked_at(self):
        packer = wirepack.Packer("run.toml")
        good = numpy.array([[0, 0, 0], [0, 0, 1], [0, 0.1, 2], [0, 0, 3.0]])
        infinite, met = good.copy(), good.copy()
        infinite[2, 1], met[2] = numpy.nan, met[1]
        for call in (packer.energy, packer.relax, wirepack.writhe, wirepack.knot_type):
            for bad, message in (
                (good.T, r"position: has the shape \(3, 4\); must be N x 3"),
                (good[:2], r"position: has the shape \(2, 3\); must be N x 3, N at least 3"),
                (good[0], r"position: has the shape \(3,\)"),
                (infinite, r"position\[2\]: is not finite"),
                (good * 1j, "position: is no array of real numbers"),
                ("wire", "position: is no array of real numbers"),
                ([[1, 2], [3]], "position: is no array of real numbers"),
            ):
                with self.assertRaisesRegex(ValueError, message):
                    call(bad)
        for bad, message in ((met, "edge 1 has no length"), (good * 1e200, "energy is not finite")):
            with self.assertRaisesRegex(wirepack.NumericalFailure, message):
                packer.energy(bad)
        frames = numpy.tile([1.0, 0, 0, 0], (3, 1))
        for bad, message in (
            (frames[:2], "quaternion: has 2 rows; must have one for each of the 3 edges"),
            (frames[:, 1:], r"quaternion: has the shape \(3, 3\)"),
            (0 * frames, r"quaternion\[0\]: has no length"),
        ):
            with self.assertRaisesRegex(ValueError, message):
                packer.energy(good, bad)
        with self.assertRaisesRegex(ValueError, "inserted_length = 1.*: must be above"):
            packer.energy(numpy.cumsum(numpy.tile([0, 0, 1.0], (9, 1)), axis=0), None, 1)
        for threads in (0, 5000):
            with self.assertRaisesRegex(ValueError, f"threads = {threads}: must be from 1 to 4096"):
                wirepack.writhe(good, threads=threads)
        with self.assertRaisesRegex(ValueError, "wire_radius = -1"):
            wirepack.radial_density(good, -1, 4, 3)

    def test_warnings_of_a_configuration_are_warnings(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            wirepack.Packer("run.toml", {"output.frame_every_density": 1})
        self.assertEqual(len(caught), 1)
        self.assertIn("frame", str(caught[0].message))
        self.assertEqual(caught[0].filename, __file__)


if __name__ == "__main__":
    unittest.main()
