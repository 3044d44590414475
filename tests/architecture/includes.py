"""Checks every #include of the house against its plan (docs/architecture.md).

Three rules: a folder includes only the folders below it; of these only their public headers; and
outside libraries are met only where the plan says. Usage: includes.py ROOT; exit 1 if a rule is broken.
"""

import re
import sys
from pathlib import Path

BELOW = {
    "base": set(),
    "functions": {"base"},
    "scene": {"base", "functions"},
    "grammar": {"base"},
    "interpreter": {"base", "functions", "scene", "grammar"},
    "image": {"base"},
    "tracer": {"base", "functions", "scene", "image"},
    "cli": {"base", "functions", "scene", "grammar", "interpreter", "image", "tracer"},
}
# Folders that are not listed are public as a whole.
PUBLIC = {
    "grammar": {"ast.h", "parse.h", "vocabulary.h", "vocabulary.def"},
    "interpreter": {"interpret.h"},
    "tracer": {"compile.h", "render.h", "object_queries.h", "pigment_queries.h"},
    "image": {"image.h", "read.h"},
    "cli": set(),
}
# Where the headers of a library may be included: paths that begin so.
LIBRARIES = {
    "tao/pegtl": ["grammar/"],
    "embree": ["tracer/accel/embree_api.h"],
    "tbb/": ["tracer/film/", "image/png_rows.cpp"],
    "oneapi/tbb": ["tracer/film/"],
    "OpenImageIO": ["image/"],
    "CLI/": ["cli/"],
    "ft2build.h": ["interpreter/font.cpp"],
    "nlohmann/": ["cli/"],
    "catch2": ["tests/support/"],
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def broken(source: str, mark: str, header: str) -> str:
    """What is wrong with `header` in the file `source`, or nothing."""
    if mark == "<":
        for library, places in LIBRARIES.items():
            if header.startswith(library) and not any(source.startswith(place) for place in places):
                return f"is for {' and '.join(places)} only"
        return ""
    here, there = source.split("/")[0], header.split("/")[0]
    if "/" not in header:
        return "must be written from the root of the project"
    if there not in BELOW or here == there:
        return ""
    if there not in BELOW[here]:
        return f"is above or beside {here}/"
    if there in PUBLIC and header.split("/", 1)[1] not in PUBLIC[there]:
        return f"is private to {there}/"
    return ""


def main() -> int:
    root = Path(sys.argv[1])
    problems, count = [], 0
    for folder in BELOW:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp", ".def"):
                continue
            source = path.relative_to(root).as_posix()
            text = path.read_text("utf-8")
            for found in INCLUDE.finditer(text):
                count += 1
                if problem := broken(source, found[1], found[2]):
                    line = text.count("\n", 0, found.start(1)) + 1
                    problems.append(f"{source}:{line}: {found[2]} {problem}")
    print(*problems, sep="\n")
    print(f"{count} includes, {len(problems)} against the plan")
    return 1 if problems or not count else 0


if __name__ == "__main__":
    sys.exit(main())
