#!/usr/bin/python3
"""Energies of packings that friction left, of those relaxed from them, and of spools.

PYTHONPATH=apps/python:build/python order_energy.py SWEEP... prints a line of CSV for each cavity,
setup and density. The sweeps have runs with friction; the same runs without it, which pack the same
wires from the same nozzles; and runs without friction and imperfections, whose spools are those of
a perfect wire. Energies are in YI / R, means over seeds with standard errors. Ends with the commits
of the programs that made the runs.
"""

import csv
import sys
from pathlib import Path

import numpy
import wirepack
from paper_tables import commit_of, mean_and_error

DENSITIES = (0.3, 0.4)
PARTS = ("total", "bend", "twist")
SPACINGS = (2, 2.81)  # strands that touch, and those of the paper


def kind_of(run):
    """What a run is for: (what, setup, R, seed)."""
    packing = run.config["packing"]
    what = "packed"
    if run.config["friction"]["model"] == "none":
        what = "same" if any(run.config["imperfection"].values()) else "perfect"
    return what, packing["setup"], run.cavity_radius / run.radius, packing["seed"]


def energies(run, energy):
    """Parts of an energy of a frame, in YI / R."""
    unit = run.bend_stiffness / run.cavity_radius
    return [value / unit for value in (energy.total, energy.terms["bend"], energy.terms["twist"])]


def energies_at(run, length):
    """The same of a run, at a length between two of its increments; nothing where it is shorter."""
    history = run.history
    if length > history.inserted_length[-1]:
        return [None] * len(PARTS)
    unit = run.bend_stiffness / run.cavity_radius
    columns = [history["energy_" + part] for part in PARTS]
    return [numpy.interp(length, history.inserted_length, column) / unit for column in columns]


def order(frame):
    return wirepack.coils(frame.position)["axis_order"]


def row_of_seed(run, frame, same, perfect, straight):
    """Everything that is averaged over seeds, by name."""
    packer, length = wirepack.Packer(run.config), frame.inserted_length
    relaxed = packer.relax(frame)
    states = {
        "packed": energies(run, packer.energy(frame)),
        "relaxed": energies(run, packer.energy(relaxed)),
        "same_spool": energies_at(same, length),
        "perfect_spool": energies_at(perfect, length),
        "straight_spool": energies_at(straight, length),
    }
    row = {f"{s}_{part}": e for s, of in states.items() for part, e in zip(PARTS, of)}
    unit = run.bend_stiffness / run.cavity_radius
    for spacing in SPACINGS:  # of a straight wire
        row[f"model_{spacing}"] = packer.spool_energy(frame.packing_density, spacing) / unit
    for state in ("packed", "relaxed"):
        below = row["same_spool_total"]
        row[f"{state}_over_spool"] = None if below is None else row[f"{state}_total"] / below
    at_rest = same.frames[frame.packing_density] if row["same_spool_total"] else None
    row |= {"packed_order": order(frame), "relaxed_order": order(relaxed),
            "same_spool_order": None if at_rest is None else order(at_rest)}
    row["farthest_move"] = numpy.linalg.norm(relaxed.position - frame.position, axis=1).max()
    return row


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
            lower = sum((row["relaxed_over_spool"] or 0) > 1 for row in rows)
            values = [v for name in rows[0] for v in mean_and_error([row[name] for row in rows])]
            table.writerow([f"{1 / radius:.4g}", setup, density, len(rows), lower, *values])
    print(f"# runs by commit {', '.join(sorted({commit_of(path) for path in paths}))}")


if __name__ == "__main__":
    main(sys.argv[1:])
