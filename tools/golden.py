#!/usr/bin/env python3
"""Golden pictures: small scenes of our own beside the pictures that POV-Ray makes of them.

The first line of every scene in tests/golden says how to render and how alike the pictures must be:

    // golden: +W96 +H72 -A; psnr >= 50; why this much

Commands: `check SCENE…` renders with durer and compares (exit 1 if a picture differs too much; both
pictures and their difference go to build/golden), `regenerate [FILTER…]` makes the pictures with
POV-Ray, `list` prints what every scene asks for.
"""

import argparse
import re
import sys
from dataclasses import dataclass
from pathlib import Path

import pictures
import png
import programs

FOLDER = programs.ROOT / "tests" / "golden"
FAILED = programs.ROOT / "build" / "golden"
LIMIT = 60.0  # seconds
HEADER = re.compile(r"// golden: (?P<options>[^;]+); psnr >= (?P<least>[\d.]+); (?P<reason>\S.*)")


@dataclass(frozen=True)
class Golden:
    scene: Path
    options: list[str]
    least: float  # dB
    reason: str

    @property
    def picture(self) -> Path:
        return self.scene.with_suffix(".png")


def load(scene: Path) -> Golden:
    """What the first line of a scene asks for; exits if it says nothing."""
    with open(scene, encoding="utf-8") as text:
        found = HEADER.match(text.readline())
    if not found:
        sys.exit(f"{scene}:1: expected `// golden: OPTIONS; psnr >= DB; REASON`")
    return Golden(scene, [*found["options"].split(), "-D"], float(found["least"]), found["reason"].strip())


def regenerate(golden: Golden) -> str:
    """Makes the picture with the oracle; returns what went wrong, or nothing."""
    result = programs.render_with_oracle(golden.scene, golden.options, LIMIT)
    if result.picture is None:
        return f"{result.error}\n{result.run.err[-2000:]}"
    if not golden.picture.exists() or png.read(golden.picture) != result.picture:
        golden.picture.write_bytes(png.encode(result.picture))
    return ""


def check(golden: Golden) -> str:
    """Compares durer's picture with the golden one; returns what is wrong, or nothing."""
    result = programs.render_with_durer(golden.scene, golden.options, LIMIT)
    if result.picture is None:
        return f"{result.error}\n{result.run.err}"
    expected = png.read(golden.picture)
    if (result.picture.width, result.picture.height) != (expected.width, expected.height):
        return f"{result.picture.width}x{result.picture.height} pixels"
    decibels = pictures.psnr(result.picture, expected)
    if decibels >= golden.least:
        print(f"{golden.scene.name}: {pictures.text(decibels)} dB (wanted {golden.least:g})")
        return ""
    _keep(golden, expected, result.picture)
    return (f"{pictures.text(decibels)} dB, wanted {golden.least:g} ({golden.reason}); "
            f"see {FAILED / golden.scene.stem}.*.png")


def _keep(golden: Golden, expected: png.Picture, made: png.Picture) -> None:
    FAILED.mkdir(parents=True, exist_ok=True)
    parts = {"expected": expected, "durer": made, "difference": pictures.difference(expected, made)}
    for part, picture in parts.items():
        (FAILED / f"{golden.scene.stem}.{part}.png").write_bytes(png.encode(picture))


def scenes(filters: list[str]) -> list[Path]:
    found = sorted(FOLDER.glob("*.pov"))
    return [scene for scene in found if not filters or any(word in scene.stem for word in filters)]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("check").add_argument("scene", nargs="+", type=Path)
    commands.add_parser("regenerate").add_argument("filter", nargs="*")
    commands.add_parser("list").add_argument("filter", nargs="*")
    args = parser.parse_args()
    if args.command == "list":
        for golden in map(load, scenes(args.filter)):
            print(f"{golden.scene.stem:<28} {golden.least:>4g}  {' '.join(golden.options):<24}  {golden.reason}")
        return 0
    if args.command == "regenerate" and not programs.oracle_path():
        print(f"golden: POV-Ray is not installed; {programs.HOW_TO_INSTALL_ORACLE}", file=sys.stderr)
        return 2
    work, chosen = (check, args.scene) if args.command == "check" else (regenerate, scenes(args.filter))
    failures = 0
    if args.command == "check":
        missing = {scene: need for scene in chosen if (need := programs.missing_need(scene))}
        for scene, need in missing.items():
            print(f"{scene.name}: skipped, {need} is not installed; {programs.HOW_TO_INSTALL_ORACLE}")
        if len(missing) == len(chosen):
            return programs.SKIPPED
        chosen = [scene for scene in chosen if scene not in missing]
    for golden in map(load, chosen):
        if problem := work(golden):
            print(f"{golden.scene}: {problem}", file=sys.stderr)
            failures += 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
