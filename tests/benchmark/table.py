#!/usr/bin/env python3
"""Prints results of Google Benchmark as one Markdown table, beside the numbers of references.csv.

    table.py RESULT.json...

A ratio is reference / measured: above 1 wirepack is faster, or needs less.
"""

import csv
import json
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
NAME_SUFFIX = re.compile(r"(/(iterations:\d+|process_time))+$")
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
        measures["seconds"] = entry["cpu_time"] * SECONDS[entry["time_unit"]]
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


def main(paths):
    if not paths:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    references = read_references()
    print("| benchmark | CPU time | measures | compared with |")
    print("|---|---|---|---|")
    sources = {}
    for path in paths:
        for name, measures in read_results(path).items():
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
