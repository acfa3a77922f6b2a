#!/usr/bin/env python3
"""Makes result files whose pages have known answers.

    make_results.py PROGRAM FOLDER

small.h5 is a real run; the others are that run with frames or texts of our own.
"""

import math
import shutil
import subprocess
import sys
from pathlib import Path

import h5py
import numpy

CONFIG = """
[cavity]
radius = 10
[stop]
increments = 90
[output]
checkpoint_every_seconds = 0
frame_every_density = 0.003
"""
HOSTILE = (
    "</script><script>document.documentElement.dataset.hurt = 1</script>"
    "<img src=x onerror=alert(1)>\"'&"
)


def replace_frames(path, frames):
    """Puts centrelines (N x 3) in the place of the last frames, and removes the others."""
    with h5py.File(path, "r+") as file:
        names = sorted(file["frames"])
        for name in names[: len(names) - len(frames)]:
            del file["frames"][name]
        for name, points in zip(sorted(file["frames"]), frames):
            frame = file["frames"][name]
            n = len(points)
            frame.attrs.pop("checksum", None)  # of what was there
            for dataset in list(frame):
                del frame[dataset]
            frame["position"] = points
            frame["quaternion"] = numpy.tile([1.0, 0, 0, 0], (n - 1, 1))
            # a colour ramp of two decades, so that cut faces have known colours
            length = numpy.linalg.norm(numpy.diff(points, axis=0), axis=1)
            node_length = (numpy.append(length, 0) + numpy.append(0, length)) / 2
            frame["bend_energy"] = node_length * numpy.logspace(-1, 1, n)
            frame["twist_energy"] = numpy.zeros(n)
            frame["wall_force"] = numpy.zeros(n)
            frame["contact_pairs"] = numpy.zeros((0, 2), "i8")
            frame["contact_force"] = numpy.zeros(0)


def copy_with(source, target, change):
    shutil.copy(source, target)
    change(target)


def circle(radius, n=360):
    angle = numpy.linspace(0, 2 * math.pi, n + 1)
    return radius * numpy.stack([numpy.cos(angle), numpy.zeros(n + 1), numpy.sin(angle)], axis=1)


def set_attributes(path, **texts):
    """In a file of format version 2, which has no checksum of them."""
    with h5py.File(path, "r+") as file:
        del file["provenance"]
        file.attrs["format_version"] = 2
        for name, text in texts.items():
            del file.attrs[name]
            file.attrs[name] = text


def make_hostile(path):
    with h5py.File(path, "r") as file:
        config = file.attrs["config"]
    config = config.decode() if isinstance(config, bytes) else config
    set_attributes(path, config=config + "\n# " + HOSTILE + "\n", command_line=HOSTILE)


def main(program, folder):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "small.toml").write_text(CONFIG)
    small = folder / "small.h5"
    subprocess.run(
        [program, "run", folder / "small.toml", "-o", small, "--force"],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    straight = numpy.stack([numpy.zeros(41), numpy.linspace(-6, 6, 41), numpy.zeros(41)], axis=1)
    tilted = straight @ numpy.array([[0.8, 0.6, 0], [-0.6, 0.8, 0], [0, 0, 1]])
    ring = circle(6)
    copy_with(small, folder / "straight.h5", lambda path: replace_frames(path, [straight, tilted]))
    copy_with(small, folder / "ring.h5", lambda path: replace_frames(path, [ring]))
    copy_with(small, folder / "no_frames.h5", lambda path: replace_frames(path, []))
    copy_with(small, folder / "hostile.h5", make_hostile)
    for name in ("small", "straight", "ring"):
        make_page(program, folder / f"{name}.h5", folder / f"{name}.html")
    hostile = folder / "<img src=x onerror=alert(1)>.h5"
    shutil.copy(folder / "hostile.h5", hostile)
    make_page(program, hostile, folder / "hostile.html")


def make_page(program, result, page):
    subprocess.run(
        [program, "view", result, "-o", page, "--force"], check=True, stdout=subprocess.DEVNULL
    )


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], Path(sys.argv[2]))
