#!/usr/bin/python3
"""Makes what fuzzing starts from: make_corpus.py SOURCES WIREPACK FOLDER."""

import shutil
import subprocess
import sys
from pathlib import Path

POINTS = {
    "table.csv": "x,y,z\n0,0,0\n1,0,0.5\n2,1,1\n",
    "table.txt": "# points\n0 0 0\n1 2 3\n4 5 6\n",
    "markups.json": '{"markups": [{"type": "Curve", "controlPoints": [{"position": [0, 0, 0]}]}]}',
}


def main(sources, program, folder):
    for kind in ("config", "points", "shape", "result"):
        (folder / kind).mkdir(parents=True, exist_ok=True)
    for scenario in (sources / "data/scenarios").glob("*.toml"):
        shutil.copy(scenario, folder / "config")
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
            )


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:4]))
