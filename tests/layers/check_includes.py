#!/usr/bin/env python3
"""Checks that includes go one way, and that libraries stay in the layer that may see them.

    check_includes.py ROOT         checks include/wirepack and src below ROOT
    check_includes.py --self-test  checks this check, with small trees that break each rule

Prints file:line and the broken rule; exit code 0 if all is well, 1 if not, 2 for a bad call.
"""

import re
import sys
import tempfile
from pathlib import Path

BELOW_PACKING = {"core", "rod", "contact", "energy", "feed", "solve", "dynamics", "fit", "observe"}

# Layer -> other layers it may include. A layer may always include itself.
ALLOWED = {
    "core": set(),
    "rod": {"core"},
    "contact": {"core", "rod"},
    "energy": {"core", "rod", "contact"},
    "feed": {"core", "rod", "contact", "energy"},
    "solve": {"core", "rod", "contact", "energy", "feed"},
    "dynamics": {"core", "rod", "contact", "energy", "feed"},
    "fit": {"core", "rod"},
    "observe": {"core", "rod", "contact", "energy", "feed"},
    "packing": BELOW_PACKING,
    "verify": BELOW_PACKING | {"packing"},
    "io": BELOW_PACKING | {"packing", "verify"},
}

# (name, pattern of the included file, the only layer that may include it)
OWNED_LIBRARIES = [
    ("NLopt", re.compile(r"nlopt\b", re.I), "solve"),
    ("METIS", re.compile(r"metis\.h"), "solve"),
    ("Ceres", re.compile(r"ceres/"), "fit"),
    ("HDF5", re.compile(r"(hdf5/|hdf5\w*\.h|H5\w*\.h|highfive/)", re.I), "io"),
    ("toml++", re.compile(r"(toml\+\+/|tomlplusplus/|toml\.h)"), "io"),
]

# Applied to code without comments and string literals. snprintf and an ostream argument are fine.
PRINTING = re.compile(
    r"\b(?:std\s*::\s*)?(?:cout|cerr|clog|stdout|stderr)\b"
    r"|\b(?:v?printf|puts|putchar|perror)\s*\("
    r'|\b(?:fmt|std)\s*::\s*print(?:ln)?\s*\(\s*(?:\w*"|\))'
)

INCLUDE_LINE = re.compile(r"^[ \t]*#[ \t]*include\b(.*)$")
INCLUDE_NAME = re.compile(r'\s*(?:<([^>]+)>|"([^"]+)")')
SUFFIXES = {".hpp", ".h", ".cpp", ".cc", ".ipp", ".inl", ".in"}

TOKEN = re.compile(
    r"""(?P<comment>//(?:\\\n|[^\n])*|/\*.*?(?:\*/|\Z))
      | (?P<raw>(?:u8|[uUL])?R"(?P<mark>[^()\\\s]{0,16})\(.*?\)(?P=mark)")
      | (?P<text>"(?:\\.|[^"\\\n])*")
      | (?P<word>[A-Za-z_]\w*|\d(?:'?[\w.])*)
      | (?P<character>'(?:\\.|[^'\\\n])+')""",
    re.S | re.X,
)


def blank(text, keep=""):
    """Spaces instead of all characters but line ends and those in `keep`."""
    return re.sub(f"[^\n{keep}]", " ", text)


def code_only(text):
    """The text without comments and the inside of literals, with all lines where they were."""

    def replace(match):
        if match.lastgroup == "word":
            return match.group()
        if match["comment"] is not None:
            return blank(match.group())
        return blank(match.group(), keep="\"'")

    return TOKEN.sub(replace, text)


def layer_of_path(parts):
    """The layer of a path below the root, given as parts, or None."""
    if parts[:2] == ("include", "wirepack") and len(parts) > 3:
        return parts[2]
    if parts[:1] == ("src",) and len(parts) > 2:
        return parts[1]
    return None


def target_layer(root, file, name, quoted):
    """Layer of an included file; "" if the file is of another project; None if of no layer."""
    if name.startswith("wirepack/"):
        parts = Path(name).parts
        return parts[1] if len(parts) > 2 and ".." not in parts else None
    if quoted or "../" in name:
        for folder in (file.parent, root / "src", root / "include" / "wirepack"):
            candidate = (folder / name).resolve()
            if candidate.is_file() and candidate.is_relative_to(root):
                return layer_of_path(candidate.relative_to(root).parts)
    return ""


def check_include(root, file, layer, name, quoted):
    """The rules that one include breaks, in words."""
    for library, pattern, owner in OWNED_LIBRARIES:
        if pattern.match(name) and layer != owner:
            yield f"only the layer '{owner}' may include {library} ({name})"
    target = target_layer(root, file, name, quoted)
    if target is None or (target and target not in ALLOWED):
        yield f"'{name}' is in no known layer"
    elif target and target != layer and target not in ALLOWED[layer]:
        yield f"layer '{layer}' may not include layer '{target}' ({name})"


def check(root):
    """Returns the violations as lines, and the number of wirepack includes that were read."""
    root = Path(root).resolve()
    violations = []
    count = 0
    folders = [root / "include", root / "src"]
    files = sorted(f for d in folders if d.is_dir() for f in d.rglob("*") if f.suffix in SUFFIXES)
    for file in files:
        relative = file.relative_to(root)
        layer = layer_of_path(relative.parts)
        if layer not in ALLOWED:
            violations.append(f"{relative}:1: the file is in no known layer")
            continue
        text = file.read_text(encoding="utf-8")
        code = code_only(text)
        for number, (line, bare) in enumerate(zip(text.split("\n"), code.split("\n")), start=1):
            where = f"{relative}:{number}"
            if INCLUDE_LINE.match(bare):
                name = INCLUDE_NAME.search(line, line.index("include") + len("include"))
                if name is None:
                    violations.append(f"{where}: the included name cannot be read")
                    continue
                path = name[1] or name[2]
                count += path.startswith("wirepack/")
                for rule in check_include(root, file, layer, path, quoted=name[2] is not None):
                    violations.append(f"{where}: {rule}")
            else:
                found = PRINTING.search(bare)
                if found:
                    what = found.group().strip(' ("')
                    violations.append(f"{where}: the library never prints ({what})")
    if count == 0:
        violations.append("no include of a wirepack header was found, so nothing was checked")
    return violations, count


GOOD_TREE = {
    "include/wirepack/core/types.hpp": "#pragma once\n#include <Eigen/Core>\n",
    "include/wirepack/rod/rod.hpp": '#include "wirepack/core/types.hpp"\n',
    "src/rod/rod.cpp": '#include "wirepack/rod/rod.hpp"\n'
    '// std::cout << 1; printf("x"); #include "wirepack/io/x.hpp"\n'
    "/* text\n#include <nlopt.h>\n*/\n"
    'const char* script = R"(\nprintf("%d");\n#include "wirepack/io/x.hpp"\n)";\n'
    "const int n = 1'000; const char c = '\"'; int fprint; // std::cerr\n"
    'int k = std::snprintf(buffer, 3, "stdout");\n',
    "src/solve/minimizer.cpp": "#include <nlopt.h>\n#include <wirepack/feed/feeder.hpp>\n",
    "src/fit/fit.cpp": "#include <ceres/ceres.h>\n",
    "src/io/handle.hpp": "#include <hdf5.h>\n#include <toml++/toml.h>\n",
    "src/io/recorder.cpp": '#include "handle.hpp"\n#include "wirepack/packing/frame.hpp"\n'
    '#include "wirepack/verify/problem.hpp"\n',
    "src/verify/problem.cpp": '#include "wirepack/packing/frame.hpp"\n',
}

# (file, contents, line, part of the message)
BAD_FILES = [
    (
        "src/core/a.cpp",
        '\n#include "wirepack/rod/rod.hpp"\n',
        2,
        "'core' may not include layer 'rod'",
    ),
    ("src/core/a.cpp", '/* x */ #  include  "wirepack/rod/rod.hpp"', 1, "may not include"),
    ("include/wirepack/solve/a.hpp", "#include <wirepack/dynamics/b.hpp>", 1, "may not include"),
    ("include/wirepack/observe/a.hpp", '#include "wirepack/solve/b.hpp"', 1, "may not include"),
    ("src/fit/a.cpp", '#include "wirepack/contact/b.hpp"', 1, "may not include"),
    ("src/packing/a.cpp", '#include "wirepack/io/b.hpp"', 1, "may not include"),
    ("src/packing/a.cpp", '#include "wirepack/verify/b.hpp"', 1, "may not include"),
    ("src/verify/a.cpp", '#include "wirepack/io/b.hpp"', 1, "may not include"),
    ("src/solve/a.cpp", '#include "../io/handle.hpp"', 1, "may not include layer 'io'"),
    ("src/solve/a.cpp", '#include "io/handle.hpp"', 1, "may not include layer 'io'"),
    ("src/rod/a.cpp", '#include "wirepack/util/b.hpp"', 1, "no known layer"),
    ("src/rod/a.cpp", '#include "wirepack/b.hpp"', 1, "no known layer"),
    ("src/util/a.cpp", "int a;", 1, "no known layer"),
    ("src/a.cpp", "int a;", 1, "no known layer"),
    ("src/fit/a.cpp", "#include <nlopt.hpp>", 1, "NLopt"),
    ("src/solve/a.cpp", '#include "ceres/ceres.h"', 1, "Ceres"),
    ("src/packing/a.cpp", "#include <hdf5.h>", 1, "HDF5"),
    ("src/packing/a.cpp", "#include <H5Cpp.h>", 1, "HDF5"),
    ("src/packing/a.cpp", "#include <hdf5/serial/hdf5.h>", 1, "HDF5"),
    ("src/packing/a.cpp", "#include <toml++/toml.hpp>", 1, "toml++"),
    ("src/rod/a.cpp", 'void f() {\n  std::cout << "x";\n}', 2, "never prints"),
    ("src/rod/a.cpp", "using std::cerr;", 1, "never prints"),
    ("src/rod/a.cpp", 'const int n = 1\'000; printf("x");', 1, "never prints"),
    ("src/rod/a.cpp", 'std::fprintf(stderr, "x");', 1, "never prints"),
    ("src/io/a.cpp", 'fmt::print("x");', 1, "never prints"),
]


def write_tree(root, files):
    for name, contents in files.items():
        path = Path(root) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(contents, encoding="utf-8")


def self_test():
    """Returns what the check does wrong, as lines."""
    failures = []

    def run(files):
        with tempfile.TemporaryDirectory() as root:
            write_tree(root, files)
            return check(root)

    violations, count = run(GOOD_TREE)
    if violations:
        failures.append(f"a good tree is refused: {violations}")
    if count != 6:
        failures.append(f"a good tree has 6 includes, not {count}")
    for name, contents, line, message in BAD_FILES:
        violations, _ = run({**GOOD_TREE, name: contents})
        good = (
            len(violations) == 1
            and violations[0].startswith(f"{name}:{line}: ")
            and message in violations[0]
        )
        if not good:
            failures.append(f"{name} with {contents!r} gives {violations}")
    for files in ({}, {"src/rod/a.cpp": "int a;\n"}):
        violations, _ = run(files)
        if not violations:
            failures.append(f"a tree without includes passes: {files}")
    # Every pair of layers must be decided as the table says, so no row can be dead.
    for source, allowed in ALLOWED.items():
        for target in ALLOWED:
            violations, _ = run({f"src/{source}/a.cpp": f'#include "wirepack/{target}/b.hpp"\n'})
            if bool(violations) == (target == source or target in allowed):
                failures.append(f"{source} -> {target} is decided wrongly")
    # The table itself must have no circle.
    for layer in ALLOWED:
        for target in ALLOWED[layer]:
            if layer in ALLOWED[target]:
                failures.append(f"layers {layer} and {target} may include each other")
    return failures


def main(arguments):
    if len(arguments) != 1 or (arguments[0].startswith("-") and arguments[0] != "--self-test"):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    if arguments[0] == "--self-test":
        failures = self_test()
        for line in failures:
            print(line, file=sys.stderr)
        if not failures:
            print(f"all {len(BAD_FILES)} bad files are refused, and the good tree is not")
        return 1 if failures else 0
    violations, count = check(arguments[0])
    for line in violations:
        print(line, file=sys.stderr)
    if not violations:
        print(f"{count} includes of wirepack headers go the right way")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
