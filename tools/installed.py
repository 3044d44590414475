#!/usr/bin/env python3
"""The installed program, with neither its source nor its build tree nor a package of POV-Ray to be seen.

    tools/installed.py BUILD     installs the build tree BUILD, under a prefix and as a package would,
                                 and asks the programs there for the library

Exit codes: 0 all is found, 1 something is not, 77 folders cannot be hidden here.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import programs
import stdlib

SCENE = """#version 3.7; global_settings { assumed_gamma 1 }
#include "stdinc.inc"
#include "textures.inc"
camera { location -4 * z look_at 0 } light_source { <-5, 8, -9> White }
plane { z, 2 pigment { image_map { png "test.png" } } }
object { Round_Box(<-1, -1, -1>, <1, 1, 1>, 0.2, no) texture { Jade } }
"""
LAYOUTS = (("a prefix", ["--prefix", "{}/opt/durer"], "opt/durer"), ("a package", ["--prefix", "/usr"], "usr"))


def problems(top: Path, before: tuple[str, ...]) -> list[str]:
    """What the program installed below `top` does not do."""
    def run(*words: str) -> subprocess.CompletedProcess:
        return subprocess.run([*before, str(top / "bin" / "durer"), *words], capture_output=True, text=True, cwd=top.parent)

    found = []
    wanted, told = top / "share" / "durer" / "include", run("--print-stdlib-path").stdout.strip()
    if told != str(wanted):
        found.append(f"--print-stdlib-path tells {told or 'nothing'}, not {wanted}")
    ours = [p.relative_to(stdlib.LIBRARY) for p in stdlib.LIBRARY.rglob("*")
            if p.is_file() and "data" not in p.parts[len(stdlib.LIBRARY.parts):] and p.suffix != ".md"]
    missing = [str(name) for name in ours if not (wanted / name).exists()]
    if missing:
        found.append(f"not installed: {' '.join(missing)}")
    (top.parent / "scene.pov").write_text(SCENE, "utf-8")
    done = run("+Iscene.pov", "+Oscene.png", "+W64", "+H48", "-D")
    if done.returncode != 0 or not (top.parent / "scene.png").exists():
        found.append(f"a scene with includes: {programs.first_error(done.stderr)}")
    elif "`test.png`; one that stands in" not in done.stderr:
        found.append("no warning tells that a picture stands in for POV-Ray's")
    if "texture of stones1.inc" not in (explained := run("doc", "T_Stone1").stdout):
        found.append(f"`durer doc T_Stone1` says: {explained[:200]}")
    return found


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    build = Path(sys.argv[1]).absolute()
    before = programs.without_oracle(programs.ROOT / "stdlib", build)
    if not before:
        print(f"SKIPPED: {programs.CANNOT_HIDE_ORACLE}")
        return programs.SKIPPED
    failed = 0
    for name, options, top in LAYOUTS:
        with tempfile.TemporaryDirectory(prefix="durer-") as folder:
            root = ["env", f"DESTDIR={folder}"] if name == "a package" else []
            subprocess.run([*root, "cmake", "--install", str(build), *(word.format(folder) for word in options)],
                           check=True, capture_output=True)
            found = problems(Path(folder) / top, before)
            failed += bool(found)
            print(f"installed under {name}: {'; '.join(found) or 'the library is found, a scene is rendered, doc explains'}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
