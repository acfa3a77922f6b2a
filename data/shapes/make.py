#!/usr/bin/env python3
"""Makes the sample points of this folder: python3 make.py

Points measured on the centreline of a wire, synthetic, with normal scatter in each coordinate; the
seeds are fixed, so the files come out the same. Lengths are in wire radii.
"""

import math
import random
from pathlib import Path

FOLDER = Path(__file__).parent


def turned(point, angle):
    """A turn about x, so that no axis of a sample is one of the coordinates."""
    x, y, z = point
    c, s = math.cos(angle), math.sin(angle)
    return (x, c * y - s * z, s * y + c * z)


def write(name, what, points, scatter, seed, shuffle=False):
    source = random.Random(seed)
    lines = []
    for point in points:
        measured = [v + source.gauss(0, scatter) for v in turned(point, 0.6)]
        lines.append(",".join(f"{v:.5f}" for v in measured))
    if shuffle:
        source.shuffle(lines)
    header = f"# {what}; scatter {scatter} in each coordinate\nx,y,z\n"
    (FOLDER / name).write_text(header + "\n".join(lines) + "\n")


def circle(radius, first, last, count):
    for i in range(count):
        a = first + (last - first) * i / (count - 1)
        yield (radius * math.cos(a), radius * math.sin(a), 0)


def helix(radius, pitch, turns, count):
    for i in range(count):
        a = 2 * math.pi * turns * i / (count - 1)
        yield (radius * math.cos(a), radius * math.sin(a), pitch * a / (2 * math.pi))


def coil(length, count):
    """A flat-wound coil whose radius grows from 3 to 5 half-way, by integrating its curvature."""
    steps = 100 * count
    x = y = z = angle = 0.0
    for i in range(steps + 1):
        if i % 100 == 0:
            yield (x, y, z)
        s = length * (i + 0.5) / steps
        share = 0.5 * (1 + math.tanh((s - length / 2) / (0.05 * length)))
        radius = 3 + 2 * share
        angle += length / steps / radius
        rise = 0.08
        run = math.sqrt(1 - rise * rise)
        x += length / steps * run * math.cos(angle)
        y += length / steps * run * math.sin(angle)
        z += length / steps * rise


if __name__ == "__main__":
    write("circle.csv", "A third of a circle of radius 20, in no order",
          circle(20, 0.3, 0.3 + 2 * math.pi / 3, 120), 0.05, 1, shuffle=True)
    write("helix.csv", "Right-handed helix of radius 3 and pitch 4, five turns",
          helix(3, 4, 5, 300), 0.03, 2)
    write("coil.csv", "Coil whose radius grows from 3 to 5 half-way", coil(120, 400), 0.03, 3)
