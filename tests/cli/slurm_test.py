#!/usr/bin/python3
"""Sweeps under a real Slurm on one node, which the test starts itself and ends."""

import os
import re
import shutil
import socket
import subprocess
import time
import unittest

from sweep_support import SweepTest

CONFIGURATION = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmdPort={other_port}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CryptoType=crypto/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
SchedulerParameters=sched_interval=2,batch_sched_delay=0
MaxArraySize=2
KillWait=15
NodeName={host} NodeAddr=127.0.0.1 CPUs={processors} RealMemory=500 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""

# Six tasks of some seconds.
SECONDS_EACH = """
[stop]
increments = 300
[output]
checkpoint_every_seconds = 0.2
[sweep]
packing.setup = ["low_torsion", "high_torsion"]
cavity.radius = [8]
packing.seed = { from = 1, to = 3 }
"""


def missing():
    """Why Slurm cannot run here; empty: it can."""
    programs = ["munged", "mungekey", "slurmctld", "slurmd", "sbatch", "scontrol", "squeue"]
    lacking = [name for name in programs if shutil.which(name) is None]
    if lacking:
        return f"not installed: {', '.join(lacking)}"
    return "" if os.geteuid() == 0 else "slurmctld and slurmd need root"


def free_port():
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return listener.getsockname()[1]


@unittest.skipIf(missing(), missing())
class UnderSlurm(SweepTest):
    def setUp(self):
        super().setUp()
        self.cluster = self.folder / "cluster"
        for name in ("state", "spool"):
            (self.cluster / name).mkdir(parents=True)
        configuration = self.cluster / "slurm.conf"
        configuration.write_text(
            CONFIGURATION.format(
                host=socket.gethostname().split(".")[0],
                port=free_port(),
                other_port=free_port(),
                folder=self.cluster,
                processors=os.cpu_count(),
            )
        )
        os.environ["SLURM_CONF"] = str(configuration)
        self.addCleanup(os.environ.pop, "SLURM_CONF")
        at = lambda name: f"{self.cluster}/{name}"
        subprocess.run(["mungekey", "-c", "-k", at("key")], check=True)
        self.daemon(
            "munged",
            "-F",
            "--force",
            f"--key-file={at('key')}",
            f"--socket={at('munge.socket')}",
            f"--pid-file={at('munge.pid')}",
            f"--log-file={at('munge.log')}",
            f"--seed-file={at('munge.seed')}",
        )
        self.wait_until(lambda: (self.cluster / "munge.socket").exists(), 30)
        self.daemon("slurmctld", "-D", "-f", str(configuration))
        self.daemon("slurmd", "-D", "-f", str(configuration))
        self.wait_until(lambda: "idle" in self.output("sinfo", "-h", "-o", "%t"), 120)

    def daemon(self, *command):
        output = open(self.cluster / f"{command[0]}.out", "w")
        self.addCleanup(output.close)
        process = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT)

        def end():
            process.terminate()
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

        self.addCleanup(end)

    def output(self, *command):
        return subprocess.run(command, capture_output=True, text=True, check=False).stdout

    def wait_until(self, reached, seconds, between=lambda: None):
        for _ in range(4 * seconds):
            if reached():
                return
            between()
            time.sleep(0.25)
        logs = [path.read_text()[-2000:] for path in self.cluster.glob("*.log")]
        self.fail("waited in vain; " + "\n".join(logs + [self.output("squeue", "-a")]))

    def queue(self):
        """A line for each job; one of its own where a busy controller gives no answer."""
        command = ["squeue", "-h", "-r", "-o", "%i %t"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        return done.stdout.splitlines() if done.returncode == 0 else ["no answer"]

    def start_what_waits(self):
        """Jobs that are queued again wait for two minutes, which a test does not."""
        for line in self.output("squeue", "-h", "-r", "-t", "PD", "-o", "%i %r").split("\n")[:-1]:
            if "BeginTime" in line:
                self.output("scontrol", "update", f"JobId={line.split()[0]}", "StartTime=now")

    def check_status(self, folder):
        told = self.status(folder)
        for task in self.tasks(folder):
            self.assertEqual(told[task.name][0], self.true_state(task)[0], task.name)

    def stop_what_runs(self):
        """Sends what Slurm sends before a time limit, when jobs are past their start."""
        if not list(self.folder.glob("part/*/run.h5.lock")):
            return
        for line in self.queue():
            if line.endswith(" R"):
                self.output("scancel", "--signal=USR1", "--batch", line.split()[0])

    def test_arrays_of_several_tasks_a_job_stopped_and_queued_again_end_in_the_same_bits(self):
        self.write("plan.toml", SECONDS_EACH)
        code, _, err = self.run_program("sweep", "plan.toml", "-o", "whole", timeout=200)
        self.assertEqual(code, 0, err)
        # 3 jobs of 2 tasks: two arrays, as an array has 2 elements at most
        arguments = [
            "sweep",
            "plan.toml",
            "-o",
            "part",
            "--executor",
            "slurm",
            "--tasks-per-job",
            "2",
        ]
        code, out, err = self.run_program(*arguments)
        self.assertEqual(code, 0, err)
        self.assertEqual(len(re.findall("Submitted batch job", out)), 2)
        self.wait_until(lambda: len(list(self.folder.glob("part/*/run.h5"))) >= 1, 120)
        logs = lambda: "".join(path.read_text() for path in self.folder.glob("part/*/run.log"))
        self.wait_until(lambda: "exit code 75\n" in logs(), 60, self.stop_what_runs)
        self.wait_until(lambda: not self.queue(), 400, self.start_what_waits)
        self.check_status("part")
        states = {state for state, _ in self.status("part").values()}
        self.assertEqual(states, {"done"})
        self.check_same_bits("whole", "part")
        for task in self.tasks("part"):
            log = (task / "run.log").read_text()
            self.assertEqual(log.count("exit code 0\n"), 1, log)
            saved = [int(n) for n in re.findall("holds all up to increment ([0-9]+)", log)]
            went_on = [int(n) for n in re.findall("going on after increment ([0-9]+)", log)]
            self.assertEqual(went_on, saved, log)  # nothing is computed twice
        code, out, err = self.run_program(*arguments)
        self.assertEqual((code, out), (0, "# 6 tasks: 6 done\n"), err)

    def test_a_job_that_reaches_its_time_limit_saves_and_is_queued_again(self):
        # An endless run: each start gets further, until there have been as many restarts as are
        # allowed.
        self.write(
            "plan.toml",
            "[stop]\nincrements = 1000000\n[output]\ncheckpoint_every_seconds = 1000\n"
            "[sweep]\ncavity.radius = [20]\n",
        )
        code, out, err = self.run_program(
            "sweep", "plan.toml", "-o", "long", "--emit", "slurm", "--restarts", "1"
        )
        self.assertEqual(code, 0, err)
        script = self.folder / out.strip()
        subprocess.run(
            ["bash", script, "--time=1", "--signal=B:USR1@40"], check=True, capture_output=True
        )
        log = self.folder / "long/radius=20/run.log"
        stopped = "wirepack run: exit code 75"

        def stops():
            return log.read_text().splitlines().count(stopped) if log.exists() else 0

        self.wait_until(lambda: stops() == 1, 150)
        self.assertEqual(self.status("long")["radius=20"][0], "resumable")
        first = self.true_state(self.folder / "long/radius=20")[1]
        self.assertGreater(first, 0)
        self.wait_until(lambda: stops() == 2, 300, self.start_what_waits)
        self.wait_until(lambda: not self.queue(), 60, self.start_what_waits)
        self.assertIn(f"going on after increment {first}\n", log.read_text())
        self.assertGreater(self.true_state(self.folder / "long/radius=20")[1], first)
        of_job = "".join(path.read_text() for path in self.folder.glob("long/slurm/*.log"))
        self.assertIn("1 restarts are the limit", of_job)


if __name__ == "__main__":
    if missing():
        print(f"skipped: {missing()}")
    unittest.main()
