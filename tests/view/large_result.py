#!/usr/bin/env python3
"""Makes a result of 40 frames and up to 40,000 nodes, of a wire that no run has found: hoops that
precess on shells of a sphere of 40 wire radii, every node shaken by 0.01 a.

    large_result.py PROGRAM OUT.h5          a wire that grows from frame to frame
    large_result.py PROGRAM OUT.h5 --full   40,000 nodes in every frame
"""

import subprocess
import sys
from pathlib import Path

import h5py
import numpy

CONFIG = """
[cavity]
radius = 40
[stop]
increments = 40
[output]
checkpoint_every_seconds = 0
frame_every_density = 1e-7
"""
FRAMES, NODES, EDGE = 40, 40000, 2.0


def wire(n, phase, generator):
    """Nodes 2 a apart on hoops whose axes wander, from the outermost shell inwards."""
    turn = numpy.arange(n) * EDGE
    radius = 38.5 - 2 * numpy.floor(turn / 6500)
    smooth = numpy.convolve(numpy.pad(radius, 50, "edge"), numpy.ones(101) / 101, "valid")
    angle = numpy.cumsum(EDGE / smooth)
    axis = 0.033 * angle + phase
    x = smooth * numpy.cos(angle)
    y = smooth * numpy.sin(angle)
    points = numpy.stack([x * numpy.cos(axis), x * numpy.sin(axis), y], axis=1)
    return points + 0.01 * generator.uniform(-1, 1, points.shape)


def fill(frame, points, generator):
    n = len(points)
    for dataset in list(frame):
        del frame[dataset]
    frame["position"] = points
    frame["quaternion"] = numpy.tile([1.0, 0, 0, 0], (n - 1, 1))
    wave = numpy.sin(numpy.arange(n) / 17)
    frame["bend_energy"] = 0.002 * numpy.exp(wave + 0.1 * generator.standard_normal(n))
    frame["twist_energy"] = 0.001 * numpy.exp(wave)
    touches = generator.uniform(size=n) < 0.3
    frame["wall_force"] = numpy.where(touches, 1e-4 * generator.exponential(size=n), 0)
    first = numpy.sort(generator.integers(0, n // 2, n // 3))
    frame["contact_pairs"] = numpy.stack([first, first + n // 2 - 2], axis=1)
    frame["contact_force"] = 1e-4 * generator.exponential(size=len(first))


def main(program, out, full):
    config = out.with_suffix(".toml")
    config.write_text(CONFIG)
    subprocess.run(
        [program, "run", config, "-o", out, "--force"], check=True, stdout=subprocess.DEVNULL
    )
    generator = numpy.random.default_rng(1)
    with h5py.File(out, "r+") as file:
        names = sorted(file["frames"])[-FRAMES:]
        for k, name in enumerate(names):
            file["frames"][name].attrs.pop("checksum", None)  # of what was there
            n = NODES if full else NODES * (k + 1) // len(names)
            fill(file["frames"][name], wire(n, 0.01 * k, generator), generator)


if __name__ == "__main__":
    if len(sys.argv) < 3 or sys.argv[3:] not in ([], ["--full"]):
        sys.exit(__doc__)
    main(sys.argv[1], Path(sys.argv[2]), full=len(sys.argv) > 3)
