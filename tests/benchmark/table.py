#!/usr/bin/env python3
"""Prints results of Google Benchmark as one Markdown table, beside the numbers of references.csv.

    table.py RESULT.json...

A ratio is reference / measured: above 1 wirepack is faster, or needs less. What an edge of wire
costs (edge_cost) is a table of its own, with the power of the number of nodes that fits it; what
threads bring (edges_by_threads) is a line.
"""

import csv
import json
import math
import re
import sys
from pathlib import Path

SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
# Written by Google Benchmark for every result; what is left are the counters.
STANDARD = {
    "name", "run_name", "run_type", "family_index", "per_family_instance_index", "repetitions",
    "repetition_index", "threads", "iterations", "real_time", "cpu_time", "time_unit", "label",
    "aggregate_name", "aggregate_unit", "error_occurred", "error_message",
}  # fmt: skip
# How a benchmark was run, which Google Benchmark adds to its name.
NAME_SUFFIX = re.compile(r"(/(iterations:\d+|process_time|manual_time))+$")
# Values that are checked, not competed in.
CHECKED = {"energy", "middle_height"}


def read_results(path):
    """Benchmark -> measures, of one file; the median where there are repetitions."""
    results = {}
    for entry in json.loads(Path(path).read_text(encoding="utf-8"))["benchmarks"]:
        if entry.get("aggregate_name", "median") != "median":
            continue
        name = NAME_SUFFIX.sub("", entry["run_name"])
        if entry.get("error_occurred"):
            results[name] = {"error": entry["error_message"]}
            continue
        measures = {k: v for k, v in entry.items() if k not in STANDARD}
        manual = entry["run_name"].endswith("/manual_time")
        measures["seconds"] = (
            entry["real_time" if manual else "cpu_time"] * SECONDS[entry["time_unit"]]
        )
        measures["label"] = entry.get("label", "")
        results[name] = measures
    return results


def read_references():
    """Benchmark -> rows of references.csv."""
    references = {}
    with open(Path(__file__).with_name("references.csv"), encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            references.setdefault(row["benchmark"], []).append(row)
    return references


def readable_seconds(seconds):
    for unit, scale in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= scale:
            return f"{seconds / scale:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def readable(measure, value):
    if measure == "seconds":
        return readable_seconds(value)
    if measure in CHECKED:
        return f"{value:.9g}"
    return f"{value:.0f}" if value >= 1000 else f"{value:.3g}"


def readable_ratio(ratio):
    return f"{ratio:.0f}x" if ratio >= 10 else f"{ratio:.2g}x"


def compared(row, measures):
    measured = measures[row["measure"]]
    value = float(row["value"])
    kind = "" if row["measure"] == "seconds" else row["measure"].replace("_", " ") + " "
    text = f"{row['what']}: {kind}{readable(row['measure'], value)}"
    if row["measure"] in CHECKED:
        return f"{text} (off by {abs(measured / value - 1):.0e})"
    return f"{text} (**{readable_ratio(value / measured)}**)"


EDGE_COST = re.compile(r"edge_cost/radius:(\d+)/phi_permille:(\d+)$")


def fitted_power(points):
    """Least squares slope of log y by log x."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    middle_x = sum(x for x, _ in logs) / len(logs)
    middle_y = sum(y for _, y in logs) / len(logs)
    return sum((x - middle_x) * (y - middle_y) for x, y in logs) / sum(
        (x - middle_x) ** 2 for x, _ in logs
    )


def print_edge_costs(costs):
    """costs: (radius, density, measures) in the order they were measured."""
    print("| R/a | phi | nodes | increments | evaluations | factorizations | CPU time |")
    print("|---|---|---|---|---|---|---|")
    points = {}
    for radius, density, m in costs:
        points.setdefault(radius, []).append((m["nodes"], m["ms_per_edge"]))
        print(
            f"| {radius} | {density:g} | {m['nodes']:.0f} | {m['increments_per_edge']:.2f} "
            f"| {m['evaluations_per_edge']:.0f} | {m['factorizations_per_edge']:.1f} "
            f"| {m['ms_per_edge']:.3g} ms |"
        )
    powers = [
        f"{fitted_power(of_radius):.2f} at R = {radius}"
        for radius, of_radius in points.items()
        if len(of_radius) > 1
    ]
    print()
    if powers:
        print(
            "Per edge of wire fed. CPU time grows with this power of the nodes: "
            + ", ".join(powers)
        )
        print()


THREADS = re.compile(r"edges_by_threads/threads:(\d+)$")


def print_thread_gains(times):
    """times: number of threads -> seconds of the clock."""
    gains = [f"{times[1] / t:.2f} times as fast by {n}" for n, t in sorted(times.items()) if n > 1]
    if 1 in times and gains:
        print(
            "The same increments by threads: "
            + ", ".join(gains)
            + " as by one (seconds of the clock)"
        )
        print()


def main(paths):
    if not paths:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    references = read_references()
    results = {name: m for path in paths for name, m in read_results(path).items()}
    costs = [
        (int(found[1]), int(found[2]) / 1000, results.pop(name))
        for name in list(results)
        if (found := EDGE_COST.fullmatch(name)) and "error" not in results[name]
    ]
    if costs:
        print_edge_costs(costs)
    print_thread_gains(
        {
            int(found[1]): results.pop(name)["seconds"]
            for name in list(results)
            if (found := THREADS.fullmatch(name)) and "error" not in results[name]
        }
    )
    if not results:
        return 0
    print("| benchmark | CPU time | measures | compared with |")
    print("|---|---|---|---|")
    sources = {}
    for name, measures in results.items():
        if "error" in measures:
            print(f"| {name} | - | {measures['error']} | |")
            continue
        others = [
            f"{key.replace('_', ' ')} {readable(key, value)}"
            for key, value in sorted(measures.items())
            if key not in ("seconds", "label")
        ]
        rows = [compared(row, measures) for row in references.get(name, [])]
        for row in references.get(name, []):
            sources[row["what"], row["source"]] = None
        print(
            f"| {name} | {readable_seconds(measures['seconds'])} | {', '.join(others)} "
            f"| {', '.join(rows)} |"
        )
    print()
    print("Compared with, on the machine of the prototype:")
    for what, source in sources:
        print(f"- {what}: {source}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
