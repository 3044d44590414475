#!/usr/bin/env python3
"""Renders the scenes of Debian's povray-examples with durer and with POV-Ray and compares the pictures.

The oracle's pictures are kept in $DURER_ORACLE_CACHE (default: ~/.cache/durer/oracle), each with a
log whose last line is `rc=<exit code> time=<seconds>`, so each scene is rendered by the oracle once.

Exit codes: 0 no scene got worse than the baseline, 1 some did or durer crashed, 2 wrong usage,
77 the oracle or its examples are not installed.
"""

import argparse
import fnmatch
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import pictures
import png
import programs
import report

OPTIONS = ["+W160", "+H120", "-A", "-D"]
ORACLE_LIMIT, DURER_LIMIT = 300.0, 60.0  # seconds
BASELINE = programs.ROOT / "tests" / "examples" / "baseline.tsv"
ORACLE_FAILS = "the oracle fails"
RANK = {"exact": 4, "match": 3, "near": 2, "wrong": 1, "fail": 0}
CLASSES = [*RANK, ORACLE_FAILS]
NOT_YET = "D0220"  # the code of what durer cannot do yet


@dataclass(frozen=True)
class Row:
    """One scene's verdict. Times in seconds; `psnr` is None where there is nothing to compare."""

    scene: str
    kind: str  # one of CLASSES
    psnr: float | None
    note: str
    oracle_time: float
    durer_time: float
    crashed: bool = False
    oracle: png.Picture | None = None
    durer: png.Picture | None = None


# ---- scenes and the oracle's pictures ----------------------------------------------------------

def packaged_files() -> dict[str, Path]:
    """Every file of the examples' folder, by its path below it; empty if they are not installed."""
    try:
        listing = subprocess.run(["dpkg", "-L", "povray-examples"], capture_output=True, check=False)
    except FileNotFoundError:
        return {}
    paths = [Path(os.fsdecode(line)) for line in listing.stdout.splitlines()]
    scenes = [path.parent for path in paths if path.suffix == ".pov"]
    if not scenes:
        return {}
    top = Path(os.path.commonpath(scenes))
    return {str(path.relative_to(top)): path for path in sorted(paths)
            if path.is_relative_to(top) and path.is_file()}


class Workplace:
    """A copy of the examples for each program, made when first needed and removed at the end.

    Some scenes write files beside themselves, and others read those. In a copy they need no rights,
    leave nothing behind, and do not see what the other program wrote.
    """

    def __init__(self) -> None:
        self.files = packaged_files()
        self.scenes = [name for name in self.files if name.endswith(".pov")]
        self._folder = tempfile.TemporaryDirectory(prefix="durer-")
        self._lock = threading.Lock()

    def __enter__(self) -> "Workplace":
        return self

    def __exit__(self, *_: object) -> None:
        self._folder.cleanup()

    def scene(self, program: str, name: str) -> Path:
        """Where `program` finds the scene."""
        top = Path(self._folder.name) / program
        with self._lock:
            if not top.exists():
                for file, source in self.files.items():
                    target = top / file
                    target.parent.mkdir(parents=True, exist_ok=True)
                    shutil.copyfile(source, target)
        return top / name


def cache_folder() -> Path:
    home = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    return Path(os.environ.get("DURER_ORACLE_CACHE") or home / "durer" / "oracle")


def oracle_picture(name: str, place: Workplace) -> tuple[png.Picture | None, str, float]:
    """The oracle's picture of a scene, what it says if it makes none, and its time in seconds."""
    picture = (cache_folder() / name).with_suffix(".png")
    log = picture.with_name(picture.name + ".log")
    known = _read_cached(picture, log)
    if known:
        return known
    result = programs.render_with_oracle(place.scene("oracle", name), OPTIONS, ORACLE_LIMIT)
    picture.parent.mkdir(parents=True, exist_ok=True)
    if result.picture:
        _replace(picture, png.encode(result.picture))
    code = 0 if result.picture else 124 if result.run.timed_out else result.run.code or 1
    _replace(log, f"{result.run.err}\nrc={code} time={result.run.wall:.6f}\n".encode())
    return result.picture, result.error, result.run.wall


def _read_cached(picture: Path, log: Path) -> tuple[png.Picture | None, str, float] | None:
    if not log.exists():
        return None
    text = log.read_text("utf-8", "replace")
    last = re.search(r"^rc=(-?\d+) time=([\d.]+)\s*\Z", text, re.MULTILINE)
    if not last:
        return None
    code, seconds = int(last[1]), float(last[2])
    if code == 0:
        return (png.read(picture), "", seconds) if picture.exists() else None
    error = f"timed out after {ORACLE_LIMIT:g} s" if code == 124 else programs.first_error(_without_banner(text))
    return None, error, seconds


def _without_banner(log: str) -> str:
    """The oracle's log without the greeting that precedes the first stage."""
    return log[max(log.find("[Parsing"), 0):]


def _replace(path: Path, data: bytes) -> None:
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    part.write_bytes(data)
    part.replace(path)


# ---- verdicts ----------------------------------------------------------------------------------

@dataclass(frozen=True)
class Library:
    """Which standard includes durer reads."""

    options: tuple[str, ...] = ()
    before: tuple[str, ...] = ()  # words before the command


def library_of(name: str) -> Library:
    """`ours`; `oracle`: POV-Ray's, since the folders of +L come first; `alone`: ours, and nothing of POV-Ray's
    packages can be seen, their fonts and pictures neither."""
    if name == "oracle":
        return Library(options=(f"+L{programs.INCLUDES}",))
    return Library(before=programs.without_oracle()) if name == "alone" else Library()


def judge(name: str, place: Workplace, library: Library) -> Row:
    """Renders one scene with both programs and compares."""
    expected, oracle_error, oracle_time = oracle_picture(name, place)
    result = programs.render_with_durer(place.scene("durer", name), [*OPTIONS, *library.options], DURER_LIMIT,
                                        library.before)
    made, crashed = result.picture, result.run.code < 0 and not result.run.timed_out

    def row(kind: str, note: str = "", decibels: float | None = None) -> Row:
        return Row(name, kind, decibels, note, oracle_time, result.run.wall, crashed, expected, made)

    if expected is None:
        return row(ORACLE_FAILS, f"{oracle_error}; durer: {result.error or 'renders it'}")
    if made is None:
        return row("fail", result.error)
    if (made.width, made.height) != (expected.width, expected.height):
        return row("wrong", f"{made.width}x{made.height} pixels")
    decibels = pictures.psnr(made, expected)
    return row(pictures.class_of(decibels), "", decibels)


def read_baseline(path: Path) -> dict[str, tuple[str, str]]:
    """Scene → (class, PSNR as text)."""
    if not path.exists():
        return {}
    rows = (line.split("\t") for line in path.read_text("utf-8").splitlines() if line and line[0] != "#")
    return {scene: (kind, decibels) for scene, kind, decibels in rows}


def write_baseline(path: Path, rows: list[Row], known: dict[str, tuple[str, str]]) -> None:
    """Writes what is known, with `rows` in place of their older verdicts."""
    merged = known | {row.scene: (row.kind, _decibels(row)) for row in rows}
    lines = ["# scene, class, PSNR in dB; `make conformance-baseline` writes this file"]
    lines += ["\t".join((scene, *merged[scene])) for scene in sorted(merged)]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n", "utf-8")


def changes(rows: list[Row], baseline: dict[str, tuple[str, str]], worse: bool) -> list[str]:
    """What got worse, or better, than the baseline; one line each."""
    found = []
    for row in rows:
        before = baseline.get(row.scene, ("", ""))[0]
        if before in RANK and row.kind in RANK:
            step = RANK[row.kind] - RANK[before]
            if (step < 0) if worse else (step > 0):
                found.append(f"{row.scene}: {before} → {row.kind} {row.note}".rstrip())
    return found


# ---- output ------------------------------------------------------------------------------------

def _decibels(row: Row) -> str:
    return "-" if row.psnr is None else pictures.text(row.psnr)


def line_of(row: Row, width: int) -> str:
    return (f"{row.scene:<{width}}  {row.kind:<16} {_decibels(row):>5}  "
            f"{row.oracle_time:8.2f}  {row.durer_time:8.2f}  {row.note}").rstrip()


def summary(rows: list[Row]) -> str:
    count = Counter(row.kind for row in rows)
    crashes = sum(row.crashed for row in rows)
    parts = [f"{count[kind]} {kind}" + (f" ({crashes} crashed)" if kind == "fail" and crashes else "")
             for kind in CLASSES]
    both = [row for row in rows if row.psnr is not None]
    oracle, durer = sum(row.oracle_time for row in both), sum(row.durer_time for row in both)
    ratio = f", {oracle / durer:.1f} times as fast" if durer > 0 else ""
    return (f"{len(rows)} scenes: {', '.join(parts)}; "
            f"the {len(both)} that both render: oracle {oracle:.1f} s, durer {durer:.1f} s{ratio}")


def choose(scenes: list[str], filters: list[str], listed: Path | None) -> list[str]:
    """The scenes that a list file names (all without one) and that some filter fits: part of the name,
    or a pattern with * and ?."""
    chosen = scenes
    if listed:
        lines = (line.split("#")[0].strip() for line in listed.read_text("utf-8").splitlines())
        names = [line for line in lines if line]
        unknown = [name for name in names if name not in scenes]
        if unknown:
            sys.exit(f"conformance: {listed} names scenes that are not installed: {', '.join(unknown)}")
        chosen = names
    if filters:
        chosen = [name for name in chosen if any(_fits(name, word) for word in filters)]
    return chosen


def _fits(name: str, word: str) -> bool:
    return fnmatch.fnmatch(name, word) if any(mark in word for mark in "*?[") else word in name


def options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("filter", nargs="*", help="part of a scene's path, or a pattern with * and ?")
    parser.add_argument("--list", type=Path, metavar="FILE", help="only the scenes that this file names")
    parser.add_argument("--jobs", type=int, default=1, metavar="N",
                        help="scenes at a time (default 1; more make the times meaningless)")
    parser.add_argument("--html", type=Path, metavar="FOLDER", help="write a page with all pictures there")
    parser.add_argument("--baseline", type=Path, default=BASELINE, metavar="FILE")
    parser.add_argument("--update-baseline", action="store_true", help="take these verdicts as the new baseline")
    parser.add_argument("--stdlib", choices=["ours", "oracle", "alone"], default="ours",
                        help="whose standard includes durer reads; alone: ours, with POV-Ray's packages hidden")
    parser.add_argument("--check", action="store_true", help="interpret only, and tell what refused scenes lack")
    parser.add_argument("--oracle-only", action="store_true", help="only fill the cache of the oracle's pictures")
    return parser.parse_args()


def main() -> int:
    args = options()
    with Workplace() as place:
        if not programs.oracle_path() or not place.scenes:
            print("SKIPPED: the comparison with the oracle did not run, because POV-Ray or its example "
                  f"scenes are not installed; {programs.HOW_TO_INSTALL_ORACLE}")
            return programs.SKIPPED
        scenes = choose(place.scenes, args.filter, args.list)
        if not scenes:
            print("conformance: no scene fits the filter", file=sys.stderr)
            return 2
        if args.oracle_only:
            return fill_cache(scenes, place)
        if not programs.durer_path().exists():
            print(f"conformance: {programs.durer_path()} is not built: `make build`", file=sys.stderr)
            return 2
        if args.stdlib == "alone" and not programs.without_oracle():
            print(f"SKIPPED: {programs.CANNOT_HIDE_ORACLE}")
            return programs.SKIPPED
        return check(scenes, place, args) if args.check else compare(scenes, place, args)


def reasons(done: programs.Run) -> list[str]:
    """Why a scene is refused: the features that are not there yet, else everything that was said."""
    if done.timed_out:
        return ["timed out"]
    if done.code < 0:
        return [f"crashed (signal {-done.code})"]
    found = re.findall(r"error\[(D\d+)\]: (.*)", done.err) or [("", programs.first_error(done.err))]
    missing = [re.sub(r" is not supported yet.*", "", text) for code, text in found if code == NOT_YET]
    return sorted(set(missing)) if len(missing) == len(found) else [f"{code}: {text}" for code, text in found]


def check(scenes: list[str], place: Workplace, args: argparse.Namespace) -> int:
    """Interprets the scenes without rendering: what each refused one lacks, and how many lack it."""
    library = library_of(args.stdlib)

    def interpret(name: str) -> programs.Run:
        scene = place.scene("durer", name)
        command = [*library.before, str(programs.durer_path()), "check", *library.options, scene.name]
        return programs.run(command, scene.parent, DURER_LIMIT)

    known = read_baseline(BASELINE)
    counts: Counter[str] = Counter()
    refused, wrong = 0, []
    with ThreadPoolExecutor(max(1, args.jobs)) as pool:
        for name, done in zip(scenes, pool.map(interpret, scenes)):
            if done.code == 0:
                continue
            refused += 1
            why = reasons(done)
            counts.update(why)
            bad_for_both = name in known and known[name][0] == ORACLE_FAILS
            features = NOT_YET in done.err and not re.search(rf"error\[(?!{NOT_YET})", done.err)
            if not features and not bad_for_both:
                wrong.append(name)
            print(f"{name}: {', '.join(why)}{' (the oracle fails too)' if bad_for_both else ''}")
    print()
    for reason, count in counts.most_common():
        print(f"{count:4}  {reason}")
    print(f"\n{len(scenes)} scenes: {len(scenes) - refused} interpreted, {refused} refused, "
          f"{len(wrong)} for other reasons than missing features", *wrong, sep="\n  ")
    return 1 if wrong else 0


def fill_cache(scenes: list[str], place: Workplace) -> int:
    for name in scenes:
        _, error, seconds = oracle_picture(name, place)
        print(f"{name}  {seconds:.2f}  {error}".rstrip(), flush=True)
    return 0


def compare(scenes: list[str], place: Workplace, args: argparse.Namespace) -> int:
    width = max(map(len, scenes))
    print(f"{'scene':<{width}}  {'class':<16} {'dB':>5}  {'oracle s':>8}  {'durer s':>8}  note")
    rows = []
    with ThreadPoolExecutor(max(1, args.jobs)) as pool:
        for row in pool.map(lambda name: judge(name, place, library_of(args.stdlib)), scenes):
            print(line_of(row, width), flush=True)
            rows.append(row)

    baseline = read_baseline(args.baseline)
    regressions = changes(rows, baseline, worse=True)
    improvements = changes(rows, baseline, worse=False)
    if args.html:
        page = report.write(args.html, rows, summary(rows), regressions)
        print(f"\npictures: {page}")
    for title, lines in (("better than the baseline", improvements), ("WORSE than the baseline", regressions)):
        if lines:
            print(f"\n{title}:", *lines, sep="\n  ")
    if args.update_baseline:
        write_baseline(args.baseline, rows, baseline)
    print("\n" + summary(rows))
    crashed = any(row.crashed for row in rows)
    return 1 if crashed or (regressions and not args.update_baseline) else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
