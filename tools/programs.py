"""Running the two renderers, durer and the oracle (POV-Ray), as whole processes under a time limit."""

import functools
import glob
import os
import re
import shlex
import shutil
import signal
import subprocess
import tempfile
import threading
import time
from dataclasses import dataclass
from pathlib import Path

import png

ROOT = Path(__file__).resolve().parent.parent
SKIPPED = 77  # exit code: a part could not run because something optional is not installed

INCLUDES = Path("/usr/share/povray-3.7/include")  # of the oracle's packages: include files and fonts
NEEDS = "// needs: "  # a line near the top of a scene of ours: a file from there without which it cannot run

ORACLE_PACKAGES = ("povray", "povray-includes", "povray-examples")
HOW_TO_INSTALL_ORACLE = f"`make oracle` installs it (Debian packages {', '.join(ORACLE_PACKAGES)})"


CANNOT_HIDE_ORACLE = "POV-Ray's packages cannot be hidden, because `unshare --mount` is not permitted here"
HIDDEN = ("/usr/share/povray*", "/usr/local/share/povray*", "/usr/share/fonts/truetype/povray", "/etc/povray")


@functools.cache
def without_oracle(*others: Path) -> tuple[str, ...]:
    """Words before a command that run it as if no package of the oracle were installed: its folders, fonts
    included, are empty for that command, and `others` too, in a mount namespace of its own. Empty if that is
    not permitted here."""
    found = [path for pattern in HIDDEN for path in glob.glob(pattern)] + [str(path) for path in others]
    folders = [path for path in found if os.path.isdir(path)]
    mounts = "".join(f"mount -t tmpfs -o size=64k none {shlex.quote(path)} && " for path in folders)
    words = ("unshare", "--mount", *([] if os.geteuid() == 0 else ["--map-root-user"]),
             "sh", "-c", f'{mounts}exec "$@"', "sh")
    try:
        seen = subprocess.run([*words, "find", *(folders or ["/dev/null"]), "-type", "f"], capture_output=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return ()
    return () if seen.stdout else words


def missing_need(scene: Path) -> str:
    """The installed file that a scene needs and that is not there; empty if there is none."""
    with open(scene, encoding="utf-8", errors="replace") as text:
        for line, _ in zip(text, range(8)):
            if line.startswith(NEEDS):
                name = line[len(NEEDS):].strip()
                return "" if (INCLUDES / name).exists() else name
    return ""


@dataclass(frozen=True)
class Run:
    """What became of one process. Times in seconds, memory in MiB."""

    code: int  # exit code; negative: ended by that signal
    timed_out: bool
    wall: float
    cpu: float
    peak: float
    out: bytes
    err: str


@dataclass(frozen=True)
class Rendering:
    """A picture, or the reason why there is none."""

    picture: png.Picture | None
    error: str
    run: Run


def run(command: list[str], cwd: Path, limit: float, stdin: Path | None = None) -> Run:
    """Runs `command` in `cwd`; after `limit` seconds it and its children are killed.

    `peak` has a floor of about 12 MiB: the kernel counts what this interpreter held at the fork.
    """
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err, \
            open(stdin or os.devnull, "rb") as source:
        start = time.monotonic()
        process = subprocess.Popen(command, cwd=cwd, stdin=source, stdout=out, stderr=err,
                                   start_new_session=True)
        expired = threading.Event()

        def end_it() -> None:
            expired.set()
            _kill_group(process.pid)

        alarm = threading.Timer(limit, end_it)
        alarm.start()
        try:
            _, status, usage = os.wait4(process.pid, 0)
        except BaseException:
            _kill_group(process.pid)
            raise
        finally:
            alarm.cancel()
        wall = time.monotonic() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        return Run(process.returncode, expired.is_set(), wall, usage.ru_utime + usage.ru_stime,
                   usage.ru_maxrss / 1024, out.read(), err.read().decode("utf-8", "replace"))


def _kill_group(pid: int) -> None:
    try:
        os.killpg(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass  # it ended by itself meanwhile


def durer_path() -> Path:
    """The program under test: $DURER, else build/durer."""
    return Path(os.environ.get("DURER") or ROOT / "build" / "durer").absolute()


def oracle_path() -> str | None:
    """The oracle: $ORACLE, else `povray` on the search path; None if it is not installed."""
    return shutil.which(os.environ.get("ORACLE") or "povray")


def render_with_durer(scene: Path, options: list[str], limit: float, before: tuple[str, ...] = ()) -> Rendering:
    """Renders `scene` in its own folder; `before`: words that precede the command."""
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "picture.png"
        done = run([*before, str(durer_path()), f"+I{scene.name}", f"+O{output}", *options], scene.parent, limit)
        data = output.read_bytes() if output.exists() else b""
    return _rendering(done, data, limit)


def render_with_oracle(scene: Path, options: list[str], limit: float) -> Rendering:
    """Renders `scene` in its own folder.

    The picture comes through standard output, because Debian lets POV-Ray write below /tmp only.
    Names that its option parser cannot read (blanks, letters beyond ASCII) go through a link.
    """
    with tempfile.TemporaryDirectory() as folder:
        name = scene.name
        if not re.fullmatch(r"[\w.+-]+", name, re.ASCII):
            link = Path(folder) / f"scene{scene.suffix}"
            link.symlink_to(scene.absolute())
            name = str(link)
        done = run([oracle_path() or "povray", f"+I{name}", "+O-", "+FN", *options], scene.parent, limit)
    return _rendering(done, done.out, limit)


def first_error(stderr: str) -> str:
    """The line that says what went wrong: the first that speaks of an error, else the first at all."""
    if coded := re.search(r"error\[D\d+\].*", stderr):
        return coded[0]
    lines = [line.strip() for line in stderr.splitlines() if line.strip()]
    told = [line for line in lines if re.match(r"(fatal )?(\w+ )?error\b", line, re.IGNORECASE)]
    return next(iter(told + lines), "no message")


def _rendering(done: Run, data: bytes, limit: float) -> Rendering:
    if done.timed_out:
        return Rendering(None, f"timed out after {limit:g} s", done)
    if done.code < 0:
        return Rendering(None, f"crashed (signal {-done.code})", done)
    if done.code != 0:
        return Rendering(None, first_error(done.err), done)
    try:
        return Rendering(png.decode(data), "", done)
    except png.PngError as error:
        return Rendering(None, f"exit code 0, but {error if data else 'no picture'}", done)
