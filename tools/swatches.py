#!/usr/bin/env python3
"""Swatches: every colour, texture, finish, pigment, map, material, sky and object of the library, in a grid.

    tools/swatches.py compare [INCLUDE...]   durer with our includes and with POV-Ray's: the pictures must be equal
    tools/swatches.py oracle [INCLUDE...]    POV-Ray with its includes beside durer with ours: how alike they are
    tools/swatches.py draw FOLDER            the sheets of our includes, as PNG, with their names in index.json

A sheet has eight swatches in a row, in the order of the include.
"""

import argparse
import functools
import json
import subprocess
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
    "object": "intersection {{ object {{ {} }} box {{ -1.7, 1.7 }} pigment {{ rgb <0.8, 0.7, 0.5> }} finish {{ specular 0.4 }} rotate <-20, 25, 0> scale 0.42 }}",
    "letter": "object {{ {} pigment {{ rgb <0.8, 0.7, 0.5> }} translate -2.5 * y scale 0.37 }}",
}
WAYS["pattern"] = "box {{ <-1, -1, 0>, <1, 1, 0.1> pigment {{ {} scale 0.5 }} finish {{ ambient 0.9 diffuse 0.1 }} }}"
WAYS["shape"] = "object {{ {} pigment {{ rgb <0.8, 0.7, 0.5> }} finish {{ specular 0.4 }} rotate <-20, 25, 0> }}"
PATTERNS = {  # what is written, where the name alone is not enough
    name: "" for name in (
        "agate", "boxed", "bozo", "brick", "bumps", "checker", "crackle", "cylindrical", "dents", "granite", "hexagon", "leopard",
        "marble", "onion", "pavement", "planar", "quilted", "radial", "ripples", "spherical", "spotted", "square", "triangular",
        "waves", "wood", "wrinkles")}
PATTERNS |= {"cells": "cells", "gradient": "gradient x", "julia": "julia <0.353, 0.288>, 30", "mandel": "mandel 25",
             "spiral1": "spiral1 3", "spiral2": "spiral2 3", "tiling": "tiling 5", "magnet": "magnet 1 mandel 25"}
FLAT = ("agate", "brick", "checker", "granite", "marble", "wood", "hexagon", "square", "triangular")  # have colours of their own
GREY = " color_map { [0 rgb 0.05] [1 rgb 0.95] }"
SHAPES = {
    "bicubic_patch": "bicubic_patch { type 1 u_steps 4 v_steps 4 " + ", ".join(
        f"<{0.6 * x - 0.9}, {(0.8 if x in (1, 2) and y in (1, 2) else -0.3)}, {0.6 * y - 0.9}>" for y in range(4) for x in range(4)) + " }",
    "blob": "blob { threshold 0.5 sphere { <-0.4, 0, 0>, 0.9, 1 } sphere { <0.4, 0.2, 0>, 0.8, 1 } }",
    "box": "box { -0.65, 0.65 }", "cone": "cone { -0.8 * y, 0.8, 0.9 * y, 0.1 }", "cylinder": "cylinder { -0.8 * y, 0.8 * y, 0.6 }",
    "disc": "disc { 0, y + z, 0.9, 0.3 }",
    "isosurface": "isosurface { function { x*x + y*y + z*z - 0.7 + 0.2*sin(12*x)*sin(12*y)*sin(12*z) } contained_by { box { -1, 1 } } max_gradient 5 }",
    "julia_fractal": "julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 30 }",
    "lathe": "lathe { quadratic_spline 6, <0, -0.9>, <0.3, -0.9>, <0.6, -0.4>, <0.2, 0.2>, <0.4, 0.8>, <0.5, 0.9> }",
    "mesh": "mesh { triangle { <-0.9, -0.6, 0>, <0.9, -0.6, 0>, <0, 0.9, 0> } triangle { <-0.9, -0.6, 0>, <0.9, -0.6, 0>, <0, -0.3, -0.9> } }",
    "ovus": "ovus { 0.7, 0.35 translate -0.3 * y }",
    "polygon": "polygon { 6, <-0.8, -0.6>, <0.8, -0.6>, <0.8, 0.6>, <0, 0.1>, <-0.8, 0.6>, <-0.8, -0.6> }",
    "prism": "prism { -0.4, 0.4, 6, <-0.8, -0.6>, <0.8, -0.6>, <0.8, 0.6>, <0, 0.1>, <-0.8, 0.6>, <-0.8, -0.6> }",
    "quadric": "intersection { quadric { <1, -0.5, 1>, 0, 0, -0.15 } box { -0.9, 0.9 } }",
    "sor": "sor { 6, <0.3, -1.1>, <0.5, -0.9>, <0.8, -0.3>, <0.3, 0.4>, <0.5, 0.9>, <0.6, 1.1> }",
    "sphere": "sphere { 0, 0.9 }",
    "sphere_sweep": "sphere_sweep { cubic_spline 6, <-1.2, -1, 0>, 0.2, <-0.7, -0.6, 0>, 0.3, <0.5, -0.3, 0.3>, 0.2, <-0.3, 0.4, 0>, 0.25, <0.7, 0.6, 0>, 0.15, <1, 1, 0>, 0.1 }",
    "superellipsoid": "superellipsoid { <0.3, 0.3> scale 0.8 }", "torus": "torus { 0.65, 0.25 rotate -30 * x }",
    "triangle": "triangle { <-0.9, -0.7, 0>, <0.9, -0.5, 0>, <0, 0.9, 0> }",
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


def new_ones() -> dict[str, list[tuple[str, str]]]:
    """What POV-Ray's includes and ours do not have in common: modules of our own, and the language itself."""
    rows = text.rows
    return {
        "color_scales.inc": [(f"Scale_{row['name']}", "color_map") for row in rows(stdlib.DATA / "scales.tsv")],
        "metals_measured.inc": [(f"TM_{row['name']}", "texture") for row in rows(stdlib.DATA / "reflectances.tsv")],
        "optics.inc": [(f"IM_{row['name']}", "interior") for row in rows(stdlib.DATA / "sellmeier.tsv")],
        "patterns": [(name, "pattern") for name in sorted(PATTERNS) if name in registered("pattern")],
        "objects": [(name, "shape") for name in sorted(SHAPES) if name in registered("object")],
    }


@functools.cache
def registered(kind: str) -> set[str]:
    """The patterns or objects that durer has."""
    done = subprocess.run([str(programs.durer_path()), "doc", "--list", kind], capture_output=True, text=True, check=True)
    return set(done.stdout.split()[1:])


def written(name: str, kind: str) -> str:
    """What stands in a swatch's scene for a name."""
    if kind == "shape":
        return SHAPES[name]
    if kind == "pattern":
        return (PATTERNS[name] or name) + ("" if name in FLAT else GREY)
    return name


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
    if include in ("patterns", "objects"):
        scene = scene.replace(f'#include "{include}"\n', "")
    if first:
        scene = scene.replace("camera {", f'#include "{include}"\ncamera {{', 1)
    for k, (name, kind) in enumerate(shown):
        place = f"<{k % COLUMNS - (COLUMNS - 1) / 2}, {(rows - 1) / 2 - k // COLUMNS}, 0>"
        scene += f"object {{ {WAYS[kind].format(written(name, kind))} scale 0.45 translate {place} }}\n"
    return scene


def sky(include: str, name: str) -> str:
    return (f'#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n#include "colors.inc"\n#include "{include}"\n'
            f"camera {{ location y look_at <0, 1.4, 1> angle 70 right x up y }}\nsky_sphere {{ {name} }}\n"
            "light_source { <-50, 80, -60> rgb 1 }\nplane { y, 0 pigment { rgb <0.3, 0.35, 0.25> } }\n")


def scenes(of: dict[str, list[tuple[str, str]]], wanted: list[str]) -> dict[str, tuple[str, int, int]]:
    """Title → scene, and its size in swatches."""
    found = {}
    for include, names in of.items():
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
    todo = scenes(listed(), wanted)
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
    everything = listed() | new_ones()
    failed = 0
    for title, (source, columns, rows) in scenes(everything, []).items():
        made = render(source, (columns, rows), PIXELS)
        if made.picture is None:
            failed += 1
            print(f"{title}: {made.error}", flush=True)
            continue
        (folder / f"{title.replace(':', '-')}.png").write_bytes(png.encode(made.picture))
    index = {include: [name for name, kind in names if kind != "sky_sphere"] for include, names in everything.items()}
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
