#!/usr/bin/env python3
"""Random scenes, rendered by POV-Ray and by durer: the pictures must be alike.

    tools/random_scenes.py --count 200            numbers 0 to 199
    tools/random_scenes.py --seed 17 --show       the text of one scene

Whatever is below `match` is listed, and kept with both pictures in build/random. Not every difference is a
fault of durer: POV-Ray misses parts of `sor`, and surfaces that coincide hide one another by chance.
"""

import argparse
import sys
from pathlib import Path

import pictures
import png
import programs
from generators import scenes

FOLDER = programs.ROOT / "build" / "random"
OPTIONS = ["+W96", "+H72", "-A", "-D"]
LIMIT = 20.0  # seconds; scenes that take POV-Ray longer are passed over


def compare(seed: int) -> str:
    """What is to be said about a scene; empty if nothing is."""
    scene = FOLDER / f"{seed}.pov"
    scene.write_text(scenes.scene(seed), encoding="utf-8")
    oracle = programs.render_with_oracle(scene, [*OPTIONS, "-GA"], LIMIT)
    durer = programs.render_with_durer(scene, OPTIONS, LIMIT)
    if oracle.picture is None and not oracle.run.timed_out and durer.picture is not None:
        return f"only POV-Ray fails: {oracle.error}"
    if oracle.picture is None:
        return ""
    if durer.picture is None:
        return f"only durer fails: {durer.error}"
    decibels = pictures.psnr(oracle.picture, durer.picture)
    if pictures.class_of(decibels) in ("exact", "match"):
        scene.unlink()
        return ""
    for name, picture in (("oracle", oracle.picture), ("durer", durer.picture)):
        (FOLDER / f"{seed}.{name}.png").write_bytes(png.encode(picture))
    return f"{pictures.text(decibels)} dB"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=0, help="number of the first scene")
    parser.add_argument("--count", type=int, default=100, help="how many scenes")
    parser.add_argument("--show", action="store_true", help="print the first scene and end")
    args = parser.parse_args()
    if args.show:
        print(scenes.scene(args.seed), end="")
        return 0
    if programs.oracle_path() is None:
        print(programs.HOW_TO_INSTALL_ORACLE, file=sys.stderr)
        return programs.SKIPPED
    FOLDER.mkdir(parents=True, exist_ok=True)
    told = 0
    for seed in range(args.seed, args.seed + args.count):
        if text := compare(seed):
            told += 1
            print(f"{Path(FOLDER / str(seed)).relative_to(programs.ROOT)}.pov: {text}", flush=True)
    print(f"{args.count} scenes, {told} to look at")
    return 1 if told else 0


if __name__ == "__main__":
    sys.exit(main())
