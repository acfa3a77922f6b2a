#!/usr/bin/python3
"""Frames and history of a result file, with nothing but h5py: read_frames.py RESULT.h5"""

import sys

import h5py
import numpy


def curvature(position):
    """Curvature at the inner nodes of a chain: 2 tan(angle / 2) over the mean of its edges."""
    edges = numpy.diff(position, axis=0)
    length = numpy.linalg.norm(edges, axis=1)
    tangents = edges / length[:, None]
    cosine = numpy.sum(tangents[1:] * tangents[:-1], axis=1)
    tangent_of_half = numpy.sqrt((1 - cosine).clip(0) / (1 + cosine))
    return 2 * tangent_of_half / ((length[1:] + length[:-1]) / 2)


def main(path):
    with h5py.File(path, "r") as file:
        history = {name: column[()] for name, column in file["history"].items()}
        print(f"{len(history['force'])} increments, stopped by {file.attrs['stop_reason']}")
        print("     phi     F R^2/YI  nodes  contacts  largest curvature")
        for frame in file["frames"].values():
            row = numpy.searchsorted(history["increment"], frame.attrs["increment"])
            position = frame["position"][()]
            print(
                f"{frame.attrs['packing_density']:8.4f} {history['scaled_force'][row]:12.4f}"
                f" {len(position):6d} {len(frame['contact_pairs']):9d}"
                f" {curvature(position).max(initial=0):18.4f}"
            )


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
