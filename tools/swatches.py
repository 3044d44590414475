#!/usr/bin/env python3
"""Swatches: every colour, texture, finish, pigment, map, material, sky and object of the library, in a grid.

    tools/swatches.py compare [INCLUDE...]   durer with our includes and with POV-Ray's: the pictures must be equal
    tools/swatches.py oracle [INCLUDE...]    POV-Ray with its includes beside durer with ours: how alike they are
    tools/swatches.py draw FOLDER            the sheets of our includes, as PNG, with their names in index.json

A sheet has eight swatches in a row, in the order of the include.
"""

import argparse
import json
import sys
import tempfile
from pathlib import Path

import pictures
import png
import programs
import stdlib
import stdlib_text as text

COLUMNS = 8
PIXELS = 40  # size of a swatch on a drawn sheet
LIMIT = 300.0  # seconds
BEFORE = {"shapes2.inc": "shapes.inc", "shapesq.inc": "shapes.inc"}  # what POV-Ray's own need and do not include
BEFORE |= dict.fromkeys(("skies.inc", "stones1.inc", "stones2.inc", "stoneold.inc", "stars.inc"), "colors.inc")
WAYS = {  # kind → how a swatch shows it
    "color": "sphere {{ 0, 1 pigment {{ {} }} }}",
    "pigment": "sphere {{ 0, 1 pigment {{ {} }} }}",
    "color_map": "box {{ -1, 1 pigment {{ gradient x color_map {{ {} }} scale 2 translate -x }} }}",
    "texture": "sphere {{ 0, 1 texture {{ {} }} }}",
    "finish": "sphere {{ 0, 1 pigment {{ rgb <0.7, 0.5, 0.3> }} finish {{ {} }} }}",
    "interior": "sphere {{ 0, 1 pigment {{ rgbf 0.9 }} finish {{ specular 0.5 }} interior {{ {} fade_color rgb <0.3, 0.7, 0.5> }} }}",
    "material": "sphere {{ 0, 1 material {{ {} }} }}",
    "object": "intersection {{ object {{ {} }} box {{ -1.7, 1.7 }} pigment {{ rgb <0.8, 0.7, 0.5> }} finish {{ specular 0.4 }} rotate <-20, 25, 0> scale 0.6 }}",
    "letter": "object {{ {} pigment {{ rgb <0.8, 0.7, 0.5> }} translate -2.5 * y scale 0.37 }}",
}
STAGE = """#version 3.7;
global_settings {{ assumed_gamma 1 max_trace_level 6 }}
#include "{include}"
camera {{ orthographic location -20 * z direction z right {columns} * x up {rows} * y }}
light_source {{ <-60, 80, -100> rgb 1 }}
light_source {{ <80, -10, -60> rgb 0.3 shadowless }}
sky_sphere {{ pigment {{ gradient y color_map {{ [0 rgb <0.25, 0.22, 0.2>] [0.5 rgb <0.75, 0.8, 0.85>] [1 rgb <0.4, 0.55, 0.8>] }} scale 2 translate -y }} }}
plane {{ -z, -2 hollow pigment {{ checker rgb 0.85, rgb 0.65 scale 0.25 }} finish {{ ambient 0.6 diffuse 0.4 }} }}
"""


def listed() -> dict[str, list[tuple[str, str]]]:
    """Include → (name, kind) of what a swatch can show; later declarations of a name win."""
    found = {"colors.inc": [(row["name"], "color") for row in text.rows(stdlib.DATA / "colors.tsv")]}
    for path in sorted(stdlib.DATA.glob("*.json")):
        table = json.loads(path.read_text("utf-8"))
        if path.name == "maps.json":
            found |= {file: [(entry["name"], "color_map")] for file, entry in table.items()}
            continue
        names = {d["name"]: _kind(path.stem, d) for d in table["declarations"]}
        found[table["include"]] = [(name, kind) for name, kind in names.items() if kind in WAYS or kind == "sky_sphere"]
    return {include: names for include, names in found.items() if names}


def _kind(stem: str, declaration: dict) -> str:
    if declaration["name"].startswith("O_Cloud"):
        return ""  # as large as the sky
    return "letter" if stem == "chars" else declaration["kind"]


def sheet(include: str, names: list[tuple[str, str]]) -> str:
    """The scene of a sheet."""
    shown = [(name, kind) for name, kind in names if kind != "sky_sphere"]
    rows = (len(shown) + COLUMNS - 1) // COLUMNS
    first = BEFORE.get(include, "")
    scene = STAGE.format(include=first or include, columns=COLUMNS, rows=rows)
    if first:
        scene = scene.replace("camera {", f'#include "{include}"\ncamera {{', 1)
    for k, (name, kind) in enumerate(shown):
        place = f"<{k % COLUMNS - (COLUMNS - 1) / 2}, {(rows - 1) / 2 - k // COLUMNS}, 0>"
        scene += f"object {{ {WAYS[kind].format(name)} scale 0.45 translate {place} }}\n"
    return scene


def sky(include: str, name: str) -> str:
    return (f'#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n#include "colors.inc"\n#include "{include}"\n'
            f"camera {{ location y look_at <0, 1.4, 1> angle 70 right x up y }}\nsky_sphere {{ {name} }}\n"
            "light_source { <-50, 80, -60> rgb 1 }\nplane { y, 0 pigment { rgb <0.3, 0.35, 0.25> } }\n")


def scenes(wanted: list[str]) -> dict[str, tuple[str, int, int]]:
    """Title → scene, and its size in swatches."""
    found = {}
    for include, names in listed().items():
        if wanted and include not in wanted:
            continue
        shown = sum(kind != "sky_sphere" for _, kind in names)
        if shown:
            found[include] = (sheet(include, names), COLUMNS, (shown + COLUMNS - 1) // COLUMNS)
        found |= {f"{include}:{name}": (sky(include, name), 2, 2) for name, kind in names if kind == "sky_sphere"}
    return found


def render(source: str, size: tuple[int, int], pixels: int, with_oracle: bool = False, library: str = "") -> programs.Rendering:
    with tempfile.TemporaryDirectory(prefix="durer-") as folder:
        scene = Path(folder) / "swatches.pov"
        scene.write_text(source, "utf-8")
        options = [f"+W{size[0] * pixels}", f"+H{size[1] * pixels}", "-D", "+A0.2" if pixels > 32 else "-A"]
        if with_oracle:
            return programs.render_with_oracle(scene, [*options, "+WT1"], LIMIT)
        return programs.render_with_durer(scene, [*options, *([f"+L{library}"] if library else [])], LIMIT)


def compare(wanted: list[str], with_oracle: bool) -> int:
    differ = 0
    todo = scenes(wanted)
    for title, (source, columns, rows) in todo.items():
        ours = render(source, (columns, rows), 24)
        other = render(source, (columns, rows), 24, with_oracle, str(programs.INCLUDES))
        if ours.picture is None or other.picture is None:
            differ += 1
            print(f"{title:24} ours: {ours.error or 'renders'}; theirs: {other.error or 'renders'}", flush=True)
            continue
        decibels = pictures.psnr(ours.picture, other.picture)
        differ += decibels < (38 if with_oracle else float("inf"))
        print(f"{title:24} {pictures.text(decibels)}", flush=True)
    print(f"{len(todo)} sheets, {differ} differ")
    return 1 if differ else 0


def draw(folder: Path) -> int:
    """The sheets as PNG files, and which name is where in them."""
    folder.mkdir(parents=True, exist_ok=True)
    failed = 0
    for title, (source, columns, rows) in scenes([]).items():
        made = render(source, (columns, rows), PIXELS)
        if made.picture is None:
            failed += 1
            print(f"{title}: {made.error}", flush=True)
            continue
        (folder / f"{title.replace(':', '-')}.png").write_bytes(png.encode(made.picture))
    index = {include: [name for name, kind in names if kind != "sky_sphere"] for include, names in listed().items()}
    (folder / "index.json").write_text(json.dumps(index, indent=1) + "\n", "utf-8")
    return 1 if failed else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["compare", "oracle", "draw"])
    parser.add_argument("what", nargs="*", help="includes, or the folder to draw into")
    args = parser.parse_args()
    if args.action == "draw":
        if len(args.what) != 1:
            parser.error("draw needs one folder")
        return draw(Path(args.what[0]))
    if not programs.INCLUDES.exists() or (args.action == "oracle" and not programs.oracle_path()):
        print(f"swatches: POV-Ray's includes are not there; {programs.HOW_TO_INSTALL_ORACLE}", file=sys.stderr)
        return programs.SKIPPED
    return compare(args.what, args.action == "oracle")


if __name__ == "__main__":
    sys.exit(main())
