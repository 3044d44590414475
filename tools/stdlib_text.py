"""The text of the standard includes that are made from tables; stdlib/data/README.md tells their format."""

import csv
import json
import struct
from pathlib import Path

WIDTH = 100  # columns that a line of an include should not exceed


def number(value: float) -> str:
    return str(value)


def vector(value) -> str:
    return f"<{', '.join(map(number, value))}>" if isinstance(value, list) else number(value)


def colour(value: list[float]) -> str:
    """`rgb`, `rgbf`, `rgbt` or `rgbft`, whichever needs the fewest numbers."""
    red, green, blue, filtered, transmitted = value
    if transmitted and filtered:
        return f"rgbft {vector(value)}"
    if transmitted:
        return f"rgbt {vector([red, green, blue, transmitted])}"
    return f"rgbf {vector(value[:4])}" if filtered else f"rgb {vector(value[:3])}"


def light(value) -> str:
    """An amount that may be grey (one number) or a colour."""
    return colour(value) if isinstance(value, list) else number(value)


def block(word: str, parts: list[str], indent: int = 0) -> str:
    """`word { a b c }` in one line if it fits, else each part in a line of its own."""
    line = f"{word} {{ {' '.join(parts)} }}"
    if indent + len(line) <= WIDTH and "\n" not in line:
        return line
    pad = "  "
    inner = [part.replace("\n", f"\n{pad}") for part in parts]
    return f"{word} {{\n{pad}" + f"\n{pad}".join(filled(inner, WIDTH - indent - 2)) + "\n}"


def filled(parts: list[str], width: int) -> list[str]:
    """Short parts side by side, as many in a line as fit."""
    lines: list[str] = []
    for part in parts:
        if lines and "\n" not in lines[-1] + part and len(lines[-1]) + 1 + len(part) <= width:
            lines[-1] += f" {part}"
        else:
            lines.append(part)
    return lines


def color_map(value, indent: int = 2) -> str:
    if isinstance(value, dict):
        return f"color_map {{ {value['ref']} }}"
    return block("color_map", [f"[{number(key)} {colour(entry)}]" for key, entry in value], indent)


def pattern_item(item: list) -> str:
    word, *rest = item
    if word == "base":
        return rest[0]
    if word == "color":
        return colour(rest[0])
    if word == "pattern":
        return " ".join([rest[0], *(number(a[1]) if isinstance(a, list) and a[0] == "amount" else vector(a) for a in rest[1:])])
    if word == "color_map":
        return color_map(rest[0])
    if word == "pigment_map":
        return block("pigment_map", [f"[{number(key)} {' '.join(map(pattern_item, items))}]" for key, items in rest[0]], 2)
    return " ".join([word, *map(vector, rest)])


def finish(value: dict, indent: int = 2) -> str:
    parts = []
    for word, amount in value.items():
        if word == "base":
            parts.append(amount)
        elif word == "conserve_energy" or (word == "metallic" and amount == 1):
            parts.append(word)
        elif word == "reflection" and isinstance(amount, dict):
            fresnel = ["fresnel"] if amount.get("fresnel") else []
            parts.append(f"reflection {{ {' '.join([light(amount['min']) + ',', light(amount['max']), *fresnel])} }}")
        else:
            parts.append(f"{word} {light(amount)}")
    return block("finish", parts, indent)


def texture_item(item: list) -> str:
    word, *rest = item
    if word in ("pigment", "normal"):
        return block(word, list(map(pattern_item, rest[0])), 2)
    return finish(rest[0]) if word == "finish" else pattern_item(item)


def layers(value: list, indent: int = 0) -> str:
    return "\n".join(block("texture", list(map(texture_item, layer)), indent) for layer in value)


def interior(value: dict) -> str:
    return block("interior", [amount if word == "base" else f"{word} {number(amount)}" for word, amount in value.items()])


def operation(item: list) -> str:
    word, *rest = item
    if word in ("bounded_by", "clipped_by"):
        return block(word, [rest[0]] if isinstance(rest[0], str) else list(map(solid, rest[0])))
    return " ".join([word, *map(vector, rest)])


def solid(node: dict, indent: int = 0) -> str:
    """An object and all inside it."""
    kind = node["type"]
    operands = {
        "box": lambda: [", ".join(map(vector, node["corners"]))],
        "triangle": lambda: [", ".join(map(vector, node["corners"]))],
        "cylinder": lambda: [f"{', '.join(map(vector, node['ends']))}, {number(node['radius'])}"],
        "cone": lambda: [", ".join(vector(node[key]) for key in ("end1", "radius1", "end2", "radius2"))],
        "sphere": lambda: [f"{vector(node['center'])}, {number(node['radius'])}"],
        "plane": lambda: [f"{vector(node['normal'])}, {number(node['distance'])}"],
        "quadric": lambda: [", ".join(vector(node[key]) for key in ("A_B_C", "D_E_F", "G_H_I", "J"))],
        "quartic": lambda: [f"<{coefficients(node)}>"],
        "poly": lambda: [f"{node['order']}, <{coefficients(node)}>"],
        "object": lambda: [node["ref"]],
    }
    parts = operands[kind]() if kind in operands else list(map(solid, node["children"]))
    if "texture" in node:
        parts.append(layers(node["texture"]))
    return block(kind, parts + list(map(operation, node.get("ops", []))), indent)


def coefficients(node: dict) -> str:
    return "\n    ".join(filled([f"{number(c)}," for c in node["coefficients"]], WIDTH - 8)).rstrip(",")


def value_of(declaration: dict, indent: int) -> str:
    """What stands behind the `=`, which is in column `indent`."""
    kind = declaration["kind"]
    if kind == "texture":
        return layers(declaration["layers"], indent)
    if kind == "sky_sphere":
        return block(kind, [block("pigment", list(map(pattern_item, items)), 2) for items in declaration["pigments"]], indent)
    value = declaration["value"]
    if kind in ("pigment", "normal"):
        return block(kind, list(map(pattern_item, value)), indent)
    if kind == "material":
        return block(kind, [layers(value["texture"]), interior(value["interior"])], indent)
    plain = {"float": number, "vector": vector, "color": colour, "interior": interior}
    blocks = {"color_map": color_map, "finish": finish, "object": solid}
    return plain[kind](value) if kind in plain else blocks[kind](value, indent)


def declared(declaration: dict) -> str:
    semicolon = ";" if declaration["kind"] in ("float", "vector", "color") else ""
    start = f"#declare {declaration['name']} = "
    if declaration.get("deprecated"):
        start = f'#declare deprecated once "use a material, not the texture {declaration["name"]}"\n  {declaration["name"]} = '
    return f"{start}{value_of(declaration, len(start.split(chr(10))[-1]))}{semicolon}"


def include(title: str, source: str, guard: str, requires: list[str], body: str, name: str) -> str:
    """A whole file: what it is, the guard, and the body inside it."""
    return "\n".join([
        f"/// {title}",
        f"// Made from stdlib/data/{source} by tools/stdlib.py: change that, not this.",
        f"#ifndef ({guard})",
        f"#declare {guard} = version;",
        "#if (version < 3.5) #version 3.5; #end",
        f'#ifdef (View_POV_Include_Stack) #debug "including {name}\\n" #end',
        *(f'#include "{file}"' for file in requires),
        "",
        body.rstrip(),
        "",
        f"#if ({guard} < 3.5) #version {guard}; #end",
        f"#end  // {guard}",
        ""])


def rows(path: Path) -> list[dict]:
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file, delimiter="\t"))


def photographed_map(entry: dict) -> str:
    """A map of 255 colours, given as bytes; keys and colours are printed with the digits they had in single precision."""
    def part(byte: int) -> str:
        return number(round(struct.unpack("f", struct.pack("f", byte / 255))[0], entry["digits"]))

    colours = " ".join(entry["colours"]).split()
    entries = [f"[{part(k)} rgb <{', '.join(part(int(c[i:i + 2], 16)) for i in (0, 2, 4))}>]" for k, c in enumerate(colours)]
    return f"#declare {entry['name']} = {block('color_map', entries)}"
