#!/usr/bin/python3
"""Energies of packings that friction left, of those relaxed from them, and of spools.

PYTHONPATH=apps/python:build/python order_energy.py SWEEP... prints a line of CSV for each cavity,
setup and density. The sweeps have runs with friction; the same without, which feed the same wires
from the same nozzles (same_spool); and one run of each setup without friction and imperfections, at
seed 1 (perfect_spool; straight_spool is that of low torsion). All have the length of the packing.
Energies are in YI / R, means over seeds with standard errors. spool_lower counts the seeds whose
spool has less energy than the relaxed packing. Ends with the commits of the programs that made the
runs.
"""

import csv
import sys
from pathlib import Path

import numpy
import wirepack
from paper_tables import commit_of, mean_and_error

DENSITIES = (0.3, 0.4)
SPACINGS = (2, 2.81)  # strands that touch, and those of the paper


def kind_of(run):
    """What a run is for: (what, setup, R, seed)."""
    packing = run.config["packing"]
    what = "packed"
    if run.config["friction"]["model"] == "none":
        what = "same" if any(run.config["imperfection"].values()) else "perfect"
    return what, packing["setup"], run.cavity_radius / run.radius, packing["seed"]


def of_frame(state, packer, frame):
    energy, unit = packer.energy(frame), packer.bend_stiffness / packer.cavity_radius
    row = {f"{state}_total": energy.total / unit}
    row |= {f"{state}_{part}": energy.terms[part] / unit for part in ("bend", "twist")}
    return row | {f"{state}_order": wirepack.coils(frame.position)["axis_order"]}


def of_run(state, run, length, parts):
    """Energies at a length between two increments; nothing where the run is shorter."""
    history, unit = run.history, run.bend_stiffness / run.cavity_radius
    if length > history.inserted_length[-1]:
        return {f"{state}_{part}": None for part in parts}
    at = {p: numpy.interp(length, history.inserted_length, history[f"energy_{p}"]) for p in parts}
    return {f"{state}_{part}": energy / unit for part, energy in at.items()}


def row_of_seed(run, frame, same, perfect, straight):
    """Everything that is averaged over seeds, by name."""
    packer, length = wirepack.Packer(run.config), frame.inserted_length
    relaxed = packer.relax(frame)
    row = of_frame("packed", packer, frame) | of_frame("relaxed", packer, relaxed)
    row |= of_run("same_spool", same, length, ("total", "bend", "twist"))
    reached = row["same_spool_total"] is not None
    nearest = same.frames[frame.packing_density].position if reached else None
    row["same_spool_order"] = wirepack.coils(nearest)["axis_order"] if reached else None
    for state in ("packed", "relaxed"):
        ratio = row[f"{state}_total"] / row["same_spool_total"] if reached else None
        row[f"{state}_over_same_spool"] = ratio
    row |= of_run("perfect_spool", perfect, length, ("total",))
    row |= of_run("straight_spool", straight, length, ("total",))
    unit = packer.bend_stiffness / packer.cavity_radius
    for spacing in SPACINGS:  # of a straight wire
        energy = packer.spool_energy(frame.packing_density, spacing)
        row[f"model_of_spacing_{spacing}"] = energy / unit
    moves = numpy.linalg.norm(relaxed.position - frame.position, axis=1)
    return row | {"farthest_move": moves.max() / packer.radius}


def rows_of(runs, setup, radius, density):
    """Of every seed whose run has come to the density."""
    for what, *where, seed in sorted(runs):
        if (what, *where) != ("packed", setup, radius):
            continue
        run = runs["packed", setup, radius, seed]
        try:
            frame = run.frames[density]
        except IndexError:  # it has ended before
            continue
        spools = [("same", setup, radius, seed), ("perfect", setup, radius, 1),
                  ("perfect", "low_torsion", radius, 1)]
        if all(spool in runs for spool in spools):
            yield row_of_seed(run, frame, *(runs[spool] for spool in spools))


def main(folders):
    paths = [path for folder in folders for path in sorted(Path(folder).glob("*/run.h5"))]
    runs = {kind_of(run): run for run in map(wirepack.Run, paths)}
    table = csv.writer(sys.stdout, lineterminator="\n")
    titled = False
    for radius, setup in sorted({key[2:0:-1] for key in runs if key[0] == "packed"}):
        for density in DENSITIES:
            rows = list(rows_of(runs, setup, radius, density))
            if not rows:
                continue
            if not titled:
                names = [column for name in rows[0] for column in (name, f"{name}_error")]
                table.writerow(["a_over_R", "setup", "density", "runs", "spool_lower", *names])
                titled = True
            lower = sum((row["relaxed_over_same_spool"] or 0) > 1 for row in rows)
            values = [v for name in rows[0] for v in mean_and_error([row[name] for row in rows])]
            table.writerow([f"{1 / radius:.4g}", setup, density, len(rows), lower, *values])
    print(f"# runs by commit {', '.join(sorted({commit_of(path) for path in paths}))}")


if __name__ == "__main__":
    main(sys.argv[1:])
