#!/usr/bin/env python3
"""The example scenes with no package of POV-Ray to be seen, and with POV-Ray's own includes.

Each scene of povray-examples is rendered by durer twice: with its own library, POV-Ray's folders, fonts
and pictures hidden (in a mount namespace); and with POV-Ray's includes before its own. The two pictures are
compared, and each with the oracle's. Scenes that make a picture only as animations are rendered as their INI
file says, all frames, and the worst frame counts. Scenes that name a font or a picture of the packages, and
scenes that need no standard include, are told apart.

Exit codes: 0 all pictures of scenes that need no such file are exact or match, 1 some are not,
2 wrong usage, 77 the oracle or its examples are not installed, or cannot be hidden.
"""

import argparse
import re
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import conformance
import pictures
import png
import programs
import stdlib

FRAMES = ["+W80", "+H60", "-A", "-D"]  # an INI file that goes before says the rest
FRAMES_LIMIT = 600.0  # seconds, for all frames of an animation
COLUMNS = ("scene", "includes", "pictures", "with either library", "dB", "alone and the oracle", "with its includes and the oracle", "asks for")
STANDARD = {path.name.lower() for path in stdlib.LIBRARY.iterdir() if path.suffix in (".inc", ".map")}


@dataclass(frozen=True)
class Verdict:
    """What became of one scene. The classes are those of pictures.py, `fail`, or `-` where there is nothing to compare."""

    scene: str
    includes: str  # "standard", "own" or "none": what it reads, directly or through files of its own
    pictures: int  # frames of an animation, else 1 or 0
    either: str    # without the packages against with their includes
    decibels: str
    alone: str     # without the packages against the oracle
    theirs: str    # with the packages' includes against the oracle
    assets: str    # fonts, pictures and densities of the packages that it names
    note: str

    @property
    def good(self) -> bool:
        return bool(self.assets) or self.either in ("exact", "match", "-")


def includes(scene: Path, known: set[Path] | None = None) -> set[str]:
    """The names of the files that the text of a scene includes, and the scene's own files in their turn."""
    known = known if known is not None else set()
    known.add(scene)
    found = set(re.findall(r'#\s*include\s+"([^"]+)"', scene.read_text("latin-1")))
    for name in sorted(found):
        own = scene.parent / name
        if own.is_file() and own not in known and name.lower() not in STANDARD:
            found |= includes(own, known)
    return found


def kind_of(names: set[str]) -> str:
    return "none" if not names else "standard" if any(name.lower() in STANDARD for name in names) else "own"


def assets(errors: str) -> list[str]:
    """The files that were not there: fonts and pictures that others stand in for, others that are missing."""
    return sorted({a or b for a, b in re.findall(r"there is no (?:font )?`([^`]+)`; |cannot find the file `([^`]+)`", errors)})


def judge(name: str, place: conformance.Workplace) -> Verdict:
    expected, oracle_error, _ = conformance.oracle_picture(name, place)
    made, said, errors = {}, {}, []
    for which in ("alone", "oracle"):
        library = conformance.library_of(which)
        done = programs.render_with_durer(
            place.scene(f"durer-{which}", name), [*conformance.OPTIONS, *library.options], conformance.DURER_LIMIT, library.before)
        made[which], said[which] = [done.picture] if done.picture else [], done.run.err
        errors += [done.error] if which == "alone" and done.error else []
    wanted = [expected] if expected else []
    ini = place.scene("durer-alone", name).with_suffix(".ini")
    if not expected and not made["alone"] and ini.exists() and "Final_Frame" in ini.read_text("latin-1"):
        made = {which: frames(name, place, which) for which in made}
        wanted = oracle_frames(name, place)
        errors = []
    missing = set(assets(said["alone"])) - set(assets(said["oracle"]))
    either, decibels = class_of(made["alone"], made["oracle"])
    note = (errors or ([f"the oracle fails: {oracle_error}"] if not wanted else [""]))[0]
    beside = {key: class_of(made[key], wanted)[0] if wanted else "-" for key in made}
    return Verdict(name, kind_of(includes(place.scene("durer-alone", name))), len(made["alone"]), either, decibels, beside["alone"],
                   beside["oracle"], " ".join(sorted(missing)), note)


def class_of(a: list[png.Picture], b: list[png.Picture]) -> tuple[str, str]:
    """Class and PSNR of the worst of some pictures against some others."""
    if not a and not b:
        return "-", "-"
    if len(a) != len(b):
        return "fail", "-"
    decibels = min(pictures.psnr(one, other) for one, other in zip(a, b))
    return pictures.class_of(decibels), pictures.text(decibels)


def frames(name: str, place: conformance.Workplace, which: str) -> list[png.Picture]:
    """The pictures of an animation by durer, with one library or the other."""
    scene, library = place.scene(f"durer-{which}", name), conformance.library_of(which)
    return _animated([*library.before, str(programs.durer_path())], scene, library.options)


def oracle_frames(name: str, place: conformance.Workplace) -> list[png.Picture]:
    """The oracle's pictures of an animation; kept beside its pictures of scenes."""
    kept = (conformance.cache_folder() / name).with_suffix(".frames")
    if not kept.exists():
        made = _animated([programs.oracle_path() or "povray"], place.scene("oracle", name), ())
        part = kept.with_name(f"{kept.name}.part")
        part.mkdir(parents=True, exist_ok=True)
        for k, picture in enumerate(made):
            (part / f"{k:04}.png").write_bytes(png.encode(picture))
        part.rename(kept)
    return [png.read(path) for path in sorted(kept.glob("*.png"))]


def _animated(command: list[str], scene: Path, options: tuple[str, ...]) -> list[png.Picture]:
    with tempfile.TemporaryDirectory(prefix="durer-") as folder:
        programs.run([*command, scene.with_suffix(".ini").name, *FRAMES, f"+O{folder}/frame", "+FN", *options], scene.parent, FRAMES_LIMIT)
        return [png.read(path) for path in sorted(Path(folder).glob("*.png"))]


def table(verdicts: list[Verdict]) -> str:
    rows = [(v.scene, v.includes, str(v.pictures), v.either, v.decibels, v.alone, v.theirs, v.assets) for v in verdicts]
    return "\n".join("\t".join(row).rstrip() for row in [COLUMNS, *rows]) + "\n"


def summary(verdicts: list[Verdict]) -> str:
    lines = []
    for title, chosen in (
            ("need standard includes and nothing else of the packages", [v for v in verdicts if v.includes == "standard" and not v.assets]),
            ("need no standard include", [v for v in verdicts if v.includes != "standard" and not v.assets]),
            ("name a font, picture or density of the packages", [v for v in verdicts if v.assets])):
        lines.append(f"{len(chosen):4} scenes {title}")
        for column, label in (("either", "alone, and with POV-Ray's includes"), ("alone", "alone, and the oracle"),
                              ("theirs", "with POV-Ray's includes, and the oracle")):
            count = Counter(getattr(v, column) for v in chosen)
            lines.append(f"       {label:42}" + ", ".join(f"{count[k]} {'nothing to compare' if k == '-' else k}" for k in
                                                            ("exact", "match", "near", "wrong", "fail", "-") if count[k]))
    return "\n".join(lines)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("filter", nargs="*", help="part of a scene's path, or a pattern with * and ?")
    parser.add_argument("--list", type=Path, metavar="FILE", help="only the scenes that this file names")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="scenes at a time")
    parser.add_argument("--write", type=Path, metavar="FILE", help="write the table there")
    args = parser.parse_args()
    with conformance.Workplace() as place:
        if not programs.oracle_path() or not place.scenes or not programs.INCLUDES.exists():
            print(f"SKIPPED: POV-Ray or its example scenes are not installed; {programs.HOW_TO_INSTALL_ORACLE}")
            return programs.SKIPPED
        if not programs.without_oracle():
            print(f"SKIPPED: {programs.CANNOT_HIDE_ORACLE}")
            return programs.SKIPPED
        scenes = conformance.choose(place.scenes, args.filter, args.list)
        verdicts = []
        with ThreadPoolExecutor(max(1, args.jobs)) as pool:
            for verdict in pool.map(lambda name: judge(name, place), scenes):
                verdicts.append(verdict)
                if not verdict.good or verdict.note or verdict.assets:
                    print(f"{verdict.scene}: {verdict.either} {verdict.decibels} {verdict.assets} {verdict.note}".rstrip(), flush=True)
    if args.write:
        args.write.write_text(table(verdicts), "utf-8")
    print("\n" + summary(verdicts))
    bad = [v.scene for v in verdicts if not v.good]
    if bad:
        print("\nnot the same without the packages:", *bad, sep="\n  ")
    return 1 if bad else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
