#!/usr/bin/env python3
"""The scenes of examples/: they render, and look as they did when somebody last looked at them.

Small pictures of them lie in tests/gallery. They are durer's own: what is right is proved
elsewhere, against POV-Ray; here a change that moves a published picture must be a decision.

Commands: `check [FILTER…]` renders and compares (exit 1 if a picture is another), and tests that
the animation closes: clock 1 is clock 0 again. `update [FILTER…]` takes new pictures.
"""

import argparse
import sys
from pathlib import Path

import pictures
import png
import programs

EXAMPLES = programs.ROOT / "examples"
KEPT = programs.ROOT / "tests" / "gallery"
OPTIONS = ["+W160", "+H120", "-A", "-D"]
CYCLIC = ["bloom"]
BY_PATHS = {"lantern": ["Integrator=path", "Path_Samples=64"]}  # scenes that have no other light
LEAST = 40.0  # dB; rounding of other processors and compilers moves single pixels at edges
LIMIT = 120.0  # seconds


def render(scene: Path, options: list[str]) -> png.Picture:
    result = programs.render_with_durer(scene, OPTIONS + BY_PATHS.get(scene.stem, []) + options, LIMIT)
    if result.picture is None:
        raise RuntimeError(f"{result.error}\n{result.run.err}")
    return result.picture


def compare(made: png.Picture, expected: png.Picture, what: str) -> None:
    decibels = pictures.psnr(made, expected)
    if decibels < LEAST:
        raise RuntimeError(f"{pictures.text(decibels)} dB to {what}, wanted {LEAST:g}")


def check(scene: Path) -> None:
    """Raises RuntimeError if the scene fails or looks different."""
    made = render(scene, [])
    kept = KEPT / f"{scene.stem}.png"
    if not kept.exists():
        raise RuntimeError("no picture in tests/gallery; look at it, then `tools/gallery.py update`")
    compare(made, png.read(kept), f"{kept.name}, as kept")
    if scene.stem in CYCLIC:
        compare(render(scene, ["+K1"]), made, "its own first frame")


def update(scene: Path) -> None:
    (KEPT / f"{scene.stem}.png").write_bytes(png.encode(render(scene, [])))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=["check", "update"])
    parser.add_argument("filter", nargs="*")
    args = parser.parse_args()
    failures = 0
    for scene in sorted(EXAMPLES.glob("*.scene")):
        if args.filter and not any(word in scene.stem for word in args.filter):
            continue
        try:
            (check if args.command == "check" else update)(scene)
        except RuntimeError as problem:
            print(f"{scene}: {problem}", file=sys.stderr)
            failures += 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
