#!/usr/bin/python3
"""Makes what fuzzing starts from: make_corpus.py SOURCES WIREPACK FOLDER."""

import shutil
import subprocess
import sys
from pathlib import Path

import h5py

POINTS = {
    "table.csv": "x,y,z\n0,0,0\n1,0,0.5\n2,1,1\n",
    "table.txt": "# points\n0 0 0\n1 2 3\n4 5 6\n",
    "markups.json": '{"markups": [{"type": "Curve", "controlPoints": [{"position": [0, 0, 0]}]}]}',
}


def take_checksums(path):
    """Makes a result of format version 2, in which a changed number is not noticed as such."""
    with h5py.File(path, "a") as file:
        file.attrs["format_version"] = 2
        del file["provenance"]
        groups = ["history", "checkpoint", "checkpoint_before"]
        for name in [*groups, *(f"frames/{frame}" for frame in file["frames"])]:
            if name in file:
                del file[name].attrs["checksum"]


def main(sources, program, folder):
    for kind in ("config", "points", "shape", "result"):
        (folder / kind).mkdir(parents=True, exist_ok=True)
    for scenario in (sources / "data/scenarios").glob("*.toml"):
        shutil.copy(scenario, folder / "config")
    for found in (sources / "tests/fuzz/found").glob("*/*"):
        shutil.copy(found, folder / found.parent.name)
    for name, text in POINTS.items():
        (folder / "points" / name).write_text(text)
    (folder / "shape/shape.toml").write_text("[shape]\nk0 = [[0, 0, 0.1, 0], [1, 0, 0.1, 0]]\n")
    config = folder / "small.toml"
    config.write_text(
        "[cavity]\nradius = 4\n[stop]\nincrements = 2\n[friction]\nmodel = 'coulomb'\n"
    )
    for method in ("quasistatic", "dynamic"):
        result = folder / "result" / f"{method}.h5"
        if not result.exists():
            subprocess.run(
                [program, "run", config, "-o", result, "--method", method],
                check=True,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
            shutil.copy(result, folder / "result" / f"{method}_version_2.h5")
            take_checksums(folder / "result" / f"{method}_version_2.h5")


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:4]))
