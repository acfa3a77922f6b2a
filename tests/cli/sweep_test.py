#!/usr/bin/python3
"""Sweeps: whatever stops them, the same command ends in the bits of undisturbed runs."""

import csv
import json
import os
import shutil
import signal
import statistics
import subprocess
import unittest
import xml.etree.ElementTree
from pathlib import Path

import h5py

from support import PROGRAM
from sweep_support import PLAN, TASKS, Stops, SweepTest

SHORT = PLAN.replace("40", "8").replace("[3, 3.5, 4]", "[3, 4]")


def kill_all(process):
    """kill -9 of a sweep and of all that it runs."""
    process.send_signal(signal.SIGSTOP)
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    for number in [process.pid, *map(int, children)]:
        os.kill(number, signal.SIGKILL)
    process.communicate()


class Interrupted(SweepTest):
    def check_status(self):
        told = self.status("part")
        for task in self.tasks("part"):
            self.assertEqual(told[task.name][0], self.true_state(task)[0], task.name)

    def test_killed_twice_and_on_a_full_disk_it_ends_in_the_same_bits_and_computes_nothing_twice(
        self,
    ):
        code, out, err = self.run_program("sweep", "plan.toml", "-o", "whole", timeout=120)
        self.assertEqual((code, out), (0, f"# {TASKS} tasks: {TASKS} done\n"), err)
        disk = self.small_disk("part")
        stops = Stops(self, "part")
        for done in (4, 9):
            process = self.start("sweep", "plan.toml", "-o", "part", "--jobs", "2")
            self.wait_for_done("part", done, process)
            kill_all(process)
            self.check_status()
            stops.note()
        disk.fill()
        code, out, err = self.run_program("sweep", "plan.toml", "-o", "part", timeout=120)
        self.assertEqual(code, 5, err)
        told = self.status("part")
        failed = [name for name, (state, _) in told.items() if state == "failed"]
        self.assertGreater(len(failed), 0)
        full = "No space left on device"
        self.assertTrue(any(full in told[name][1] for name in failed), told)
        for name in failed:  # one may take the room that was left for logs
            self.assertRegex(told[name][1], f"exit code 5: (.*{full}|its log says nothing)")
            self.assertIn(f"{name}: failed, exit code 5", err)
        stops.note()
        disk.empty()
        code, out, err = self.run_program("sweep", "plan.toml", "-o", "part", timeout=120)
        self.assertEqual((code, out), (0, f"# {TASKS} tasks: {TASKS} done\n"), err)
        self.check_status()
        self.check_same_bits("whole", "part")
        for name, (files, stamp) in stops.finished.items():
            task = self.folder / "part" / name
            self.assertEqual([(task / n).read_bytes() for n in ("run.h5", "run.log")], files, name)
            self.assertEqual((task / "run.h5").stat().st_mtime_ns, stamp)
        stops.check()

    def test_a_signal_is_handed_on_and_all_save(self):
        self.write(
            "plan.toml", PLAN.replace("= 40", "= 100000").replace("seconds = 0", "seconds = 1000")
        )
        process = self.start("sweep", "plan.toml", "-o", "part", "--jobs", "2")
        self.wait_for(lambda: len(list(self.folder.glob("part/*/run.h5.lock"))) == 2, process)
        process.send_signal(signal.SIGTERM)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 75, err)
        self.assertIn("the same command goes on from there", err)
        states = [state for state, _ in self.status("part").values()]
        self.assertEqual((states.count("resumable"), states.count("waiting")), (2, TASKS - 2))
        for log in self.folder.glob("part/*/run.log"):
            self.assertTrue(log.read_text().endswith("exit code 75\n"))


class Tasks(SweepTest):
    def setUp(self):
        super().setUp()
        self.write("plan.toml", SHORT)

    def sweep(self, expected, *arguments, **options):
        code, out, err = self.run_program("sweep", "plan.toml", "-o", "out", *arguments, **options)
        self.assertEqual(code, expected, err)
        return out, err

    def test_a_finished_sweep_returns_and_changes_nothing(self):
        self.sweep(0)
        files = [p for p in self.folder.glob("out/**/*") if p.is_file()]
        before = {p: (p.stat().st_mtime_ns, p.stat().st_ino) for p in files}
        self.sweep(0)
        files = [p for p in self.folder.glob("out/**/*") if p.is_file()]
        self.assertEqual({p: (p.stat().st_mtime_ns, p.stat().st_ino) for p in files}, before)

    def test_each_task_is_an_ordinary_run(self):
        self.sweep(0)
        task = "setup=high_torsion,radius=4,seed=2"
        code, _, err = self.run_program("run", f"out/{task}/config.toml", "-o", "alone.h5")
        self.assertEqual(code, 0, err)
        with h5py.File(self.folder / "alone.h5") as alone, h5py.File(
            self.folder / "out" / task / "run.h5"
        ) as swept:
            self.assertEqual(alone.attrs["seed"], 2)
            for name in ("force", "energy_total"):
                one, other = alone["history"][name][()], swept["history"][name][()]
                self.assertEqual(one.tobytes(), other.tobytes())

    def test_a_task_that_another_runs_is_left_to_it(self):
        code, out, err = self.run_program("sweep", "plan.toml", "-o", "out", "--emit", "parallel")
        self.assertEqual(code, 0, err)
        task = "setup=low_torsion,radius=3,seed=1"
        arguments = ["run", f"out/{task}/config.toml", "-o", f"out/{task}/run.h5"]
        other = self.start(*arguments)
        self.addCleanup(other.kill)
        other.stdout.readline()
        other.send_signal(signal.SIGSTOP)
        _, err = self.sweep(5)
        self.assertIn(f"{task}: is run by process {other.pid} on ", err)
        self.assertEqual(self.status("out")[task][0], "running")
        other.send_signal(signal.SIGCONT)
        other.communicate(timeout=60)
        self.sweep(0)

    def test_a_task_that_fails_is_told_and_does_not_stop_the_others(self):
        self.run_program("sweep", "plan.toml", "-o", "out", "--emit", "parallel")
        task = "setup=low_torsion,radius=4,seed=1"
        (self.folder / "out" / task / "run.h5").write_text("not a result")
        _, err = self.sweep(5)
        self.assertIn(f"{task}: failed, exit code 5: ", err)
        told = self.status("out")
        self.assertEqual(told[task][0], "failed")
        self.assertIn("is not an HDF5 file", told[task][1])
        self.assertEqual(sum(state == "done" for state, _ in told.values()), 11)

    def test_no_equilibrium_is_a_result(self):
        self.write(
            "plan.toml",
            SHORT.replace(', "high_torsion"', "") + "[minimizer]\nmax_evaluations = 3\n",
        )
        out, _ = self.sweep(3)
        self.assertIn("6 no equilibrium", out)
        self.sweep(3)  # and it is not tried again
        for log in self.folder.glob("out/*/run.log"):
            self.assertEqual(log.read_text().count("exit code 3\n"), 1)

    def test_a_changed_plan_adds_what_is_missing_and_extends_what_is_done(self):
        self.sweep(0)
        self.write("plan.toml", SHORT.replace("[3, 4]", "[4, 5]").replace("= 8", "= 12"))
        _, err = self.sweep(0)
        self.assertIn("12 tasks, 6 of them new", err)
        self.assertIn("setup=low_torsion,radius=4,seed=1 has other limits or output now", err)
        self.assertIn("setup=low_torsion,radius=3,seed=1 is of an earlier plan", err)
        self.assertEqual(len(self.status("out")), 12)
        with h5py.File(self.folder / "out/setup=low_torsion,radius=4,seed=1/run.h5") as file:
            self.assertEqual(len(file["history/increment"]), 12)
        with h5py.File(self.folder / "out/setup=low_torsion,radius=3,seed=1/run.h5") as file:
            self.assertEqual(len(file["history/increment"]), 8)

    def test_the_page_of_a_sweep_has_a_picture_and_a_curve_of_each_task_with_a_result(self):
        self.write("plan.toml", SHORT)
        self.sweep(0)
        (self.folder / "out/setup=low_torsion,radius=4,seed=3/run.h5").unlink()
        (self.folder / "out/setup=low_torsion,radius=4,seed=2/run.h5").write_text("<b>\x1b[31m")
        code, _, err = self.run_program("sweep", "--status", "out", "--page")
        self.assertEqual((code, err), (0, "wirepack sweep: out/status.html is written\n"))
        page = xml.etree.ElementTree.fromstring((self.folder / "out/status.html").read_text()[15:])
        rows = {row[0].text: row for row in page.iter("tr")}
        self.assertEqual(len(rows), 13)
        for name, row in rows.items():
            drawings = len(list(row.iter("polyline")))
            self.assertEqual(drawings, 2 if row[1].text == "done" else 0, name)
        with h5py.File(self.folder / "out/setup=low_torsion,radius=3,seed=1/run.h5") as file:
            density = file["history/packing_density"][-1]
        self.assertEqual(rows["setup=low_torsion,radius=3,seed=1"][2].text, f"{density:.4f}")

    def test_pictures_of_the_page_lead_to_pages_as_of_view_made_once_for_each_result(self):
        self.write(
            "plan.toml",
            "[stop]\nincrements = 4\n[sweep.cases.ball]\ncavity.radius = 3\n"
            "[sweep.cases.egg]\ncavity.shape = 'ellipsoid'\ncavity.semi_axes = [3, 3, 4]\n",
        )
        self.sweep(0)
        page = lambda name: self.folder / f"out/case={name}/view.html"
        result = lambda name: self.folder / f"out/case={name}/run.h5"

        def links():
            code, _, err = self.run_program("sweep", "--status", "out", "--page")
            self.assertEqual(code, 0, err)
            text = (self.folder / "out/status.html").read_text()[15:]
            found = xml.etree.ElementTree.fromstring(text).iter("a")
            return sorted(link.get("href") for link in found if len(link.findall("svg")) == 1)

        self.assertEqual(links(), ["./case=ball/view.html", "./case=egg/view.html"])
        code, _, err = self.run_program("view", result("ball"), "-o", "view.html")
        self.assertEqual(code, 0, err)
        self.assertEqual((self.folder / "view.html").read_bytes(), page("ball").read_bytes())
        # what is newer than its result stays
        page("ball").write_text("mine")
        page("egg").write_text("old")
        os.utime(page("egg"), ns=(0, 0))
        links()
        self.assertEqual(page("ball").read_text(), "mine")
        self.assertGreater(page("egg").stat().st_size, 10000)
        # a page that cannot be made is no hindrance, and said
        page("egg").unlink()
        page("egg").mkdir()
        self.assertEqual(links(), ["./case=ball/view.html"])
        status = (self.folder / "out/status.html").read_text()
        self.assertIn("no page: out/case=egg/view.html: is a folder", status)

    def test_help_shows_the_names_that_an_option_takes_and_others_are_refused(self):
        code, out, _ = self.run_program("sweep", "--help")
        self.assertEqual(code, 0)
        self.assertIn("\n  --executor local|slurm|parallel\n", out)
        self.assertIn("\n  --emit slurm|parallel|snakemake|hyperqueue\n", out)
        for option, word in (("--executor", "0"), ("--executor", "Slurm"), ("--emit", "1")):
            code, _, err = self.run_program("sweep", "plan.toml", "-o", "out", option, word)
            self.assertEqual(code, 2)
            self.assertRegex(err, f"{option}: must be [a-z|]*parallel[a-z|]*, not {word}")
        self.assertEqual(self.names(), ["plan.toml"])

    def test_another_configuration_under_the_same_names_is_refused(self):
        self.sweep(0)
        before = sorted(self.folder.glob("out/**/*"))
        self.write("plan.toml", SHORT + "[wire]\npoisson_ratio = 0.1\n")
        _, err = self.sweep(2)
        self.assertIn("is of another plan: wire.poisson_ratio: was 0.3", err)
        self.assertEqual(sorted(self.folder.glob("out/**/*")), before)

    def test_the_base_and_files_in_a_plan_are_found_beside_it(self):
        (self.folder / "plans").mkdir()
        self.write("plans/base.toml", "[cavity]\nradius = 4\n[stop]\nincrements = 5\n")
        self.write("plans/shape.toml", "[shape]\nk0 = [[0, 0.1, 0, 0], [500, 0.1, 0, 0]]\n")
        self.write(
            "plans/plan.toml",
            'base = "base.toml"\n[sweep.cases.straight]\nwire.precurvature = 0\n'
            '[sweep.cases.bent]\nwire.reference_shape = "shape.toml"\n',
        )
        code, out, err = self.run_program("sweep", "plans/plan.toml", "-o", "out")
        self.assertEqual((code, out), (0, "# 2 tasks: 2 done\n"), err)
        self.assertIn("reference_shape", (self.folder / "out/case=bent/config.toml").read_text())

    def test_a_plan_is_no_configuration_of_a_run_and_no_base(self):
        self.write("inner.toml", "[cavity]\nradius = 4\n[sweep]\npacking.seed = [1, 2]\n")
        self.write("outer.toml", 'base = "inner.toml"\n[sweep]\ncavity.radius = [3, 4]\n')
        for arguments in (["run", "inner.toml"], ["sweep", "outer.toml"]):
            code, _, err = self.run_program(*arguments, "-o", "out")
            self.assertEqual(code, 2)
            self.assertIn("inner.toml:3:2: [sweep]: makes this a plan, for `wirepack sweep`", err)
        self.assertFalse((self.folder / "out").exists())

    def test_tasks_keep_the_units_of_the_plan(self):
        units = '[units]\nlength = "mm"\nforce = "mN"\n'
        plan = "[stop]\nincrements = 3\n[sweep]\ncavity.radius = [3, 4]\n" + units
        self.write("plan.toml", plan)
        self.sweep(0)
        task = self.folder / "out/radius=3"
        self.assertTrue((task / "config.toml").read_text().endswith("\n" + units))
        self.assertRegex(
            (task / "run.log").read_text(), r"# force .* YI/R\^2 = -?[0-9.]+ [a-z]*N\n"
        )
        with h5py.File(task / "run.h5") as file:
            self.assertEqual(file.attrs["length_unit"], "mm")
        # other units are no other plan
        self.write("plan.toml", plan.replace("mm", "um"))
        _, err = self.sweep(0)
        self.assertIn("radius=3 has other limits or output now", err)
        self.assertIn('length = "um"', (task / "config.toml").read_text())

    def test_a_dry_run_lists_the_tasks_and_writes_nothing(self):
        self.write("plan.toml", SHORT.replace("increments = 8", "density = 0.1"))
        code, out, err = self.run_program("sweep", "plan.toml", "--dry-run")
        self.assertEqual(code, 0, err)
        lines = out.splitlines()
        self.assertEqual(len(lines), 13)
        self.assertIn("radius=4", lines[0])  # the longest first
        self.assertEqual(self.names(), ["plan.toml"])

    def test_wrong_calls_are_refused_and_write_nothing(self):
        for arguments, part in [
            (["sweep"], "PLAN.toml is needed"),
            (["sweep", "plan.toml"], "-o DIR is needed"),
            (["sweep", "--status", "nowhere"], "is not the folder of a sweep"),
            (["sweep", "--collect", "nowhere"], "is not the folder of a sweep"),
            (["sweep", "missing.toml", "-o", "out"], "there is no such file"),
            (["sweep", "plan.toml", "-o", "out", "--executor", "pbs"], "pbs"),
            (["sweep", "plan.toml", "-o", "out", "--hosts", "plan.toml"], "--hosts goes with"),
            (["sweep", "plan.toml", "-o", "out", "--hosts", "nowhere"], "nowhere"),
            (
                ["sweep", "plan.toml", "-o", "out", "--emit", "snakemake", "--jobs", "2"],
                "--jobs goes with slurm and parallel",
            ),
        ]:
            code, _, err = self.run_program(*arguments)
            self.assertEqual(code, 2, arguments)
            self.assertIn(part, err)
            self.assertEqual(self.names(), ["plan.toml"])
        (self.folder / "out").mkdir()
        self.write("out/tasks.tsv", "something of the user")
        _, err = self.sweep(2)
        self.assertIn("out/tasks.tsv: is not a list of tasks", err)
        self.assertEqual(os.listdir(self.folder / "out"), ["tasks.tsv"])
        shutil.rmtree(self.folder / "out")
        self.write("out", "")
        _, err = self.sweep(2)
        self.assertIn("out: is not a folder", err)
        (self.folder / "out").unlink()
        self.write("plan.toml", "[sweep]\ncavity.radius = [4, -1]\n")
        _, err = self.sweep(2)
        self.assertIn("plan.toml:2:21: cavity.radius = -1", err)
        self.assertEqual(self.names(), ["plan.toml"])


class TablesOverSeeds(SweepTest):
    def test_they_hold_mean_and_deviation_of_the_finished_runs(self):
        self.write("plan.toml", SHORT)
        self.run_program("sweep", "plan.toml", "-o", "out")
        (self.folder / "out/setup=low_torsion,radius=4,seed=3/run.h5").unlink()
        code, out, err = self.run_program("sweep", "--collect", "out")
        self.assertEqual(code, 0, err)
        self.assertEqual(out.split(), [f"out/tables/{n}.csv" for n in ("runs", "seeds", "curves")])

        def rows(name):
            with open(self.folder / "out/tables" / name) as file:
                return list(csv.DictReader(file))

        self.assertEqual(len(rows("runs.csv")), 12)
        groups = {(row["packing.setup"], row["cavity.radius"]): row for row in rows("seeds.csv")}
        self.assertEqual(len(groups), 4)
        self.assertEqual(groups["low_torsion", "4"]["runs"], "2")
        row = groups["high_torsion", "3"]
        energies = []
        for seed in (1, 2, 3):
            with h5py.File(
                self.folder / f"out/setup=high_torsion,radius=3,seed={seed}/run.h5"
            ) as f:
                # YI / R of the default wire in a sphere of 3
                energies.append(f["history/energy_bend"][-1] * 3 / (5 * 3.141592653589793 / 4))
        self.assertEqual(row["runs"], "3")
        self.assertAlmostEqual(float(row["bend_energy_mean"]), statistics.mean(energies), places=6)
        self.assertAlmostEqual(
            float(row["bend_energy_deviation"]), statistics.stdev(energies), places=6
        )
        for row in rows("curves.csv"):
            if row["packing.setup"] == "low_torsion" and row["cavity.radius"] == "4":
                self.assertLessEqual(int(row["runs"]), 2)

    def test_analyze_and_figures_take_the_folder_of_a_sweep(self):
        self.write("plan.toml", SHORT)
        self.run_program("sweep", "plan.toml", "-o", "out")
        code, out, err = self.run_program("analyze", "out", "--json")
        self.assertEqual(code, 0, err)
        self.assertEqual(len({frame["run"] for frame in json.loads(out)["frames"]}), 12)
        code, _, err = self.run_program("figures", "out", "-o", "drawn")
        self.assertEqual(code, 0, err)
        self.assertGreater(len(os.listdir(self.folder / "drawn")), 3)


class Emitted(SweepTest):
    def emit(self, engine, name, *arguments):
        call = ["sweep", "plan.toml", "-o", "out", "--emit", engine, *arguments]
        code, out, err = self.run_program(*call)
        self.assertEqual((code, out), (0, f"out/{name}\n"), err)
        return self.folder / "out" / name

    def test_scripts_are_what_their_interpreters_accept(self):
        self.write("plan.toml", SHORT)
        for engine, name in [
            ("slurm", "slurm.sh"),
            ("parallel", "parallel.sh"),
            ("hyperqueue", "hyperqueue.sh"),
            ("snakemake", "Snakefile"),
        ]:
            script = self.emit(engine, name)
            if name.endswith(".sh"):
                subprocess.run(["bash", "-n", script], check=True)
            text = script.read_text()
            self.assertEqual(text.count("setup="), 12)
            self.assertNotRegex(text, "@[a-z_]+@")

    def test_names_that_a_shell_would_change_are_quoted(self):
        odd = 'it\'s $HOME `id` "here"'
        (self.folder / odd / "bin").mkdir(parents=True)
        program = shutil.copy(PROGRAM, self.folder / odd / "wire pack's $1")
        self.write(
            f"{odd}/plan.toml",
            "[stop]\nincrements = 3\n[sweep]\ncavity.radius = [3]\npacking.seed = [1, 2, 3]\n",
        )
        for engine, name in [("slurm", "slurm.sh"), ("parallel", "parallel.sh")]:
            with self.subTest(engine):
                if engine == "parallel" and shutil.which("parallel") is None:
                    self.skipTest("GNU parallel is not installed")
                call = [program, "sweep", f"{odd}/plan.toml", "-o", f"{odd}/{engine}"]
                subprocess.run(
                    [*call, "--emit", engine], cwd=self.folder, check=True, capture_output=True
                )
                done = subprocess.run(
                    ["bash", f"{odd}/{engine}/{name}"],
                    cwd=self.folder,
                    env={**os.environ, "PATH": f"{self.slurm_of_one()}:{os.environ['PATH']}"},
                    capture_output=True,
                    text=True,
                    check=False,
                )
                self.assertEqual(done.returncode, 0, done.stderr)
                states = [state for state, _ in self.status(f"{odd}/{engine}").values()]
                self.assertEqual(states, ["done"] * 3, done.stderr)

    def slurm_of_one(self):
        """Programs called sbatch and scontrol: a job runs at once, where it is submitted."""
        folder = self.folder / "slurm_of_one"
        folder.mkdir(exist_ok=True)
        array = "${1#--array=0-}"
        for name, script in {
            "sbatch": f"last={array}\nshift\nfor ((k = 0; k <= last; ++k)); do\n"
            '  SLURM_ARRAY_TASK_ID=$k bash "$@" || exit\ndone\n',
            "scontrol": "echo MaxArraySize = 1000\n",
        }.items():
            (folder / name).write_text("#!/bin/bash\n" + script)
            (folder / name).chmod(0o755)
        return folder

    def test_an_engine_that_is_not_there_is_named_and_is_trouble_with_files(self):
        self.write("plan.toml", SHORT)
        (self.folder / "bin").mkdir()
        for name in ("bash", "dirname", "mkdir", "sed"):
            (self.folder / "bin" / name).symlink_to(shutil.which(name))
        environment = {**os.environ, "PATH": str(self.folder / "bin")}
        for engine, missing, end in [
            (
                "slurm",
                "sbatch of Slurm",
                "out/slurm.sh: ended with code 5: not all tasks are queued",
            ),
            (
                "parallel",
                "GNU parallel",
                "out/parallel.sh: ended with code 127: not all tasks are run",
            ),
        ]:
            with self.subTest(engine):
                code, out, err = self.run_program(
                    "sweep", "plan.toml", "-o", "out", "--executor", engine, env=environment
                )
                self.assertEqual((code, out), (5, ""), err)
                self.assertIn(f"{engine}.sh: {missing} is not found on this machine\n", err)
                self.assertIn(end, err)
                states = {state for state, _ in self.status("out").values()}
                self.assertEqual(states, {"waiting"})

    def test_hyperqueue_is_handed_each_task_and_a_task_makes_its_mark_when_it_is_finished(self):
        self.write("plan.toml", SHORT.replace("radius = [3, 4]", "radius = [3]"))
        script = self.emit("hyperqueue", "hyperqueue.sh", "--threads", "2")
        # in the place of the program: does what it is told, each task at once
        hq = self.write(
            "hq",
            """#!/bin/bash
printf '%s\\n' "$*" > hq.call
while [[ $1 != --each-line ]]; do shift; done
mapfile -t entries < "$2"
while [[ $1 != -- ]]; do shift; done
for entry in "${entries[@]}"; do HQ_ENTRY=$entry "${@:2}" || exit; done
""",
        )
        hq.chmod(0o755)
        environment = {**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}"}
        submit = ["bash", script, "--time-request=1h"]
        subprocess.run(submit, env=environment, check=True, capture_output=True)
        call = (self.folder / "out/hq.call").read_text()
        self.assertRegex(call, "^submit .*--cpus 2 .*--time-request=1h -- bash /.*/hyperqueue.sh\n")
        self.check_marks(6)

    @unittest.skipUnless(shutil.which("snakemake"), "Snakemake is not installed")
    def test_snakemake_runs_each_task_and_those_that_it_stopped_go_on(self):
        self.write("plan.toml", SHORT.replace("radius = [3, 4]", "radius = [3]"))
        script = self.emit("snakemake", "Snakefile")
        broken = self.folder / "out/setup=low_torsion,radius=3,seed=1/run.h5"
        broken.write_text("not a result")
        call = ["snakemake", "-s", script, "--cores", "2", "--keep-going"]
        self.assertNotEqual(subprocess.run(call, capture_output=True, check=False).returncode, 0)
        self.check_marks(5)
        self.assertEqual(broken.read_text(), "not a result")
        broken.unlink()
        subprocess.run(call, capture_output=True, check=True)
        self.check_marks(6)
        again = subprocess.run([*call, "-n"], capture_output=True, text=True, check=True)
        self.assertIn("Nothing to be done", again.stdout + again.stderr)

    def check_marks(self, count):
        marked = {path.parent.name for path in self.folder.glob("out/*/done")}
        told = self.status("out")
        self.assertEqual(marked, {name for name, (state, _) in told.items() if state == "done"})
        self.assertEqual(len(marked), count)

    def test_what_is_finished_is_not_in_them(self):
        self.write("plan.toml", SHORT)
        self.run_program("sweep", "plan.toml", "-o", "out")
        self.run_program("sweep", "plan.toml", "-o", "out", "--emit", "slurm")
        self.assertNotIn("setup=", (self.folder / "out/slurm.sh").read_text())


if __name__ == "__main__":
    unittest.main()
