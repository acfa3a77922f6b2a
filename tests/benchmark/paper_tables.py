#!/usr/bin/python3
"""Tables of data/docs/paper.md from folders of sweeps.

WIREPACK=build/wirepack paper_tables.py SWEEP... prints one line of CSV for each series of runs that
differ in their seeds alone: densities at which the force, as a mean over an edge after the first
coil, reaches thresholds of F R^2/YI and of F/(Y a^2), with standard errors; and what the last
frames are like. Ends with the machine and the commits of the programs that made the runs.
"""

import csv
import json
import os
import platform
import subprocess
import sys
import tomllib
from pathlib import Path
from statistics import fmean, stdev

import h5py

PROGRAM = os.environ.get("WIREPACK", "wirepack")
THRESHOLDS = [("scaled_force", 10), ("force", 0.1), ("force", 10**-0.5)]
OF_LAST_FRAMES = ["packing_density", "axis_order", "bend_log_mu", "bend_log_sigma"]


def analyzed(folder):
    done = subprocess.run(
        [PROGRAM, "analyze", folder, "--json"], stdout=subprocess.PIPE, text=True, check=True
    )
    return json.loads(done.stdout)


def mean_and_error(values):
    """A number and its standard error; empty where not every run has one."""
    if None in values:
        return ["", ""]
    error = stdev(values) / len(values) ** 0.5 if len(values) > 1 else None
    return [f"{fmean(values):.4f}", "" if error is None else f"{error:.4f}"]


def density_at(frame, scale, level):
    """Density at a threshold, where the run reaches it."""
    for row in frame["phi_max"]:
        if row["scale"] == scale and abs(row["level"] / level - 1) < 1e-6:
            return row["mean_over_edge"]
    return None


def commit_of(run):
    """Of the program that made a result."""
    with h5py.File(run, "r") as file:
        return str(file.attrs["git_commit"])


def series_row(sweep, series, frames):
    first = series[0]
    config = tomllib.loads((Path(first).parent / "config.toml").read_text())
    case = [part for part in Path(first).parent.name.split(",") if not part.startswith("seed=")]
    a, radius = config["wire"]["radius"], config["cavity"]["radius"]
    row = [sweep, ",".join(case), config["packing"]["setup"], f"{a / radius:.4g}", len(series)]
    of_series = [frames[run] for run in series]
    for scale, level in THRESHOLDS:
        row += mean_and_error([density_at(frame, scale, level) for frame in of_series])
    for name in OF_LAST_FRAMES:
        row += mean_and_error([frame[name] for frame in of_series])
    shares = [frame["twist_energy"] / frame["bend_energy"] for frame in of_series]
    return row + mean_and_error(shares)


def main(folders):
    table = csv.writer(sys.stdout, lineterminator="\n")
    names = [f"phi_at_{scale}_{level:.3g}" for scale, level in THRESHOLDS]
    names += OF_LAST_FRAMES + ["twist_over_bend_energy"]
    table.writerow(
        ["sweep", "series", "setup", "a_over_R", "runs"]
        + [column for name in names for column in (name, f"{name}_error")]
    )
    commits = set()
    for folder in folders:
        found = analyzed(folder)
        frames = {frame["run"]: frame for frame in found["frames"]}
        commits |= {commit_of(run) for run in frames}
        for ensemble in found["ensembles"]:
            table.writerow(series_row(Path(folder).name, ensemble["runs"], frames))
    made_by = ", ".join(sorted(commits))
    print(f"# {platform.machine()}, {os.cpu_count()} processors; runs by commit {made_by}")


if __name__ == "__main__":
    main(sys.argv[1:])
