#!/usr/bin/python3
"""data/docs/configuration.md lists every key with the default and the range that the program has.

Meaning and unit of a key are written in the page; the rest is asked of the program: keys from what
it says about an unknown one, defaults from --dry-run, ranges from its messages about impossible
values.
WIREPACK=build/wirepack configuration_page_test.py --write brings the page up to date.
"""

import os
import re
import subprocess
import sys
import unittest
from pathlib import Path
from tempfile import TemporaryDirectory

PROGRAM = os.environ.get("WIREPACK", "wirepack")
PAGE = Path(__file__).parents[2] / "data/docs/configuration.md"
HEADER = ["key", "meaning", "unit", "default", "allowed"]
OF_NO_TYPE = "1979-05-27"  # no key takes a date
WRONG_NUMBERS = ["-1", "1e-18", "1000000000000000000"]
# What is allowed elsewhere depends on these, so their keys are asked about one at a time.
FELT_ELSEWHERE = ["wire", "cavity", "dynamics"]
# Others than the default, and how the page names them.
VARIANTS = {
    "high torsion": {"packing.setup": "high_torsion"},
    "in time": {"packing.method": "dynamic"},
    "compact": {"minimizer.method": "compact_lbfgs"},
}


def dry_run(settings=None):
    """What --dry-run prints and what it complains about, for a sphere of radius 10."""
    with TemporaryDirectory() as folder:
        config = Path(folder) / "c.toml"
        config.write_text("[cavity]\nradius = 10\n")
        words = [
            word for key, value in (settings or {}).items() for word in ("--set", f"{key}={value}")
        ]
        done = subprocess.run(
            [PROGRAM, "run", str(config), "--dry-run", *words],
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
        )
    return done.stdout, done.stderr


def sections():
    """Keys of each section, in the order of the program."""
    names = re.findall(r"\[(\w+)\]", dry_run({"nosuchsection.x": 1})[1].split("there are", 1)[1])
    found = {}
    for name in names:
        message = dry_run({f"{name}.nosuchkeyatall": 1})[1]
        found[name] = message.split(f"[{name}] has", 1)[1].strip().split(", ")
    return found


def values(settings=None):
    found, section = {}, ""
    for line in dry_run(settings)[0].splitlines():
        if line.startswith("["):
            section = line.strip("[]")
        elif " = " in line and not line.startswith("#"):
            key, value = line.split(" = ", 1)
            found[f"{section}.{key}"] = value.strip()
    return found


def complaints(keys, value, settings=None):
    """What the program says that each key must be; nothing for those that may be the value."""
    found = {}
    for line in dry_run({**(settings or {}), **dict.fromkeys(keys, value)})[1].splitlines():
        message = re.search(r": (\w+\.\w+) = [^:]*: (.*)", line)
        # sizes are for every number with a unit: they are in units.md
        if message and message[1] in keys and not message[2].startswith("its size"):
            text = re.sub("^must (not )?be ", r"\1", message[2].split(": vibrations")[0])
            found.setdefault(message[1], text.replace("|", "\\|"))
    return found


def ranges(sections, settings=None):
    """What is allowed for each key: its type, or the limits that wrong numbers go beyond."""
    types = {}
    for section, names in sections.items():
        types |= complaints([f"{section}.{name}" for name in names], OF_NO_TYPE, settings)
    numbers = [
        key for key, kind in types.items() if re.match("an? (finite number|number|integer)", kind)
    ]
    batches = {}
    for key in numbers:
        section = key.split(".")[0]
        place = [k for k in numbers if k.startswith(section + ".")].index(key)
        batches.setdefault((section in FELT_ELSEWHERE and section, place), []).append(key)
    limits = {key: {} for key in types}
    for batch in batches.values():
        for value in WRONG_NUMBERS:
            for key, limit in complaints(batch, value, settings).items():
                if not re.fullmatch("an integer( from -.*)?", limit):  # that is the type
                    limits[key][limit] = None
    return {key: "; ".join(limits[key]) or kind for key, kind in types.items()}


def shown(value):
    """Numbers with six digits."""
    return f"`{float(value):.6g}`" if re.fullmatch(r"-?[\d.]+(e-?\d+)?", value) else f"`{value}`"


def default(key, plain, variants):
    text = shown(plain[key]) if key in plain else "-"
    for name, found in variants.items():
        if found.get(key) != plain.get(key) and key not in VARIANTS[name]:
            text += f"; {name} {shown(found[key]) if key in found else '-'}"
    return text


def rows_of(page):
    """Cells of the rows of the page, by section.key."""
    found, section = {}, ""
    for line in page.splitlines():
        heading = re.fullmatch(r"## \[(\w+)\]", line)
        section = heading[1] if heading else section
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if len(cells) == len(HEADER) and cells[0].startswith("`"):
            found[f"{section}.{cells[0].strip('`')}"] = cells
    return found


def line_of(cells):
    return "| " + " | ".join(cells) + " |"


def tables(page):
    """The page's tables as they should be, by section."""
    written = rows_of(page)
    plain = values()
    variants = {name: values(settings) for name, settings in VARIANTS.items()}
    known = sections()
    allowed = ranges(known)
    allowed_in = {name: ranges(known, settings) for name, settings in VARIANTS.items()}
    result = {}
    for section, names in known.items():
        lines = [line_of(HEADER), "|" + "---|" * len(HEADER)]
        for name in names:
            key = f"{section}.{name}"
            _, meaning, unit, *_ = written.get(key, ["", "", ""])
            values_of = default(key, plain, variants)
            limits = allowed[key]
            for variant, found in allowed_in.items():
                if found[key] != allowed[key] and key not in VARIANTS[variant]:
                    limits += f"; {variant} {found[key]}"
            lines.append(line_of([f"`{name}`", meaning, unit, values_of, limits]))
        result[section] = "\n".join(lines)
    return result


def current(page):
    for section, table in tables(page).items():
        heading = f"## [{section}]\n\n"
        if heading not in page:
            page = page.rstrip() + "\n\n" + heading
        head, tail = page.split(heading, 1)
        old = re.match(r"(\|.*\n?)*", tail)[0]
        page = head + heading + table + "\n" + tail[len(old) :]
    return page


class ConfigurationPage(unittest.TestCase):
    maxDiff = None

    def test_the_page_has_the_keys_defaults_and_ranges_of_the_program(self):
        page = PAGE.read_text()
        self.assertEqual(page, current(page), f"run {Path(__file__).name} --write")

    def test_every_key_has_a_meaning_and_a_unit(self):
        for key, (_, meaning, unit, _, _) in rows_of(PAGE.read_text()).items():
            self.assertTrue(meaning and unit, key)


if __name__ == "__main__":
    if "--write" in sys.argv:
        PAGE.write_text(current(PAGE.read_text()))
    else:
        unittest.main()
