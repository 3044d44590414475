#!/usr/bin/env python3
"""Asks POV-Ray for values of every pattern on a cloud of points and writes pattern_values.def.

Usage: regenerate_patterns.py [povray]     (run in this folder)
"""
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

# Durer's name, operands in the order of its Params, the oracle's words.
PATTERNS = [
    ("checker", [], "checker"),
    ("hexagon", [], "hexagon"),
    ("brick", [8, 3, 4.5, 0.5], "brick"),
    ("brick", [2, 1.5, 3, 0.3], "brick brick_size <2,1.5,3> mortar 0.3"),
    ("gradient", [1, 0, 0], "gradient x"),
    ("gradient", [1, 2, -0.5], "gradient <1,2,-.5>"),
    ("leopard", [], "leopard"),
    ("onion", [], "onion"),
    ("radial", [], "radial"),
    ("planar", [], "planar"),
    ("boxed", [], "boxed"),
    ("cylindrical", [], "cylindrical"),
    ("spherical", [], "spherical"),
    ("cubic", [], "cubic"),
    ("bozo", [], "bozo"),
    ("spotted", [], "spotted"),
    ("bumps", [], "bumps"),
    ("cells", [], "cells"),
    ("dents", [], "dents"),
    ("granite", [], "granite"),
    ("wrinkles", [], "wrinkles"),
    ("agate", [], "agate"),
    ("agate", [0.6], "agate agate_turb 0.6"),
    ("marble", [], "marble"),
    ("wood", [], "wood"),
    ("ripples", [], "ripples"),
    ("waves", [], "waves"),
    ("spiral1", [3], "spiral1 3"),
    ("spiral2", [5], "spiral2 5"),
    ("quilted", [], "quilted"),
    ("quilted", [0.3, 0.8], "quilted control0 0.3 control1 0.8"),
    ("crackle", [], "crackle"),
    ("crackle", [1, -1, 1, 0, 2, 2, 2, 0], "crackle solid"),
    ("crackle", [0, 0.5, -0.25, 0.4, 1, 1, 1, 0], "crackle form <.5,-.25,.4> metric 1"),
    ("crackle", [0, 1, 0, 0, 3.5, 3.5, 3.5, 0.25], "crackle form x metric 3.5 offset .25"),
    ("mandel", [30, 2, 1, 1, 0, 1], "mandel 30"),
    ("mandel", [20, 3, 1, 1, 1, 0.5], "mandel 20 exponent 3 interior 1, .5"),
    ("mandel", [20, 4, 2, 0.1, 6, 1], "mandel 20 exponent 4 exterior 2, .1 interior 6, 1"),
    ("mandel", [20, 6, 6, 0.1, 5, 0.7], "mandel 20 exponent 6 exterior 6, .1 interior 5, .7"),
    ("julia", [-0.3, 0.6, 30, 2, 1, 1, 1, 1], "julia <-.3,.6>, 30 interior 1, 1"),
    ("julia", [0.1, 0.5, 20, 7, 1, 1, 2, 0.3], "julia <.1,.5>, 20 exponent 7 interior 2, .3"),
    ("magnet", [1, 0, 0, 0, 30, 1, 1, 1, 0.5], "magnet 1 mandel 30 interior 1, .5"),
    ("magnet", [2, 0, 0, 0, 30, 1, 1, 4, 0.5], "magnet 2 mandel 30 interior 4, .5"),
    ("magnet", [1, 1, 0.3, 0.6, 30, 1, 1, 3, 0.5], "magnet 1 julia <.3,.6>, 30 interior 3, .5"),
    ("magnet", [2, 1, 0.3, -0.6, 30, 6, 0.001, 0, 0.5], "magnet 2 julia <.3,-.6>, 30 exterior 6, .001 interior 0, .5"),
    # Not allowed as pattern functions; pigments whose red tells the entry.
    ("square", [], 4),
    ("triangular", [], 6),
]


def points():
    rng = random.Random(7)
    cloud = [tuple(round(rng.uniform(-s, s), 6) for _ in range(3)) for s in [1] * 10 + [3] * 10 + [15] * 10]
    lattice = [(0, 0, 0), (1, 0, 0), (-1, 2, 0), (0, 0.5, -0.5), (-3, -3, -3), (2, 0, -5.25), (0, -1, 0.75)]
    near = [(1e-11, 1, -1e-11), (-1e-9, 0.25, 0), (0.0005, 3, 0.0009)]
    return cloud + lattice + near


def scene():
    lines = ["#version 3.7;", "global_settings{assumed_gamma 1}"]
    for k, (name, _, words) in enumerate(PATTERNS):
        if isinstance(words, int):
            entries = " ".join(f"rgb {i}" for i in range(words))
            lines.append(f"#declare F{k} = function {{ pigment {{ {name} {entries} }} }}")
        else:
            lines.append(f"#declare F{k} = function {{ pattern {{ {words} }} }}")
        member = ".red" if isinstance(words, int) else ""
        for p in points():
            at = ",".join(repr(c) for c in p)
            lines.append(f'#debug concat("V {k} ", str(F{k}({at}){member},0,15), "\\n")')
    return "\n".join(lines) + "\n"


def main():
    povray = sys.argv[1] if len(sys.argv) > 1 else "povray"
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "patterns.pov"
        path.write_text(scene())
        run = subprocess.run([povray, f"+I{path}", "-F", "+W1", "+H1", "-D"], capture_output=True, text=True)
    values = re.findall(r"^V (\d+) (\S+)$", run.stderr, re.M)
    assert len(values) == len(PATTERNS) * len(points()), run.stderr[-2000:]
    rows = iter(values)
    out = ["// Pattern values of POV-Ray 3.7, written by regenerate_patterns.py. Columns: pattern, operands,",
           "// x, y, z, value.", "// clang-format off"]
    for name, args, _ in PATTERNS:
        for p in points():
            operands = ", ".join(str(float(a)) for a in args)
            at = ", ".join(repr(float(c)) for c in p)
            out.append(f'DURER_PATTERN_VALUE("{name}", ({{{operands}}}), {at}, {next(rows)[1]})')
    out.append("// clang-format on")
    Path("pattern_values.def").write_text("\n".join(out) + "\n")


if __name__ == "__main__":
    main()
