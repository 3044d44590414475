#!/usr/bin/env python3
"""Every texture and sky of the oracle's include files, as a ball or a patch of sky by both renderers.

Prints the likeness of each in dB and, at the end, how many are exact, match, near or wrong (exit 1 if
any does not match). Contact sheets of both go to build/swatches.

Usage: swatches.py [FILTER…]      names of include files, such as woods
"""

import re
import sys
import tempfile
from pathlib import Path

import pictures
import png
import programs

FILES = ("woods", "stones1", "stones2", "metals", "golds", "textures", "skies")
NEEDED = {"stones1": "colors", "stones2": "colors", "skies": "colors", "textures": "colors"}
SHEETS = programs.ROOT / "build" / "swatches"
CELL = 24  # pixels
COLUMNS = 10
LIMIT = 120.0  # seconds

TEXTURE = re.compile(r"^\s*#declare\s+(\w+)\s*=\s*texture\b", re.MULTILINE)
SKY = re.compile(r"^\s*#declare\s+(\w+)\s*=\s*sky_sphere\b", re.MULTILINE)


def names(file: str, kind: re.Pattern) -> list[str]:
    """What an include file declares, each name once, comments left out."""
    text = (programs.INCLUDES / f"{file}.inc").read_text(encoding="latin-1")
    text = re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.DOTALL)
    return list(dict.fromkeys(kind.findall(text)))


def head(file: str) -> str:
    needed = f'#include "{NEEDED[file]}.inc"\n' if file in NEEDED else ""
    return f'#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n{needed}#include "{file}.inc"\n'


def balls(file: str, textures: list[str]) -> tuple[str, int, int]:
    """A sheet of balls before a checkered wall; its width and height in pixels."""
    rows = -(-len(textures) // COLUMNS)
    lines = [head(file),
             f"camera {{ orthographic location <{COLUMNS / 2}, {rows / 2}, -9> direction z right {COLUMNS}*x up {rows}*y }}",
             "light_source { <-40, 60, -80> rgb 1 }",
             "plane { -z, -2 pigment { checker rgb .7 rgb .3 scale .25 } }"]
    for i, name in enumerate(textures):
        lines.append(f"sphere {{ 0, .48 texture {{ {name} }} translate <{i % COLUMNS + .5}, {i // COLUMNS + .5}, 0> }}")
    return "\n".join(lines) + "\n", COLUMNS * CELL, rows * CELL


def sky(file: str, name: str) -> tuple[str, int, int]:
    camera = "camera { location 0 direction z right 1.5*x up y look_at <0, .4, 1> }\n"
    return f"{head(file)}{camera}sky_sphere {{ {name} }}\n", 72, 48


def render(scene: tuple[str, int, int]) -> tuple[png.Picture, png.Picture]:
    """Durer's picture and the oracle's; exits if there is none."""
    text, width, height = scene
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "swatches.pov"
        path.write_text(text)
        options = [f"+W{width}", f"+H{height}", "-A", "-D", f"+L{programs.INCLUDES}"]
        both = [make(path, options, LIMIT) for make in (programs.render_with_durer, programs.render_with_oracle)]
    for made in both:
        if made.picture is None:
            sys.exit(f"{made.error}\n{made.run.err[-2000:]}")
    return both[0].picture, both[1].picture


def crop(sheet: png.Picture, column: int, row: int) -> png.Picture:
    """One cell; rows count from below."""
    top = sheet.height - (row + 1) * CELL
    lines = []
    for y in range(top, top + CELL):
        start = (y * sheet.width + column * CELL) * 3
        lines.append(sheet.rgb[start:start + CELL * 3])
    return png.Picture(CELL, CELL, b"".join(lines))


def keep(name: str, ours: png.Picture, theirs: png.Picture) -> None:
    SHEETS.mkdir(parents=True, exist_ok=True)
    for suffix, picture in [("durer", ours), ("oracle", theirs), ("difference", pictures.difference(ours, theirs))]:
        (SHEETS / f"{name}.{suffix}.png").write_bytes(png.encode(picture))


def compare(file: str):
    """Every name of an include file with its likeness."""
    textures = names(file, TEXTURE)
    if textures:
        ours, theirs = render(balls(file, textures))
        keep(file, ours, theirs)
        for i, name in enumerate(textures):
            cell = (i % COLUMNS, i // COLUMNS)
            yield name, pictures.psnr(crop(ours, *cell), crop(theirs, *cell))
    for name in names(file, SKY):
        ours, theirs = render(sky(file, name))
        keep(f"{file}.{name}", ours, theirs)
        yield name, pictures.psnr(ours, theirs)


def main() -> int:
    if programs.oracle_path() is None or not programs.INCLUDES.exists():
        print(programs.HOW_TO_INSTALL_ORACLE)
        return programs.SKIPPED
    counts: dict[str, int] = {}
    for file in FILES:
        if len(sys.argv) > 1 and file not in sys.argv[1:]:
            continue
        for name, decibels in compare(file):
            verdict = pictures.class_of(decibels)
            counts[verdict] = counts.get(verdict, 0) + 1
            print(f"{pictures.text(decibels):>6} {verdict:6} {file:9} {name}")
    print(", ".join(f"{count} {verdict}" for verdict, count in counts.items()))
    return 0 if set(counts) <= {"exact", "match"} else 1


if __name__ == "__main__":
    sys.exit(main())
