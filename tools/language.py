#!/usr/bin/env python3
"""The tests of tests/language: scenes that hold what they must print.

    tools/language.py check [FILE...]     durer against the expectations
    tools/language.py verify [FILE...]    POV-Ray against the same expectations
    tools/language.py record [FILE...]    write the expectations of cases that have none, from POV-Ray
    tools/language.py rows                every row of tests/language/rows.tsv must have a case

A file is a prelude and cases, each begun by a line `//= what it shows`. A case is run alone, with the
prelude and the places of the lines as they are in the file. What must come of it follows it:

    // expect: TEXT            a line printed by #debug, in order
    // error: CODE at LINE:COLUMN   it ends with this diagnostic; lines count from the title
    // beyond                  POV-Ray reports an error here; what is expected is our own
    // before                  POV-Ray fails too, but elsewhere: later in the text or in another file
    // later: WHAT; WHAT       POV-Ray does it; we say that we cannot do this yet (D0220)
    // chatty                  the includes of both programs print more: only lines that begin with `= ` count
    // each: WORD...           the case stands for many: `@` is one of these words in turn

Files that scenes include or read are in tests/language/files; `verify` needs POV-Ray, `check` does not.
Scenes of version 3.8 (`.scene`) are beyond POV-Ray 3.7: nobody verifies them.
"""

import argparse
import collections
import functools
import os
import re
import shlex
import shutil
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

import answers
import programs

FOLDER = programs.ROOT / "tests" / "language"
MARKS = re.compile(r"// (expect|error|beyond|before|later|chatty|each)(?:: ?(.*))?$")
NOT_YET = "D0220"


@dataclass
class Case:
    """One case: its title, the lines it takes in its file (counted from 0), and what must come of it."""

    path: Path
    title: str
    first: int
    last: int
    source: str
    prints: list[str]
    error: str
    beyond: bool
    before: bool
    chatty: bool
    later: tuple[str, ...]

    @property
    def recorded(self) -> bool:
        return bool(self.prints or self.error or self.beyond)

    @property
    def file(self) -> str:
        """The name under which it runs."""
        return f"case{self.path.suffix}"

    def standing_for(self, word: str) -> "Case":
        return replace(self, title=self.title.replace("@", word), source=self.source.replace("@", word),
                       prints=[line.replace("@", word) for line in self.prints])

    def name(self) -> str:
        return f"{self.path.name}:{self.first + 1}: {self.title}"


def cases_of(path: Path) -> list[Case]:
    lines = path.read_text("utf-8").split("\n")
    starts = [k for k, line in enumerate(lines) if line.startswith("//=")]
    found = []
    for k, start in enumerate(starts):
        end = starts[k + 1] if k + 1 < len(starts) else len(lines)
        kept, marks = [], collections.defaultdict(list)
        for number, line in enumerate(lines):
            inside = number < starts[0] or start <= number < end
            mark = MARKS.fullmatch(line) if inside else None
            if mark:
                marks[mark[1]].append(mark[2] or "")
            kept.append(line if inside and not mark else "")
        case = Case(path, lines[start][3:].strip(), start, end, "\n".join(kept).rstrip("\n"), marks["expect"],
                    next(iter(marks["error"]), ""), "beyond" in marks, "before" in marks, "chatty" in marks,
                    tuple(what.strip() for line in marks["later"] for what in line.split(";")))
        words = [word for line in marks["each"] for word in shlex.split(line)]
        found += [case.standing_for(word) for word in words] if words else [case]
    return found


def ask(case: Case, program) -> answers.Printed:
    with tempfile.TemporaryDirectory(prefix="durer-") as folder:
        shutil.copytree(FOLDER / "files", folder, dirs_exist_ok=True)
        scene = Path(folder) / case.file
        scene.write_text(answers.framed(case.source), "utf-8")
        return program(scene)


def lines_of(text: str) -> list[str]:
    return [line.rstrip() for line in text.removesuffix("\n").split("\n")] if text.strip("\n") else []


def told(case: Case, printed: answers.Printed) -> list[str]:
    """What a program printed because the case says so."""
    return [line for line in lines_of(printed.text) if not case.chatty or line.startswith("= ")]


def error_of(case: Case, durer: answers.Printed) -> str:
    code = re.search(r"D\d{4}", durer.error or "")
    if durer.file not in ("", case.file):
        return f"{code[0] if code else durer.error} at {durer.file}:{durer.line}:{durer.column}"
    line = durer.line - case.first - 1 if durer.line else 0
    return f"{code[0] if code else durer.error} at {line}:{durer.column}" if durer.error else ""


waiting: set[tuple[Path, int, str]] = set()  # what cases are known to wait for, and do


def judge_durer(case: Case) -> str | None:
    """What is wrong, or None."""
    if not case.recorded:
        return "has no expectation; see `language.py record`"
    durer = ask(case, answers.ask_durer)
    if told(case, durer) != case.prints:
        return f"printed {told(case, durer)}, expected {case.prints}" + (f"; {durer.error}" if durer.error else "")
    if NOT_YET in (durer.error or ""):
        for what in case.later:
            if what in (durer.error or ""):
                waiting.add((case.path, case.first, what))
                return None
    if error_of(case, durer) != case.error:
        return f"{durer.error or 'no error'} ({error_of(case, durer)}), expected {case.error or 'none'}"
    return None


def judge_oracle(case: Case) -> str | None:
    if case.path.suffix == ".scene":
        return None
    oracle = ask(case, answers.ask_oracle)
    if case.beyond:
        return None if oracle.error else "POV-Ray accepts this; it is not beyond it"
    if (oracle.error is not None) != bool(case.error):
        return f"POV-Ray: {oracle.error or 'no error'}"
    if not case.error and told(case, oracle) != case.prints:
        return f"POV-Ray printed {told(case, oracle)}, not {case.prints}"
    if case.error and not case.before and oracle.line and oracle.line != int(re.search(r" at (-?\d+)", case.error)[1]) + case.first + 1:
        return f"POV-Ray reports line {oracle.line}: {oracle.error}"
    return None


def judge_all(paths: list[Path], judge) -> int:
    cases = [case for path in paths for case in cases_of(path)]
    workers = answers.AT_ONCE if judge is judge_oracle else os.cpu_count() or 1
    failed = 0
    with ThreadPoolExecutor(workers) as pool:
        for case, wrong in zip(cases, pool.map(judge, cases)):
            if wrong:
                failed += 1
                print(f"{case.name()}\n    {wrong}")
    if judge is judge_durer:
        for path, first, what in sorted({(case.path, case.first, what) for case in cases for what in case.later} - waiting):
            failed += 1
            print(f"{path.name}:{first + 1}: does not wait for `{what}` any more")
    print(f"{len(cases)} cases, {failed} fail, {len(waiting)} wait for features")
    return 1 if failed else 0


def record(paths: list[Path]) -> int:
    for path in paths:
        lines = path.read_text("utf-8").split("\n")
        missing = [case for case in cases_of(path) if not case.recorded]
        with ThreadPoolExecutor(answers.AT_ONCE) as pool:
            marks = list(pool.map(marks_of, missing))
        first_of_each = {case.first: (case, text) for case, text in reversed(list(zip(missing, marks)))}
        for _, (case, text) in sorted(first_of_each.items(), reverse=True):
            end = case.last
            while not lines[end - 1].strip():
                end -= 1
            lines[end:end] = text
        path.write_text("\n".join(lines), "utf-8")
    return 0


def marks_of(case: Case) -> list[str]:
    """The expectations of a case: what POV-Ray prints; our own message or text where it fails."""
    if case.path.suffix == ".scene":
        durer = ask(case, answers.ask_durer)
        print(f"{case.name()}: to be read with care: {lines_of(durer.text)} {durer.error or ''}")
        error = [f"// error: {error_of(case, durer)}"] if durer.error else []
        return [*(f"// expect: {line}".rstrip() for line in lines_of(durer.text)), *error]
    oracle = ask(case, answers.ask_oracle)
    if oracle.error is None:
        prints = told(case, oracle)
        if not prints:
            print(f"{case.name()}: prints nothing")
        durer = ask(case, answers.ask_durer)
        missing = re.search(r"`([^`]*)`", durer.error or "") if NOT_YET in (durer.error or "") else None
        return [*(f"// expect: {line}".rstrip() for line in prints), *([f"// later: {missing[1]}"] if missing else [])]
    durer = ask(case, answers.ask_durer)
    marks = [f"// expect: {line}".rstrip() for line in lines_of(durer.text)]
    if durer.error is None or durer.line != oracle.line:
        print(f"{case.name()}: POV-Ray: {oracle.error} (line {oracle.line}); durer: {durer.error}")
    if durer.error is None:
        return ["// beyond", *marks]
    return [*(["// before"] if durer.line != oracle.line or durer.file != case.file else []), *marks, f"// error: {error_of(case, durer)}"]


def rows() -> int:
    """A row is found where its text stands in a title or source of its section, or of the unit tests named instead."""
    @functools.cache
    def text_of(where: str) -> str:
        if where.startswith("tests/"):
            return "\n".join(
                path.read_text("utf-8", "replace") for path in sorted(programs.ROOT.glob(where)) if path.suffix in (".cpp", ".pov", ".txt"))
        files = [path for path in sorted(FOLDER.iterdir()) if path.name.startswith(f"{where}-")]
        return "\n".join(f"{case.title}\n{case.source}" for path in files for case in cases_of(path))

    lines = (FOLDER / "rows.tsv").read_text("utf-8").splitlines()[1:]
    totals: collections.Counter[str] = collections.Counter()
    missing = []
    for section, row, needle, where in (line.split("\t") for line in lines if line):
        totals[section] += 1
        edge = r"(?<!\w)" if needle[:1].isalnum() else ""
        if not re.search(edge + re.escape(needle), text_of(where or section)):
            missing.append(f"{section}: {row}: no case has `{needle}`")
    print("\n".join(missing))
    print(", ".join(f"{section}: {count}" for section, count in totals.items()))
    print(f"{sum(totals.values())} rows, {len(missing)} without a case")
    return 1 if missing else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["check", "verify", "record", "rows"])
    parser.add_argument("files", nargs="*", type=Path, help="default: all of tests/language")
    args = parser.parse_args()
    if args.action == "rows":
        return rows()
    paths = args.files or sorted(path for path in FOLDER.iterdir() if path.suffix in (".pov", ".scene"))
    if args.action in ("verify", "record") and not programs.oracle_path():
        print(f"language: POV-Ray is not installed; {programs.HOW_TO_INSTALL_ORACLE}", file=sys.stderr)
        return 2
    if args.action == "record":
        return record(paths)
    missing = {path: need for path in paths if (need := programs.missing_need(path))}
    for path, need in missing.items():
        print(f"{path.name}: skipped, {need} is not installed; {programs.HOW_TO_INSTALL_ORACLE}")
    paths = [path for path in paths if path not in missing]
    return judge_all(paths, judge_durer if args.action == "check" else judge_oracle)


if __name__ == "__main__":
    sys.exit(main())
