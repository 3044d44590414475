#!/usr/bin/env python3
"""Lists the reserved words of the language that no golden scene uses.

A word in a comment or a string does not count. What is listed may still be tested elsewhere: words
of the language itself have their cases in tests/language.
"""

import argparse
import re
import sys

import programs

VOCABULARY = programs.ROOT / "grammar" / "vocabulary.def"
FOLDER = programs.ROOT / "tests" / "golden"
ENTRY = re.compile(r'^DURER_WORD\(\w+, "(?P<text>\w+)", (?P<kind>\w+)\)', re.MULTILINE)
SECTION = re.compile(r"^// (?P<title>[A-Z].*)$")
IGNORED = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"', re.DOTALL)


def words_in_use() -> set[str]:
    used: set[str] = set()
    for scene in FOLDER.rglob("*.pov"):
        used.update(re.findall(r"[A-Za-z_]\w*", IGNORED.sub(" ", scene.read_text(encoding="utf-8"))))
    return used


def unused_by_section() -> dict[str, list[str]]:
    """Words without a golden, by the headings of the vocabulary, in its order."""
    used = words_in_use()
    title, found = "", {}
    for line in VOCABULARY.read_text(encoding="utf-8").splitlines():
        if heading := SECTION.match(line):
            title = heading["title"]
        entry = ENTRY.match(line)
        if entry and entry["text"] not in used:
            found.setdefault(title, []).append(entry["text"])
    return found


def main() -> int:
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    for title, words in unused_by_section().items():
        print(f"{title}: {' '.join(words)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
