"""What a program prints by #debug and where it fails, asked of either renderer."""

import re
import tempfile
from dataclasses import dataclass
from pathlib import Path

import programs

START, END = "=start=", "=end="
LIMIT = 10.0  # seconds per program
AT_ONCE = 8   # POV-Ray spends most of its half second asleep


@dataclass(frozen=True)
class Printed:
    """What a program printed, and where it ended with an error: None if it did not."""

    text: str
    error: str | None
    line: int
    column: int = 0
    file: str = ""


def framed(source: str) -> str:
    """The source between two messages that mark its text and show a complete run; no line moves."""
    return f'#debug "{START}\\n" {source}\n#debug "\\n{END}\\n"\n'


def ask_oracle(scene: Path) -> Printed:
    command = [programs.oracle_path() or "povray", f"+I{scene.name}", "-D", "-F", "+W1", "+H1", "-A", "-GR", "-GS", "-GW"]
    done = programs.run(command, scene.parent, LIMIT)
    if done.timed_out:  # it hangs once in a thousand starts
        done = programs.run(command, scene.parent, LIMIT)
    text = re.sub(r"^==== \[.*\n", "", done.err.partition(f"{START}\n")[2], flags=re.MULTILINE)
    if done.timed_out:
        return Printed(text, "timed out", 0)
    printed, ended, _ = text.partition(f"\n{END}\n")
    if ended and done.code == 0:  # an open bracket takes in the last message, and fails after it
        return Printed(printed, None, 0)
    text = text.replace(f"\n{END}\n", "", 1)
    printed, found, rest = text.partition("\nFile '") if not text.startswith("File '") else ("", "File '", text[6:])
    line = re.match(r"[^']*' line (\d+): (.*(?:\n .*)*)", rest)
    if not found or not line:
        return Printed(text, f"ended with code {done.code}", 0)
    return Printed(printed, " ".join(line[2].split()), int(line[1]), file=rest.partition("'")[0])


def ask_durer(scene: Path) -> Printed:
    with tempfile.NamedTemporaryFile() as debug:
        command = [str(programs.durer_path()), f"+I{scene.name}", "-F", "+W1", "+H1", "-GA", "+GF", f"Debug_File={debug.name}"]
        done = programs.run(command, scene.parent, LIMIT)
        text = Path(debug.name).read_text("utf-8", "replace").removeprefix(f"{START}\n")
    if done.timed_out:
        return Printed(text, "timed out", 0)
    if done.code < 0:
        return Printed(text, f"crashed (signal {-done.code})", 0)
    printed, ended, _ = text.partition(f"\n{END}\n")
    if done.code == 0:
        return Printed(printed, None if ended else "no end", 0)
    place = re.search(r"--> ([^\n]*?):(\d+):(\d+)", done.err)
    if not place:
        return Printed(printed, programs.first_error(done.err), 0)
    return Printed(printed, programs.first_error(done.err), int(place[2]), int(place[3]), Path(place[1]).name)
