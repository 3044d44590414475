#!/usr/bin/env python3
"""Random programs that print by #debug: POV-Ray and durer must print the same text.

    tools/differential.py run --count 2000            compare fresh programs; reduce what disagrees
    tools/differential.py run --subject macros --seed 7 --count 1 --show
    tools/differential.py compare FILE...             compare scenes at hand
    tools/differential.py record --count 250          make the stored sample of tests/differential
    tools/differential.py check                       compare durer with the stored sample

Where POV-Ray reports an error, durer must report one too, after the same text. A scene that only
POV-Ray rejects is counted as `lenient`: the language is a superset.
"""

import argparse
import collections
import json
import os
import random
import re
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import answers
import generators
import programs

SAMPLE = programs.ROOT / "tests" / "differential" / "sample.json"
# POV-Ray does not count the arguments of `pow` in functions, and takes what lies beyond.
STRICT = re.compile(r"D0202\]: `pow` takes 2 arguments")
NAN = re.compile(r"-(?=nan)")  # the sign of NaN is an accident of the compiler


def same(oracle: str, durer: str, begins: bool = False) -> bool:
    """Whether both printed the same; `begins`: at least as far as the oracle came."""
    if any(len(line) >= 76 for text in (oracle, durer) for line in text.split("\n")):
        one, two = (re.sub(r"\s+", "", NAN.sub("", text)) for text in (oracle, durer))
    else:
        one, two = (NAN.sub("", text).strip("\n") for text in (oracle, durer))
    return two.startswith(one) if begins else one == two


def verdict(oracle: answers.Printed, durer: answers.Printed) -> str:
    """`same`, `both fail`, or how they disagree.

    `lenient`: only POV-Ray rejects it; `place`: the errors' lines differ; `early`: durer sees the error
    in an earlier line, and what it prints after that is not compared; `strict`: durer rejects what
    POV-Ray should have (STRICT).
    """
    if durer.error == oracle.error == "timed out":
        return "both fail"  # a changed token made a loop endless
    if durer.error and durer.error.startswith(("crashed", "timed out")):
        return "crash"
    if oracle.error is None:
        if durer.error is not None:
            return "strict" if STRICT.search(durer.error) else "rejected"
        return "same" if same(oracle.text, durer.text) else "text"
    place = durer.error is not None and same_place(oracle, durer)
    if not same(oracle.text, durer.text, begins=True):
        early = durer.error is not None and "[D01" in durer.error
        if (place or early) and same(durer.text, oracle.text, begins=True):
            return "both fail"  # what cannot be parsed is found before anything is executed
        if durer.error and durer.line < oracle.line:
            return "early"
        return "rejected" if durer.error and same(durer.text, oracle.text, begins=True) else "text"
    if durer.error is None:
        return "lenient"
    return "both fail" if place or "[D01" in durer.error or not oracle.line else "place"


def same_place(oracle: answers.Printed, durer: answers.Printed) -> bool:
    """Whether both blame one line. In a file that #read reads, durer blames the #read and names the file."""
    if oracle.file and oracle.file != durer.file:
        return Path(oracle.file).name in (durer.error or "")
    return oracle.line == durer.line


BAD = ("text", "rejected", "crash")
ALSO = ("lenient", "place", "early", "strict")


def compare(source: str) -> tuple[str, answers.Printed, answers.Printed]:
    with tempfile.TemporaryDirectory(prefix="durer-") as folder:
        scene = Path(folder) / "program.pov"
        scene.write_text(answers.framed(source), "utf-8")
        oracle = answers.ask_oracle(scene)
        durer = answers.ask_durer(scene)
    return verdict(oracle, durer), oracle, durer


def reduce(source: str, wanted: str) -> str:
    """The shortest program found by leaving out lines that still gets the verdict `wanted`."""
    lines = source.split("\n")
    size = max(1, len(lines) // 2)
    with ThreadPoolExecutor(answers.AT_ONCE) as pool:
        while size >= 1:
            starts = range(0, len(lines), size)
            tries = [lines[:start] + lines[start + size:] for start in starts]
            found = pool.map(lambda part: compare("\n".join(part))[0] == wanted, tries)
            kept = next((part for part, good in zip(tries, list(found)) if good), None)
            if kept is not None:
                lines = kept
                size = min(size, max(1, len(lines) // 2))
            else:
                size //= 2
    return "\n".join(lines)


TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|[A-Za-z_]\w*|\d+\.?\d*(?:e[+-]?\d+)?|\s+|.', re.S)


def mutate(source: str, seed: int) -> str:
    """One token left out, doubled, swapped with a neighbour, or replaced by another of the program."""
    rng = random.Random(seed)
    head, body = source[:len(generators.HEAD)], source[len(generators.HEAD):]
    tokens = TOKEN.findall(body)
    places = [k for k, token in enumerate(tokens) if not token.isspace()]
    k = rng.choice(places)
    how = rng.randrange(4)
    if how == 0:
        tokens[k] = ""
    elif how == 1:
        tokens[k] += " " + tokens[k]
    elif how == 2:
        other = places[(places.index(k) + 1) % len(places)]
        tokens[k], tokens[other] = tokens[other], tokens[k]
    else:
        tokens[k] = tokens[rng.choice(places)]
    return head + "".join(tokens)


def make(seed: int, subject: str | None, mutations: float) -> str:
    source = generators.program(seed, subject)
    return mutate(source, seed) if random.Random(seed).random() < mutations else source


def run(args: argparse.Namespace) -> int:
    seeds = range(args.seed, args.seed + args.count)
    counts: collections.Counter[str] = collections.Counter()
    bad = []

    def one(seed: int):
        source = make(seed, args.subject, args.mutate)
        return seed, source, compare(source)

    with ThreadPoolExecutor(answers.AT_ONCE) as pool:
        for seed, source, (what, oracle, durer) in pool.map(one, seeds):
            counts[what] += 1
            if args.show:
                print(source, oracle, durer, sep="\n")
            if what in BAD or what in args.also:
                bad.append((seed, source, what))
                print(f"{seed}: {what}: oracle {oracle.error or 'fine'} (line {oracle.line}), "
                      f"durer {durer.error or 'fine'} (line {durer.line})", flush=True)
                if what == "text":
                    show_difference(source, oracle, durer)
    for seed, source, what in bad[:args.reduce]:
        small = reduce(source, what)
        found = compare(small)
        print(f"\n--- {seed}, {what}, reduced:\n{small}\noracle: {found[1]}\ndurer:  {found[2]}", flush=True)
    print(", ".join(f"{count} {what}" for what, count in counts.most_common()))
    return 1 if any(counts[what] for what in BAD) else 0


def show_difference(source: str, oracle: answers.Printed, durer: answers.Printed) -> None:
    for one, two in zip(oracle.text.strip("\n").split("\n"), durer.text.strip("\n").split("\n")):
        if one != two:
            tag = f'concat("{one.partition(":")[0]}: "'
            cause = next((line.strip() for line in source.split("\n") if tag in line), "")
            print(f"   {cause}\n   oracle {one}\n   durer  {two}")
            return


def compare_files(args: argparse.Namespace) -> int:
    failed = 0
    for path in args.files:
        what, oracle, durer = compare(path.read_text("utf-8", "surrogateescape"))
        failed += what in BAD
        print(f"{path}: {what}\n  oracle {oracle}\n  durer  {durer}")
    return 1 if failed else 0


def record(args: argparse.Namespace) -> int:
    """Stores programs with what POV-Ray prints; only those on which both agree."""
    def one(seed: int):
        source = make(seed, None, args.mutate)
        return seed, source, compare(source)

    kept, left_out = [], []
    with ThreadPoolExecutor(answers.AT_ONCE) as pool:
        for seed, source, (what, oracle, _) in pool.map(one, range(args.seed, args.seed + args.count)):
            if what in ("same", "both fail"):
                kept.append({"source": source, "prints": oracle.text, "fails": oracle.error is not None})
            else:
                left_out.append(f"{seed} ({what})")
    SAMPLE.parent.mkdir(parents=True, exist_ok=True)
    SAMPLE.write_text(json.dumps(kept, indent=0) + "\n", "utf-8")
    print(f"{len(kept)} programs kept; left out: {', '.join(left_out) or 'none'}")
    return 0


def check(_: argparse.Namespace) -> int:
    cases = json.loads(SAMPLE.read_text("utf-8"))

    def one(case: dict) -> str:
        with tempfile.TemporaryDirectory(prefix="durer-") as folder:
            scene = Path(folder) / "program.pov"
            scene.write_text(answers.framed(case["source"]), "utf-8")
            durer = answers.ask_durer(scene)
        return verdict(answers.Printed(case["prints"], "error" if case["fails"] else None, 0), durer) \
            if durer.error != "timed out" else "crash"

    failed = 0
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for case, what in zip(cases, pool.map(one, cases)):
            if what not in ("same", "both fail"):
                failed += 1
                print(f"{what}:\n{case['source']}\nexpected:\n{case['prints']}", file=sys.stderr)
    print(f"{len(cases)} programs, {failed} disagree")
    return 1 if failed else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    for name, action in (("run", run), ("record", record)):
        command = commands.add_parser(name)
        command.set_defaults(action=action)
        command.add_argument("--count", type=int, default=250)
        command.add_argument("--seed", type=int, default=1)
        command.add_argument("--mutate", type=float, default=0.2, metavar="SHARE", help="of programs with one token changed")
        if name == "run":
            command.add_argument("--subject", choices=list(generators.SUBJECTS))
            command.add_argument("--reduce", type=int, default=5, metavar="N", help="disagreements to reduce (default 5)")
            command.add_argument("--show", action="store_true", help="print programs and answers")
            command.add_argument("--also", nargs="*", default=[], choices=ALSO, help="list these too")
    command = commands.add_parser("compare")
    command.set_defaults(action=compare_files)
    command.add_argument("files", nargs="+", type=Path)
    commands.add_parser("check").set_defaults(action=check)
    args = parser.parse_args()
    if args.action is not check and not programs.oracle_path():
        print(f"differential: POV-Ray is not installed; {programs.HOW_TO_INSTALL_ORACLE}", file=sys.stderr)
        return 2
    return args.action(args)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
