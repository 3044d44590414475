#!/usr/bin/env python3
"""Swatches: every colour, texture, finish, pigment, map, material, sky and object of the library, in a grid.

    tools/swatches.py compare [INCLUDE...]   durer with our includes and with POV-Ray's: the pictures must be equal
    tools/swatches.py oracle [--no-grain] [INCLUDE...]  POV-Ray with its includes beside durer with ours: how alike they
                                             are. Without grain, `crand` is 0 in copies of the includes: it is noise
    tools/swatches.py draw FOLDER [INCLUDE...]  the sheets of our includes, as JPEG, with their names in index.json

A sheet has eight swatches in a row, in the order of the include; what is drawn has names under them,
for which a font must be installed, such as Debian's fonts-dejavu-core.
"""

import argparse
import functools
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import pictures
import png
import programs
import stdlib
import stdlib_text as text
import swatch_scenes as parts

COLUMNS = 8
PIXELS = 64  # size of a swatch on a drawn sheet
LIMIT = 300.0  # seconds
BEFORE = {"shapes2.inc": "shapes.inc", "shapesq.inc": "shapes.inc"}  # what POV-Ray's own need and do not include
LANGUAGE = ("patterns", "objects")  # sheets of what needs no include
BEFORE |= dict.fromkeys(("skies.inc", "stones1.inc", "stones2.inc", "stoneold.inc", "stars.inc"), "colors.inc")
HEIGHT = 1.375  # of a drawn swatch with its name, in widths


def listed() -> dict[str, list[tuple[str, str]]]:
    """Include → (name, kind) of what a swatch can show; later declarations of a name win."""
    found = {"colors.inc": [(row["name"], "color") for row in text.rows(stdlib.DATA / "colors.tsv")]}
    for path in sorted(stdlib.DATA.glob("*.json")):
        table = json.loads(path.read_text("utf-8"))
        if path.name == "maps.json":
            found |= {file: [(entry["name"], "color_map")] for file, entry in table.items()}
            continue
        names = {d["name"]: _kind(path.stem, d) for d in table["declarations"]}
        found[table["include"]] = [(name, kind) for name, kind in names.items() if kind in parts.WAYS or kind in ("object", "surface") or kind == "sky_sphere"]
    return {include: names for include, names in found.items() if names}


def new_ones() -> dict[str, list[tuple[str, str]]]:
    """What POV-Ray's includes and ours do not have in common: modules of our own, and the language itself;
    and what macros make."""
    rows = text.rows
    return {
        "color_scales.inc": [(f"Scale_{row['name']}", "color_map") for row in rows(stdlib.DATA / "scales.tsv")],
        "metals_measured.inc": [(f"TM_{row['name']}", "texture") for row in rows(stdlib.DATA / "reflectances.tsv")],
        "optics.inc": [(f"IM_{row['name']}", "interior") for row in rows(stdlib.DATA / "sellmeier.tsv")],
        "patterns": [(name, kind) for name, (_, kind) in sorted(parts.PATTERNS.items()) if name in registered("pattern")],
        "objects": [(name, "shape") for name in sorted(parts.SHAPES) if name in registered("object")],
    } | {include: [(call, "made") for call in calls] for include, calls in parts.CALLS.items()}


@functools.cache
def registered(kind: str) -> set[str]:
    """The patterns or objects that durer has."""
    done = subprocess.run([str(programs.durer_path()), "doc", "--list", kind], capture_output=True, text=True, check=True)
    return set(done.stdout.split()[1:])


def written(name: str, kind: str) -> str:
    """The object of a swatch's scene that shows what has this name."""
    if kind in ("object", "surface"):
        size = parts.WINDOWS.get(name, 1.7)
        return (parts.OBJECT if kind == "object" else parts.SURFACE).format(size, 0.42 * 1.7 / size).format(name)
    what = name
    if kind == "shape":
        what = parts.SHAPES.get(name, name)
    elif name in parts.PATTERNS and kind in ("pattern", "floor", "ball", "bump"):
        what = parts.PATTERNS[name][0] + ("" if name in parts.FLAT or kind == "bump" else parts.GREY)
    elif kind in ("pattern", "floor"):
        what = name + parts.GREY
    return parts.WAYS[kind].format(what)


def _kind(stem: str, declaration: dict) -> str:
    if declaration["name"].startswith("O_Cloud"):
        return ""  # as large as the sky
    if declaration["kind"] == "object" and stem == "shapesq":
        return "surface"
    return "letter" if stem == "chars" else declaration["kind"]


def sheet(include: str, names: list[tuple[str, str]], captions: bool) -> str:
    """The scene of a sheet."""
    shown = [(name, kind) for name, kind in names if kind != "sky_sphere"]
    rows = (len(shown) + COLUMNS - 1) // COLUMNS
    height = HEIGHT if captions else 1
    first = BEFORE.get(include, "")
    scene = parts.STAGE.format(version="3.8" if include in LANGUAGE else "3.7", include=first or include, columns=COLUMNS,
                               rows=rows * height, backdrop=parts.BACKDROPS.get(include, parts.CHECKERS))
    if include in LANGUAGE:
        scene = scene.replace(f'#include "{include}"\n', "")
    if first:
        scene = scene.replace("camera {", f'#include "{include}"\ncamera {{', 1)
    scene += parts.PRELUDES.get(include, "") + (parts.HELPERS if captions else "")
    for k, (name, kind) in enumerate(shown):
        x, y = k % COLUMNS - (COLUMNS - 1) / 2, ((rows - 1) / 2 - k // COLUMNS) * height
        scene += f"object {{ {written(name, kind)} scale 0.45 translate <{x}, {y + (height - 1) / 2}, 0> }}\n"
        for line, caption in enumerate(lines_of(name) if captions else []):
            scene += f'Caption("{caption}", <{x}, {y - 0.44 - 0.17 * line:.4g}, 0>)\n'
    return scene


def label(shown: str) -> str:
    """The name of what is shown: of the macro, if it is a call."""
    return re.findall(r"\w+(?=\()", shown)[0] if "(" in shown else shown


def lines_of(name: str) -> list[str]:
    """A name in one or two lines of about the same length."""
    name = label(name)
    breaks = [m.start() for m in re.finditer(r"(?<=_)|(?<=[a-z0-9])(?=[A-Z])", name) if 0 < m.start() < len(name)]
    if len(name) < 12 or not breaks:
        return [name]
    at = min(breaks, key=lambda k: abs(k - len(name) / 2))
    return [name[:at], name[at:]]


def sky(include: str, name: str) -> str:
    return parts.SKY.format(include=include, name=name)


def scenes(of: dict[str, list[tuple[str, str]]], wanted: tuple[str, ...] | list[str], captions: bool = False) -> dict[str, tuple[str, int, float]]:
    """Title → scene, and its size in swatches."""
    found = {}
    for include, names in of.items():
        if wanted and include not in wanted:
            continue
        shown = sum(kind != "sky_sphere" for _, kind in names)
        if shown:
            found[include] = (sheet(include, names, captions), COLUMNS, (shown + COLUMNS - 1) // COLUMNS * (HEIGHT if captions else 1))
        found |= {f"{include}:{name}": (sky(include, name), 2, 2) for name, kind in names if kind == "sky_sphere"}
    return found


def render(source: str, size: tuple[int, float], pixels: int, with_oracle: bool = False, library: str = "",
           grainless: Path | None = None) -> programs.Rendering:
    """Renders a sheet; with copies of the includes from a folder in which nothing has grain, if there is one."""
    with tempfile.TemporaryDirectory(prefix="durer-") as folder:
        scene = Path(folder) / "swatches.pov"
        scene.write_text(source, "utf-8")
        for include in grainless.glob("*.inc") if grainless else []:  # beside the scene, they come first
            text = include.read_bytes().decode("latin-1")
            (Path(folder) / include.name).write_bytes(re.sub(r"\bcrand\s+[\d.]+", "crand 0", text).encode("latin-1"))
        options = [f"+W{size[0] * pixels}", f"+H{round(size[1] * pixels)}", "-D", "-A"]
        if with_oracle:
            return programs.render_with_oracle(scene, [*options, "+WT1"], LIMIT)
        return programs.render_with_durer(scene, [*options, *([f"+L{library}"] if library else [])], LIMIT)


def picture(source: str, size: tuple[int, float], target: Path) -> str:
    """Draws a sheet into a file, every pixel of many samples; returns what went wrong."""
    with tempfile.TemporaryDirectory(prefix="durer-") as folder:
        scene = Path(folder) / "swatches.pov"
        scene.write_text(source, "utf-8")
        done = programs.run([str(programs.durer_path()), f"+I{scene}", f"+O{target.absolute()}", "+FJ", "Compression=85", "-D", "+A0.0",
                             f"+W{size[0] * PIXELS}", f"+H{round(size[1] * PIXELS)}"], Path(folder), LIMIT)
    return "" if done.code == 0 and target.exists() else programs.first_error(done.err)


def not_exact(names: list[tuple[str, str]], ours: png.Picture, other: png.Picture) -> str:
    """How many swatches of a sheet are exact, and how alike the others are."""
    size = ours.width // COLUMNS
    shown = [name for name, kind in names if kind != "sky_sphere"]
    alike = {}
    for k, name in enumerate(shown):
        window = (k % COLUMNS * size, k // COLUMNS * size, size, size)
        alike[name] = pictures.psnr(pictures.part(ours, *window), pictures.part(other, *window))
    others = {name: decibels for name, decibels in alike.items() if pictures.class_of(decibels) != "exact"}
    told = ", ".join(f"{name} {pictures.text(others[name])}" for name in sorted(others, key=others.__getitem__))
    return f"{len(shown) - len(others):4} of {len(shown)} exact" + (f", and {told}" if told else "")


def compare(wanted: list[str], with_oracle: bool, without_grain: bool = False) -> int:
    differ = 0
    known = listed()
    todo = scenes(known, wanted)
    pixels = PIXELS if with_oracle else 24
    for title, (source, columns, rows) in todo.items():
        ours = render(source, (columns, rows), pixels, grainless=stdlib.LIBRARY if without_grain else None)
        other = render(source, (columns, rows), pixels, with_oracle, str(programs.INCLUDES), programs.INCLUDES if without_grain else None)
        if ours.picture is None or other.picture is None:
            differ += 1
            print(f"{title:24} ours: {ours.error or 'renders'}; theirs: {other.error or 'renders'}", flush=True)
            continue
        decibels = pictures.psnr(ours.picture, other.picture)
        differ += decibels < (38 if with_oracle else float("inf"))
        detail = not_exact(known[title], ours.picture, other.picture) if with_oracle and title in known else ""
        print(f"{title:24} {pictures.text(decibels)}{detail}", flush=True)
    print(f"{len(todo)} sheets, {differ} differ")
    return 1 if differ else 0


def drawn() -> dict[str, list[tuple[str, str]]]:
    """All that the reference shows: include → (name, kind)."""
    found = listed() | new_ones()
    for include, calls in parts.CALLED_PATTERNS.items():
        found[include] = found[include] + calls
    return found


def draw(folder: Path, wanted: tuple[str, ...] | list[str] = ()) -> int:
    """The sheets as JPEG files, and which name is where in them."""
    folder.mkdir(parents=True, exist_ok=True)
    everything = drawn()
    failed = 0
    for title, (source, columns, rows) in scenes(everything, wanted, captions=True).items():
        error = picture(source, (columns, rows), folder / f"{title.replace(':', '-')}.jpg")
        if error:
            failed += 1
            print(f"{title}: {error}", flush=True)
    index = {include: [label(name) for name, kind in names if kind != "sky_sphere"] for include, names in everything.items()}
    (folder / "index.json").write_text(json.dumps(index, indent=1) + "\n", "utf-8")
    return 1 if failed else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["compare", "oracle", "draw"])
    parser.add_argument("what", nargs="*", help="the folder to draw into, if it is draw; includes")
    parser.add_argument("--no-grain", action="store_true", help="beside POV-Ray: without `crand`")
    args = parser.parse_intermixed_args()
    if args.action == "draw":
        if not args.what:
            parser.error("draw needs a folder")
        return draw(Path(args.what[0]), args.what[1:])
    if not programs.INCLUDES.exists() or (args.action == "oracle" and not programs.oracle_path()):
        print(f"swatches: POV-Ray's includes are not there; {programs.HOW_TO_INSTALL_ORACLE}", file=sys.stderr)
        return programs.SKIPPED
    return compare(args.what, args.action == "oracle", args.no_grain)


if __name__ == "__main__":
    sys.exit(main())
