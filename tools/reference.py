#!/usr/bin/env python3
"""The pages of docs/reference: what `durer doc` knows, with swatches.

    tools/reference.py pages      write the pages (the swatches are left as they are)
    tools/reference.py all        render the swatches too
    tools/reference.py fresh      fail if a page is not what `durer doc --json` says
"""

import argparse
import json
import subprocess
import sys
from pathlib import Path

import programs
import swatches

FOLDER = programs.ROOT / "docs" / "reference"
LANGUAGE = (("object", "Objects"), ("pattern", "Patterns"), ("warp", "Warps"), ("directive", "Directives"), ("function", "Functions"))
SHOWN = ("colour", "texture", "pigment", "finish", "interior", "material", "colour map", "sky sphere", "object", "normal")


def known() -> list[dict]:
    done = subprocess.run([str(programs.durer_path()), "doc", "--json"], capture_output=True, check=True)
    return json.loads(done.stdout)


def explained(entry: dict) -> str:
    """An entry as a section."""
    lines = [f"### {entry['name']}", "", f"`{entry['usage']}`", ""]
    prose, example = [], []
    for line in entry["text"]:
        if line.startswith("Example:"):
            example.append(line.removeprefix("Example:").strip())
        else:
            prose.append(line)
    lines.append("  \n".join(prose) if len(prose) < 3 else "\n".join([prose[0], "", *(f"- {line}" for line in joined(prose[1:]))]))
    if example:
        lines += ["", "```", *example, "```"]
    return "\n".join(lines) + "\n"


def joined(lines: list[str]) -> list[str]:
    """Lines that begin in small letters go on with the one before."""
    out: list[str] = []
    for line in lines:
        if out and not line[:1].isupper() and ":" not in line.split(" ")[0]:
            out[-1] += f" {line}"
        else:
            out.append(line)
    return out


def sheet(name: str, sheets: Path) -> list[str]:
    """A picture of swatches, and their names as text, to be found; nothing if there is none."""
    if not (sheets / f"{name}.jpg").exists():
        return []
    names = json.loads((sheets / "index.json").read_text("utf-8"))[name]
    return [f"![swatches](swatches/{name}.jpg)\n", " ".join(f"`{one}`" for one in names) + "\n"]


def language_page(title: str, entries: list[dict]) -> str:
    parts = [f"# {title}\n", "[Reference](README.md)\n", *sheet(title.lower(), FOLDER / "swatches")]
    return "\n".join(parts + [explained(entry) for entry in sorted(entries, key=lambda e: e["name"])])


def include_page(include: str, entries: list[dict], sheets: Path) -> str:
    head = next((e for e in entries if e["kind"] == "include"), None)
    parts = [f"# {include}\n", "[Reference](README.md)\n", "\n".join(head["text"]) + "\n" if head else "", f"`#include \"{include}\"`\n"]
    macros = [e for e in entries if e["kind"] == "macro"]
    plain = [e for e in entries if e["kind"] not in ("macro", "include")]
    parts += sheet(include, sheets)
    parts += [f"![{p.stem}](swatches/{p.name})\n" for p in sorted(sheets.glob(f"{include}-*.jpg"))]
    if macros:
        parts += ["## Macros\n", *map(explained, macros)]
    told = [e for e in plain if e["text"] or e["kind"] not in SHOWN]
    if told:
        parts += ["## Names\n", "| name | kind | |", "|---|---|---|"]
        parts += [f"| `{e['name']}` | {e['kind']} | {' '.join(e['text']).replace('|', '&#124;') or short(e['value'])} |" for e in told]
    return "\n".join(parts).rstrip() + "\n"


def short(value: str) -> str:
    line = value.split("\n")[0].rstrip(";")
    return f"`{line}`" if len(line) < 60 else ""


def pages() -> dict[str, str]:
    """File → text, for every page."""
    entries = known()
    made, index = {}, ["# Reference\n", "What the language and its library know; `durer doc NAME` tells the same. `make reference` writes these pages.\n", "## The language\n"]
    for kind, title in LANGUAGE:
        of = [e for e in entries if e["kind"] == kind and not e["place"]]
        made[f"{title.lower()}.md"] = language_page(title, of)
        index.append(f"- [{title}]({title.lower()}.md): {len(of)}")
    index += ["", "## The standard library\n", "| include | what is in it | names |", "|---|---|--:|"]
    for include in sorted({e["place"] for e in entries if e["place"]}):
        of = [e for e in entries if e["place"] == include]
        # The registry tells the parameters of a built-in function, the library its formula.
        formulas = {e["name"]: e for e in of if e["value"]}
        for e in of:
            if not e["value"] and not e["text"] and e["name"] in formulas:
                formulas[e["name"]]["text"] = [f"`{e['usage']}`:", *formulas[e["name"]]["text"]]
        of = [e for e in of if e["value"] or e["kind"] in ("macro", "include")]
        made[f"{include}.md"] = include_page(include, of, FOLDER / "swatches")
        title = next((e["text"][0] for e in of if e["kind"] == "include" and e["text"]), "")
        index.append(f"| [{include}]({include}.md) | {title} | {sum(e['kind'] != 'include' for e in of)} |")
    made["README.md"] = "\n".join(index) + "\n"
    return made


def write() -> int:
    FOLDER.mkdir(parents=True, exist_ok=True)
    made = pages()
    for old in FOLDER.glob("*.md"):
        if old.name not in made:
            old.unlink()
    for name, content in made.items():
        (FOLDER / name).write_text(content, "utf-8")
    print(f"{len(made)} pages in {FOLDER}")
    return 0


def fresh() -> int:
    stale = [name for name, content in pages().items() if not (FOLDER / name).exists() or (FOLDER / name).read_text("utf-8") != content]
    print(f"{len(stale)} pages are stale; `make reference` writes them anew: {' '.join(stale)}" if stale else "all pages are fresh")
    return 1 if stale else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["pages", "all", "fresh"])
    action = parser.parse_args().action
    if action == "fresh":
        return fresh()
    failed = swatches.draw(FOLDER / "swatches") if action == "all" else 0
    return write() or failed


if __name__ == "__main__":
    sys.exit(main())
