#!/usr/bin/env python3
"""The standard includes: durer must load them all and evaluate their names.

    tools/includes.py check [INCLUDE...]   durer, with its own library, on every include, name and call of tests/includes
    tools/includes.py verify               POV-Ray, with its own, on the same
    tools/includes.py search               find calls of macros that POV-Ray accepts, into calls.tsv

tests/includes/names.tsv lists the names that each include declares, calls.tsv a use of each macro.
What waits for a feature that is not there yet stands in `known.tsv`, one line for each use and
feature. Any other failure, and a line that is no longer true, is an error.
"""

import argparse
import collections
import os
import re
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import answers
import programs

FOLDER = programs.ROOT / "tests" / "includes"
INCLUDES = programs.INCLUDES
HEAD = """#version 3.7; global_settings { assumed_gamma 1 }
#declare A_f = 0.5; #declare A_v = <1,2,3>; #declare A_s = "text"; #declare A_o = sphere { 0, 1 }
#declare A_c = rgb <0.2,0.4,0.6>; #declare A_r = seed(1); #declare A_a = array[3] { 3, 1, 2 } #declare A_n = 2;
#declare A_t = texture { pigment { rgb 1 } } #declare A_p = pigment { rgb 1 } #declare A_i = finish { phong 1 }
#declare A_m = transform { scale 2 } #declare A_b = array[3] { <0,0,0>, <1,0,0>, <1,1,0> } #declare A_u = <1,2>;
"""
NEEDS = {"shapes2.inc": "shapes.inc", "shapesq.inc": "shapes.inc"}  # what a file uses without including it
NEEDS |= dict.fromkeys(("skies.inc", "stoneold.inc", "stones.inc", "stones1.inc", "stones2.inc"), "colors.inc")
AFTER = '#ifndef (A_l) #declare A_l = spline { linear_spline 0, <0,0,0> 1, <1,2,3> } #declare A_k = function { x + y*y + z } #end\n'
CONTEXTS = ("{}", "#declare R_ = {};", "object {{ {} }}", "sphere {{ 0, 1 {} }}", "sphere {{ 0, 1 pigment {{ {} }} }}", "#debug {}")
HINTS = (("obj|Obj", "A_o"), ("Tex", "A_t"), ("Pig", "A_p"), ("Fin", "A_i"), ("Colou?r|RGB|HSL|HSV|^C$|Clr", "A_c"),
         ("Str|Text|File|Font|Name|Txt", "A_s"), ("Arr", "A_a"), ("Stream|^RS|Rand|Seed|rd", "A_r"),
         ("Trans", "A_m"), ("Spl", "A_l"), ("Fn|Func|^F$", "A_k"), ("Num|Count|Res|^N|Steps", "A_n"),
         ("^V|Vec|Vert|Axis|Dir|Pt|Point|^P\\d?$|Loc|Pos|^A$|^B$|Norm|End|Start|Min|Max|Corner|Center", "A_v"))
KINDS = ("A_f", "A_v", "A_n", "A_s", "A_o", "A_c", "A_a", "A_r", "A_t", "A_k", "A_m", "A_p", "A_b", "A_u", "A_l", "A_i")
TRIES = 48  # calls tried before a macro is given up


def rows(name: str) -> list[list[str]]:
    path = FOLDER / name
    return [line.split("\t") for line in path.read_text("utf-8").splitlines()[1:]] if path.exists() else []


def ask(source: str, program) -> answers.Printed:
    with tempfile.TemporaryDirectory(prefix="durer-") as folder:
        scene = Path(folder) / "case.pov"
        scene.write_text(answers.framed(source), "utf-8")
        return program(scene)


def inclusion(include: str) -> str:
    """The directives that read an include, in one line."""
    before = f'#include "{NEEDS[include]}" ' if include in NEEDS else ""
    return f'{before}#include "{include}"'


def load_source(include: str, names: list[str]) -> str:
    """Includes a file and uses each of the names that are there, one in a line."""
    lines = [HEAD + inclusion(include)]
    lines += [f'#ifdef ({name}) #declare T_{name} = {name}; #else #debug "{name} " #end' for name in names]
    return "\n".join(lines) + '\n#debug "\\n"'


def call_source(include: str, call: str) -> str:
    return f"{HEAD}{inclusion(include)}\n{AFTER}{call}"


def judge_names(include: str, names: list[str], program) -> list[tuple[str, str]]:
    """The names whose use fails, each with the reason."""
    failed, left = [], list(names)
    while True:
        got = ask(load_source(include, left), program)
        if got.error is None:
            return failed
        at = got.line - 1 - HEAD.count("\n") - 1
        if got.file not in ("", "case.pov") or not 0 <= at < len(left):
            return [*failed, (f"({include})", f"{got.error} at {got.file}:{got.line}")]
        failed.append((left.pop(at), got.error))


def judge(program) -> list[tuple[str, str, str]]:
    by_include = collections.defaultdict(list)
    for include, name, kind in rows("names.tsv"):
        if kind == "declare":
            by_include[include].append(name)
    wrong = []
    with ThreadPoolExecutor(answers.AT_ONCE if program is answers.ask_oracle else os.cpu_count() or 1) as pool:
        found = pool.map(lambda item: judge_names(item[0], item[1], program), by_include.items())
        for include, failed in zip(by_include, found):
            wrong += [(include, name, reason) for name, reason in failed]
        # POV-Ray's fonts come with its includes.
        calls = [row for row in rows("calls.tsv") if ".ttf" not in row[2] or INCLUDES.exists()]
        for (include, name, call), got in zip(calls, pool.map(lambda row: ask(call_source(row[0], row[2]), program), calls)):
            if got.error is not None:
                wrong.append((include, f"{name}()", got.error))
    return wrong


def missing_feature(reason: str) -> str:
    """What a D0220 says is not there; empty for any other failure."""
    found = re.search(r"D0220\]: (.*) is not supported yet", reason)
    return found[1] if found else ""


def check(program) -> int:
    known = {tuple(row) for row in rows("known.tsv")} if program is answers.ask_durer else set()
    waiting, bad = set(), []
    for include, name, reason in judge(program):
        row = (include, name, missing_feature(reason))
        if row in known:
            waiting.add(row)
        else:
            bad.append(f"{include}\t{name}\t{reason}")
    bad += ["\t".join(row) + ": is there now, and needs no line in known.tsv" for row in sorted(known - waiting)]
    print("\n".join(bad))
    for feature, count in collections.Counter(row[2] for row in waiting).most_common():
        print(f"later: {count} x {feature}")
    print(f"{len(rows('names.tsv'))} names, {len(rows('calls.tsv'))} calls: {len(bad)} fail, {len(waiting)} wait for features")
    return 1 if bad else 0


def parameters(include: str, macro: str) -> list[str] | None:
    text = (INCLUDES / include).read_text("latin-1")
    found = re.search(rf"#macro\s+{re.escape(macro)}\s*\(([^)]*)\)", text)
    return re.findall(r"\w+", found[1]) if found else None


def guesses(names: list[str]):
    """Argument lists to try, the likeliest first."""
    first = [next((value for pattern, value in HINTS if re.search(pattern, name)), "A_f") for name in names]
    yield first
    for kind in ("A_f", "A_v"):
        yield [kind] * len(names)
    for k in range(len(names)):
        for kind in KINDS:
            if kind != first[k]:
                yield [*first[:k], kind, *first[k + 1:]]


def find_call(row: list[str]) -> str | None:
    include, macro, _ = row
    names = parameters(include, macro)
    if names is None:
        return None
    tries = 0
    for arguments in guesses(names):
        for context in CONTEXTS:
            call = context.format(f"{macro}({', '.join(arguments)})")
            tries += 1
            if tries > TRIES:
                return None
            if ask(call_source(include, call), answers.ask_oracle).error is None:
                return call


def search() -> int:
    known = {(include, name) for include, name, _ in rows("calls.tsv")}
    macros = [row for row in rows("names.tsv") if row[2] == "macro" and (row[0], row[1]) not in known]
    with ThreadPoolExecutor(answers.AT_ONCE) as pool, open(FOLDER / "calls.tsv", "a", encoding="utf-8") as out:
        if not known:
            out.write("include\tname\tcall\n")
        for (include, name, _), call in zip(macros, pool.map(find_call, macros)):
            if call:
                out.write(f"{include}\t{name}\t{call}\n")
                out.flush()
            else:
                print(f"{include}: no call found for {name}", flush=True)
    return 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["check", "verify", "search"])
    args = parser.parse_args()
    if args.action != "check" and not INCLUDES.exists():
        print(f"includes: {INCLUDES} is not there; {programs.HOW_TO_INSTALL_ORACLE}", file=sys.stderr)
        return programs.SKIPPED
    if args.action == "search":
        return search()
    return check(answers.ask_durer if args.action == "check" else answers.ask_oracle)


if __name__ == "__main__":
    sys.exit(main())
