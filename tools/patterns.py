#!/usr/bin/env python3
"""Values of patterns beside the oracle's, point by point.

tests/patterns/values.tsv has a line for every pattern, wave, warp and modifier: how it is written,
and what POV-Ray makes of it at the points of `points()`.

Commands: `check` asks durer, prints the largest difference of each line (exit 1 if one is beyond
TOLERANCE), `regenerate` asks POV-Ray for all of them anew.
"""

import argparse
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import programs

DATA = programs.ROOT / "tests" / "patterns" / "values.tsv"
TOLERANCE = 1e-5
LIMIT = 300.0  # seconds


def points():
    """Where patterns are asked: inside of the unit cube, around it, farther away, on the lattice."""
    rng = random.Random(11)
    cloud = [tuple(round(rng.uniform(low, high), 5) for _ in range(3))
             for low, high, count in [(0, 1, 8), (-2, 2, 8), (-12, 12, 8)] for _ in range(count)]
    return cloud + [(0.5, 0.25, 0.75), (-1.5, 0.5, 2.5)]


WAVES = ["ramp_wave", "sine_wave", "triangle_wave", "scallop_wave", "cubic_wave", "poly_wave 2.5"]
PLAIN = ["agate", "agate agate_turb .4", "boxed", "bozo", "bumps", "spotted", "cells", "checker", "cubic", "hexagon",
         "brick", "brick brick_size <1,.5,.7> mortar .1", "cylindrical", "dents", "granite", "leopard", "marble", "onion",
         "planar", "quilted", "quilted control0 .4 control1 .2", "radial", "ripples", "spherical", "waves", "wood",
         "wrinkles", "gradient y", "gradient <1,-2,.5>", "spiral1 4", "spiral2 3",
         "crackle", "crackle solid", "crackle form <1,0,0> metric 1", "crackle form <.5,-.2,.7> metric 3 offset .2",
         "mandel 40", "mandel 25 exponent 3 exterior 2,.2 interior 1,2", "julia <.3,.5>, 30 interior 1,1",
         "julia <-.6,.4>, 20 exponent 4 interior 3,1", "magnet 1 mandel 25 interior 1,.5",
         "magnet 2 julia <.4,.3>, 25 interior 6,.1",
         "function { x*y + sin(z) }", "pigment_pattern { bozo color_map { [0 rgb 0] [1 rgb <1,.5,.2>] } scale .7 }",
         "object { sphere { <.3,.4,.5>, .6 } }", "object { difference { box { -1, 1 } cylinder { -2*y, 2*y, .7 } } }"]
IMAGE = "function 7, 5 { pattern { granite scale 3 } }"
PICTURES = [f"image_pattern {{ {IMAGE} {options} }}"
            for options in ["", "once", "interpolate 2", "interpolate 3", "interpolate 4", "map_type 1", "map_type 2 interpolate 2",
                            "map_type 5 interpolate 3", "repeat <2.5,1.5> offset <.3,-.4>", "once offset <.3,.2>"]]
VOXELS = [f'density_file df3 "{bits}.df3" interpolate {n}' for bits in (8, 16, 32) for n in (0, 1, 2)]
TURBULENT = [f"{p} turbulence <.4,.7,-.3> octaves 4 omega .6 lambda 2.3"
             for p in ("bozo", "marble", "wood", "agate", "spiral1 3", "spiral2 2", "granite", "crackle", "gradient z")]
GENERATORS = [f"{p} noise_generator {g}" for p in ("bozo", "granite", "wrinkles", "dents", "agate", "marble turbulence 1")
              for g in (1, 3)]
MODIFIED = ([f"onion frequency 2.5 phase .3 {w}" for w in WAVES] + [f"bozo {w} frequency 3" for w in WAVES] +
            ["gradient x frequency -2", "gradient x frequency 0 phase .3", "wood triangle_wave scale .3 rotate 30*z",
             "waves frequency 3 phase .2", "ripples frequency 2.5 phase .7"])
WARPS = [f"{p} {t}" for p in ("gradient x", "bozo") for t in
         ["warp { repeat x*.7 offset <0,.3,.1> flip y }", "warp { repeat -1.3*z flip <1,0,1> }", "warp { turbulence .5 octaves 3 }",
          "warp { black_hole <.3,.2,.4>, 1.5 strength .7 falloff 1.5 }", "warp { black_hole 0, 2 inverse strength 1.4 }",
          "warp { black_hole <.5,.5,.5>, .45 repeat <1,1.2,1.5> turbulence <.1,.2,.1> }",
          "warp { cylindrical }", "warp { cylindrical orientation y dist_exp .5 }", "warp { spherical }",
          "warp { spherical orientation <1,1,0> dist_exp 1 }", "warp { toroidal major_radius 1.3 }",
          "warp { toroidal orientation x dist_exp 1 }", "warp { planar }", "warp { planar <1,1,0>, .3 }",
          "scale 2 warp { turbulence .4 } rotate <10,20,30> warp { repeat 1.5*y } translate <.1,.2,.3> turbulence .2"]]
WARPS += ["checker warp { cubic }"]
BLOCKS = [("square", 4), ("triangular", 6)]
TILINGS = [f"tiling {n}" for n in range(1, 28)]


def pavements():
    counts = {3: [1, 1, 1, 3, 4, 12], 4: [1, 1, 2, 5, 12, 35], 6: [1, 1, 3, 7, 22]}
    k = 0
    for sides, patterns in counts.items():
        for tiles, count in enumerate(patterns, 1):
            for pattern in range(1, count + 1):
                k += 1
                yield (f"pavement number_of_sides {sides} number_of_tiles {tiles} pattern {pattern} "
                       f"exterior {k % 3} interior {k // 3 % 3} form {k // 2 % (4 if sides == 4 else 3)}")


def rows():
    """How each line is asked: its words, and the function that gives its value."""
    for words in PLAIN + PICTURES + VOXELS + TURBULENT + GENERATORS + MODIFIED + WARPS:
        yield words, f"pattern {{ {words} }}", ""
    for name, count in BLOCKS:
        yield name, f"pigment {{ {name} {' '.join(f'rgb {i}' for i in range(count))} }}", ".red"
    for words in [*TILINGS, *pavements()]:
        yield words, f"pigment {{ {words} color_map {{ [0 rgb 0] [1 rgb 1] }} }}", ".red"


def scene() -> str:
    lines = ["#version 3.7;", "global_settings { assumed_gamma 1 }"]
    for k, (_, body, member) in enumerate(rows()):
        lines.append(f"#declare F{k} = function {{ {body} }}")
        for x, y, z in points():
            lines.append(f'#debug concat("V {k} ", str(F{k}({x},{y},{z}){member},0,9), "\\n")')
    return "\n".join(lines) + "\ncamera { location -z }\nsphere { 0, .1 }\n"


def write_voxels(folder: Path) -> None:
    """Density files of 5x4x3 samples, as wide as their names say."""
    rng = random.Random(3)
    for bits in (8, 16, 32):
        samples = b"".join(rng.randrange(1 << bits).to_bytes(bits // 8, "big") for _ in range(60))
        sizes = b"".join(n.to_bytes(2, "big") for n in (5, 4, 3))
        (folder / f"{bits}.df3").write_bytes(sizes + samples)


def ask(program: str) -> list[list[float]]:
    """What a renderer makes of every line; exits if it does not get through."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write_voxels(folder)
        (folder / "patterns.pov").write_text(scene())
        command = [program, "+Ipatterns.pov", "+Opatterns.png", "+W2", "+H2", "-D"]
        run = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=LIMIT, errors="replace", check=False)
    found = re.findall(r"V (\d+) (\S+)", run.stdout + run.stderr)
    values: list[list[float]] = [[] for _ in rows()]
    for k, text in found:
        values[int(k)].append(float(text))
    if any(len(v) != len(points()) for v in values):
        sys.exit(f"{program} did not get through:\n{run.stderr[-2000:]}")
    return values


def regenerate() -> None:
    lines = ["# Written by tools/patterns.py: a pattern as the language has it, then POV-Ray's values at its points."]
    for (words, _, _), values in zip(rows(), ask("povray")):
        lines.append(words + "\t" + " ".join(f"{v:.9g}" for v in values))
    DATA.parent.mkdir(exist_ok=True)
    DATA.write_text("\n".join(lines) + "\n", encoding="utf-8")


def load() -> dict[str, list[float]]:
    stored = {}
    for line in DATA.read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            words, numbers = line.split("\t")
            stored[words] = [float(n) for n in numbers.split()]
    return stored


def check(program: str) -> int:
    stored = load()
    failures = 0
    for (words, _, _), values in zip(rows(), ask(program)):
        largest = max(abs(a - b) for a, b in zip(stored[words], values, strict=True))
        good = largest <= TOLERANCE
        failures += not good
        print(f"{largest:9.2e} {'' if good else 'DIFFERS':8} {words}")
    return 1 if failures else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=["check", "regenerate"])
    parser.add_argument("--durer", default=str(programs.ROOT / "build" / "release" / "cli" / "durer"))
    options = parser.parse_args()
    if options.command == "regenerate":
        regenerate()
        return 0
    return check(options.durer)


if __name__ == "__main__":
    sys.exit(main())
