#!/usr/bin/env python3
"""Times durer and POV-Ray on the scenes of bench/, in turn, and prints medians and ratios.

Wall time is that of the whole process, from start to end: starting up, reading the scene, building,
rendering, writing the picture. The first line of a scene says how to render it:

    // bench: +W640 +H480 -A; what it measures

A second line `// input: NAME` asks for a file that is too large to keep; it is written into build/bench.
The pictures are compared too, so that speed is never bought with another picture.
"""

import argparse
import math
import re
import statistics
import sys
from dataclasses import dataclass
from pathlib import Path

import bench_inputs
import pictures
import programs

FOLDER = programs.ROOT / "bench"
INPUT = re.compile(r"// input: (?P<name>\S+)")
HEADER = re.compile(r"// bench: (?P<options>[^;]+); (?P<subject>\S.*)")
LIMIT = 600.0  # seconds


@dataclass(frozen=True)
class Timing:
    """Medians over the runs of one program; seconds and MiB."""

    wall: float
    cpu: float
    peak: float


def load(scene: Path) -> tuple[list[str], str]:
    """The options of a benchmark scene and what it measures; provides its inputs."""
    with open(scene, encoding="utf-8") as text:
        found = HEADER.match(text.readline())
        wanted = INPUT.match(text.readline())
    if not found:
        sys.exit(f"{scene}:1: expected `// bench: OPTIONS; SUBJECT`")
    options = [*found["options"].split(), "-D"]
    if wanted:
        bench_inputs.provide(wanted["name"])
        options.append(f"+L{bench_inputs.FOLDER}")
    return options, found["subject"].strip()


def median(runs: list[programs.Run]) -> Timing:
    return Timing(*(statistics.median(getattr(run, part) for run in runs) for part in ("wall", "cpu", "peak")))


def measure(scene: Path, options: list[str], count: int) -> tuple[Timing, Timing, float] | str:
    """Oracle's and durer's medians and how alike the pictures are, or what went wrong."""
    turns = (("the oracle", programs.render_with_oracle, []), ("durer", programs.render_with_durer, []))
    last = {}
    for _ in range(count):
        for name, render, runs in turns:
            result = render(scene, options, LIMIT)
            if result.picture is None:
                return f"{name}: {result.error}"
            runs.append(result.run)
            last[name] = result.picture
    (_, _, oracle), (_, _, durer) = turns
    return median(oracle), median(durer), pictures.psnr(last["the oracle"], last["durer"])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("filter", nargs="*", help="part of a scene's name")
    parser.add_argument("--runs", type=int, default=3, metavar="N", help="of each program per scene (default 3)")
    args = parser.parse_args()
    if not programs.oracle_path():
        print(f"bench: POV-Ray is not installed; {programs.HOW_TO_INSTALL_ORACLE}", file=sys.stderr)
        return 2
    scenes = sorted(path for path in FOLDER.glob("*.pov")
                    if not args.filter or any(word in path.stem for word in args.filter))
    if not scenes:
        print("bench: no scene fits the filter", file=sys.stderr)
        return 2
    return report(scenes, max(1, args.runs))


def report(scenes: list[Path], count: int) -> int:
    print(f"{'':<14}|{'wall s':^27}|{'CPU s':^27}|{'peak MiB':^15}|")
    columns = f"{'oracle':>9} {'durer':>8} {'ratio':>7} |"
    print(f"{'scene':<14}|{columns}{columns}{'oracle':>8} {'durer':>6}| {'dB':>5}  what")
    ratios, failures = [], 0
    for scene in scenes:
        options, subject = load(scene)
        found = measure(scene, options, count)
        if isinstance(found, str):
            print(f"{scene.stem:<14}| {found}", flush=True)
            failures += 1
            continue
        oracle, durer, decibels = found
        ratios.append(oracle.wall / durer.wall)
        print(f"{scene.stem:<14}|{_pair(oracle.wall, durer.wall)}{_pair(oracle.cpu, durer.cpu)}"
              f"{oracle.peak:8.0f} {durer.peak:6.0f}| {pictures.text(decibels):>5}  {subject}", flush=True)
    if ratios:
        mean = math.exp(statistics.fmean(map(math.log, ratios)))
        print(f"\n{len(ratios)} scenes, medians of {count} runs: durer is {mean:.1f} times as fast "
              f"(geometric mean of the wall times), from {min(ratios):.1f} to {max(ratios):.1f}")
    return 1 if failures else 0


def _pair(oracle: float, durer: float) -> str:
    return f"{oracle:9.2f} {durer:8.2f} {oracle / max(durer, 1e-3):7.1f} |"


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
