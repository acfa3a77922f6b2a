#!/usr/bin/python3
"""Runs the scenarios of data/docs/results.md; writes its tables and the README's picture.

    WIREPACK=build/wirepack tests/benchmark/results_page.py FOLDER

Results are kept in the folder and gone on with, so the script may be stopped and called again. Six
runs take the better part of an hour.
"""

import os
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import h5py
import numpy

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "data/docs/results.md"
PROGRAM = os.environ.get("WIREPACK", "wirepack")
SETUPS = ("low", "high")
DENSITIES = {5: (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7), 10: (0.1, 0.2, 0.3, 0.4, 0.5, 0.6),
             20: (0.05, 0.1)}  # fmt: skip
SPACING = 2.81  # of the inverse spool, over the wire radius
RUNS = [(setup, radius) for radius in DENSITIES for setup in SETUPS]


def name_of(setup, radius):
    return f"{setup}_torsion_r{radius}"


def run(setup, radius, folder):
    name = name_of(setup, radius)
    subprocess.run(
        [PROGRAM, "run", ROOT / f"data/scenarios/{name}.toml", "-o", folder / f"{name}.h5",
         "--resume", "--log", folder / f"{name}.log"],
        check=True,
    )  # fmt: skip


class Result:
    """History of one run in units of YI and R."""

    def __init__(self, file, radius):
        with h5py.File(file) as result:
            self.history = {name: column[:] for name, column in result["history"].items()}
            self.balance = dict(result["balance"].attrs)
            self.commit = result.attrs["git_commit"]
            config = result.attrs["config"]
        modulus = float(re.search(r"youngs_modulus = (\S+)", config).group(1))
        self.energy_unit = modulus * numpy.pi / 4 / radius
        self.density = self.history["packing_density"]
        self.window = 0.01 if radius < 20 else 0.0025

    def energy(self, name, density):
        return numpy.interp(density, self.density, self.history[name]) / self.energy_unit

    def force(self, density):
        """Mean over densities around this one."""
        near = numpy.abs(self.density - density) <= self.window
        return self.history["scaled_force"][near].mean()

    def reaches(self, density):
        return self.density[-1] >= density * (1 - 1e-9)


def spool(density, radius):
    """E R / YI and F R^2 / YI of the inverse-spool model (Purohit et al. 2003)."""
    fullest = 2 * numpy.pi / numpy.sqrt(3) / SPACING**2
    if density >= fullest:
        return "-", "-"
    x = numpy.cbrt(density / fullest)
    energy = 4 * numpy.pi / numpy.sqrt(3) * (radius / SPACING) ** 2 * (numpy.arctanh(x) - x)
    return f"{energy:.2f}", f"{1 / (2 * (1 - x * x)):.2f}"


def energies(results):
    lines = []
    for radius, densities in DENSITIES.items():
        low, high = (results[setup, radius] for setup in SETUPS)
        for density in densities:
            if not (low.reaches(density) and high.reaches(density)):
                continue
            cells = [
                f"{radius}", f"{density:g}",
                f"{low.energy('energy_bend', density):.2f}", f"{low.force(density):.2f}",
                f"{high.energy('energy_bend', density):.2f}",
                f"{high.energy('energy_twist', density):.2f}", f"{high.force(density):.2f}",
                *spool(density, radius),
            ]  # fmt: skip
            lines.append("| " + " | ".join(cells) + " |")
    return lines


def balances(results):
    lines = []
    for setup, radius in RUNS:
        result = results[setup, radius]
        history, balance = result.history, result.balance
        cells = [
            f"{setup}, R = {radius}",
            f"phi = {result.density[-1]:.3f}, F = {history['scaled_force'][-1]:.2f}",
            f"{len(result.density)}", f"{int(history['evaluations'].sum())}",
            *(
                f"{balance[part] / result.energy_unit:.3f}"
                for part in ("work", "energy", "released", "remeshing")
            ),
            f"{100 * balance['residue'] / balance['work']:.2f} %",
        ]  # fmt: skip
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def with_rows(text, header, lines):
    """The page with these rows in the table that starts with the header."""
    start = text.index(header)
    body = text.index("\n", text.index("\n|---", start) + 1) + 1
    end = text.index("\n\n", body)
    return text[:body] + "\n".join(lines) + text[end:]


def draw(folder):
    name = name_of("low", 10)
    subprocess.run(
        [PROGRAM, "figures", folder / f"{name}.h5", "-o", folder / "figures", "--force"], check=True
    )
    shutil.copy(folder / "figures/packing.png", ROOT / "data/figures/packing.png")


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(int(os.environ.get("JOBS", "2"))) as pool:
        list(pool.map(lambda of: run(*of, folder), reversed(RUNS)))
    results = {(s, r): Result(folder / f"{name_of(s, r)}.h5", r) for s, r in RUNS}
    commits = {result.commit for result in results.values()}
    if len(commits) > 1:
        sys.exit(f"{folder}: results of several commits: {', '.join(sorted(commits))}")
    text = PAGE.read_text(encoding="utf-8")
    text = with_rows(text, "| R/a | phi |", energies(results))
    text = with_rows(text, "| run | ends at |", balances(results))
    text = re.sub(r"commit [0-9a-f]{7}", f"commit {commits.pop()[:7]}", text)
    PAGE.write_text(text, encoding="utf-8")
    draw(folder)


if __name__ == "__main__":
    main()
