#!/usr/bin/env python3
"""The standard includes that are made from the tables of stdlib/data.

    tools/stdlib.py generate       write them
    tools/stdlib.py fresh          fail if one is not what its table says
    tools/stdlib.py names          fail if a name of tests/includes/names.tsv is missing in stdlib
    tools/stdlib.py cases          fail if a macro that has a docstring has no case in tests/language
"""

import argparse
import difflib
import json
import re
import sys
import textwrap
from pathlib import Path

import programs
import stdlib_text as text

LIBRARY = programs.ROOT / "stdlib"
DATA = LIBRARY / "data"
FUNCTIONS = """The built-in functions of the language, and patterns as functions.
/// The first are made for isosurfaces: they are zero on a surface. All take x, y, z and parameters p0, p1 …
/// Notation: C(v) = min(10, max(-10, v)); hyp(a, b) = sqrt(a^2 + b^2); wrap(v) = v within 0 and 2 pi.
/// rot(s, d, t): if s > 0 the curve is turned about y, x being sqrt(x^2 + z^2) - d, and first turned by
/// t degrees. E: E1 = exp(-p1 (p0 x^2 + p0 y^2 + z^2)), E2 with p0 at x and z, E3 at y and z. hexcell: a and b are
/// distances in a cell of a hexagonal tiling. sect(a, c, k, t): a superellipse of power 2/k turned by t
/// degrees; k = 0 is a square. thread(v, s): a zigzag of period 2s."""
ABSENT = {  # names of POV-Ray's includes that ours have no use for, and why
    ("ior.inc", "Ior"): "a helper that is undefined again", ("ior.inc", "Disp"): "a helper that is undefined again",
    ("shapes.inc", "J"): "a loop's counter", ("shapes.inc", "K"): "a loop's counter",
    ("meshmaker.inc", "VertexVectors"): "declared by files that it writes",
    ("meshmaker.inc", "NormalVectors"): "declared by files that it writes",
    ("meshmaker.inc", "UVVectors"): "declared by files that it writes",
}


def colours() -> str:
    fields = ("red", "green", "blue", "filter", "transmit")
    lines = [f"#declare {row['name']} = {text.colour([_plain(row[f]) for f in fields])};" for row in text.rows(DATA / "colors.tsv")]
    return "\n".join(lines)


def _plain(written: str) -> float:
    value = float(written)
    return int(value) if value == int(value) else value


def constants() -> str:
    return "\n".join(f"#declare {row['name']} = {row['value']};" for row in text.rows(DATA / "consts.tsv"))


def indices() -> str:
    lines = []
    for row in text.rows(DATA / "ior.tsv"):
        name, other, spread = row["name"], row["alias_of"], row["spread"]
        lines.append(f"#declare ior{name} = {f'ior{other}' if other else row['index']};")
        if other:
            lines.append(f"#ifdef (disp{other}) #declare disp{name} = disp{other}; #end")
        elif spread:
            lines.append(f"#declare disp{name} = FnPovDispersion(ior{name}, {spread});")
    return "\n".join(lines)


def scales() -> str:
    """Colour maps of 32 steps; between the figures of the table, colours are interpolated as screens do (sRGB)."""
    parts = []
    for row in text.rows(DATA / "scales.tsv"):
        figures = [[int(c[i:i + 2], 16) / 255 for i in (0, 2, 4)] for c in row["colours"].split()]
        entries = []
        for k in range(33):
            at = k / 32 * (len(figures) - 1)
            low = min(int(at), len(figures) - 2)
            mixed = [a + (b - a) * (at - low) for a, b in zip(figures[low], figures[low + 1])]
            entries.append(f"[{k / 32:g} srgb <{', '.join(f'{c:.4g}' for c in mixed)}>]")
        source = f"\n/// Source: {row['source']}." if row["source"] else ""
        parts.append(f"/// A {row['kind']} scale.{source}\n#declare Scale_{row['name']} = {text.block('color_map', entries)}\n")
    return "\n".join(parts)


def measured_metals() -> str:
    lines = []
    for row in text.rows(DATA / "reflectances.tsv"):
        note = f" ({row['note']})" if row["note"] else ""
        lines.append(f"/// Polished {row['name'].lower()}{note}.\n#declare TM_{row['name']} = texture {{\n"
                     f"  pigment {{ rgb <{row['red']}, {row['green']}, {row['blue']}> }}\n"
                     f"  finish {{ Metal_Finish(<{row['red']}, {row['green']}, {row['blue']}>, 0.002) }}\n}}")
    return "\n".join(lines)


def measured_glasses() -> str:
    lines = []
    for row in text.rows(DATA / "sellmeier.tsv"):
        name, figures = row["name"], ", ".join(row[key] for key in ("b1", "b2", "b3", "c1", "c2", "c3"))
        lines.append(f"/// Index of {name} at a wavelength in micrometres: {row['note']}.\n"
                     f"#declare Index_{name} = function(W) {{ Sellmeier(W, {figures}) }}\n"
                     f"/// The inside of {name}: index in yellow light (587.6 nm), dispersion from red (686.7 nm) to violet (430.8 nm).\n"
                     f"#declare IM_{name} = interior {{ ior Index_{name}(0.5876) dispersion Index_{name}(0.4308) / Index_{name}(0.6867) }}")
    return "\n".join(lines)


def functions() -> str:
    """The internal functions by name, each with its formula."""
    lines = []
    for row in text.rows(DATA / "functions.tsv"):
        steps = [part for part in (row["preamble"], row["intermediate_steps"]) if part and part != "-"]
        where = f" where {'; '.join(steps)}" if steps else ""
        formula = textwrap.wrap(f"{row['result']}{where}.", 96, break_long_words=False, break_on_hyphens=False)
        lines += [*(f"/// {line}" for line in formula), f"#declare {row['name']} = function {{ internal({row['index']}) }}"]
    return "\n".join(lines)


def made() -> dict[str, str]:
    """File → text, for every include that is made from a table."""
    found = {
        "colors.inc": text.include("Colours by name, and colours as hue, saturation and lightness.", "colors.tsv", "Colors_Inc_Temp",
                                   [], colours() + tail("colors"), "colors.inc"),
        "consts.inc": text.include("Constants: refractive indices, angles of view, kinds of maps and media.", "consts.tsv",
                                   "Consts_Inc_Temp", [], constants(), "consts.inc"),
        "functions.inc": text.include(FUNCTIONS, "functions.tsv",
                                      "Functions_Inc_Temp", [], functions() + tail("functions"), "function.inc"),
        "color_scales.inc": text.include("Colour scales for scientific pictures. assumed_gamma must be set before.", "scales.tsv",
                                         "Color_Scales_Inc_Temp", [], scales() + tail("scales"), "color_scales.inc"),
        "metals_measured.inc": text.include(
            "Metals that reflect as measured, for scenes in linear light.\n"
            "/// Source: N. Hoffman, in Real-Time Rendering, 4th edition, 2018, table 9.2; from measured n and k.",
            "reflectances.tsv", "Metals_Measured_Inc_Temp", [], tail("metals_measured").lstrip() + "\n\n" + measured_metals(),
            "metals_measured.inc"),
        "optics.inc": text.include(
            "Glasses and crystals whose index is known for every colour of light.", "sellmeier.tsv", "Optics_Inc_Temp", [],
            head("optics") + measured_glasses(), "optics.inc"),
        "ior.inc": text.include("Refractive indices and dispersions of glasses and gems.", "ior.tsv", "Ior_Inc_Temp", [],
                                head("ior") + indices(), "ior.inc"),
    }
    for path in sorted(DATA.glob("*.json")):
        if path.name == "maps.json":
            continue
        table = json.loads(path.read_text("utf-8"))
        body = "\n".join(map(text.declared, table["declarations"])) + tail(path.stem)
        found[table["include"]] = text.include(table["title"], path.name, table["guard"], table["requires"], body, table["include"])
    for file, entry in json.loads((DATA / "maps.json").read_text("utf-8")).items():
        found[file] = "\n".join(
            [f"/// The colours of a photographed {'stone' if 'marb' in file or 'granit' in file else 'wood'}, from dark to light.",
             "// Made from stdlib/data/maps.json by tools/stdlib.py: change that, not this.",
             f"#declare {entry['guard']} = version;", text.photographed_map(entry), ""])
    return found


def tail(stem: str) -> str:
    """What is written by hand and follows the table."""
    path = DATA / f"{stem}.tail.inc"
    return f"\n\n{path.read_text('utf-8').rstrip()}" if path.exists() else ""


def head(stem: str) -> str:
    return f"{(DATA / f'{stem}.head.inc').read_text('utf-8').rstrip()}\n\n"


def generate() -> int:
    for name, content in made().items():
        (LIBRARY / name).write_text(content, "utf-8")
    return 0


def fresh() -> int:
    stale = 0
    for name, content in made().items():
        path = LIBRARY / name
        there = path.read_text("utf-8") if path.exists() else ""
        if there != content:
            stale += 1
            print("\n".join(list(difflib.unified_diff(there.split("\n"), content.split("\n"), name, "the table", lineterm="", n=1))[:12]))
    print(f"{len(made())} includes, {stale} differ from their tables" + ("; `tools/stdlib.py generate` makes them anew" if stale else ""))
    return 1 if stale else 0


def names() -> int:
    """Every public name of POV-Ray's includes must be declared in the file of the same name, or set by a macro there."""
    missing = []
    rows = [line.split("\t") for line in (programs.ROOT / "tests/includes/names.tsv").read_text("utf-8").splitlines()[1:]]
    texts = {path.name: path.read_text("utf-8") for path in LIBRARY.iterdir() if path.suffix in (".inc", ".map")}
    for include, name, kind in rows:
        words = r"#\s*macro\s+" if kind == "macro" else r"#\s*(declare|local)\s+(deprecated\s+(once\s+)?(\"[^\"]*\"\s*)?)?"
        alone = texts.get(include, "")
        if (include, name) in ABSENT:
            continue
        if not re.search(rf"{words}{re.escape(name)}\b", alone):
            missing.append(f"{include}\t{name}\t{kind}")
    print("\n".join(missing))
    print(f"{len(rows)} names, {len(ABSENT)} not needed, {len(missing)} missing")
    return 1 if missing else 0


def cases() -> int:
    """Macros with a docstring, and those of POV-Ray's includes, have a case: one of tests/language/stdlib-* calls them."""
    text_of_cases = "\n".join(path.read_text("utf-8") for path in (programs.ROOT / "tests" / "language").glob("stdlib-*"))
    rows = [line.split("\t") for line in (programs.ROOT / "tests/includes/names.tsv").read_text("utf-8").splitlines()[1:]]
    macros = {(include, name) for include, name, kind in rows if kind == "macro"} - set(ABSENT)
    for path in sorted(LIBRARY.glob("*.inc")):
        macros |= {(path.name, name) for name in re.findall(r"^///.*\n#macro (\w+)", path.read_text("utf-8"), re.MULTILINE)}
    missing = [f"{include}: {name} has no case" for include, name in sorted(macros) if not re.search(rf"\b{name}\b", text_of_cases)]
    print("\n".join([*missing, f"{len(macros)} macros, {len(missing)} without a case"]))
    return 1 if missing else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    actions = {"generate": generate, "fresh": fresh, "names": names, "cases": cases}
    parser.add_argument("action", choices=actions)
    return actions[parser.parse_args().action]()


if __name__ == "__main__":
    sys.exit(main())
