"""Random scene programs that print by #debug; see tools/differential.py."""

import random

from generators import arrays, colours, control, expressions, files, functions, macros, objects, scopes, splines, strings
from generators.writer import Writer

# Subject → (weight in a mixed program, the function that appends one piece of it).
SUBJECTS = {
    "expressions": (6, expressions.piece),
    "colours": (3, colours.piece),
    "strings": (4, strings.piece),
    "macros": (5, macros.piece),
    "arrays": (4, arrays.piece),
    "control": (4, control.piece),
    "scopes": (3, scopes.piece),
    "files": (2, files.piece),
    "splines": (2, splines.piece),
    "functions": (3, functions.piece),
    "objects": (2, objects.piece),
}

HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"


def program(seed: int, subject: str | None = None) -> str:
    """The program of `seed`: pieces of all subjects, or of one."""
    rng = random.Random(f"{subject or 'mixed'} {seed}")
    writer = Writer(rng)
    names = list(SUBJECTS)
    weights = [SUBJECTS[name][0] for name in names]
    for _ in range(rng.randint(3, 9)):
        SUBJECTS[subject or rng.choices(names, weights)[0]][1](writer)
    return HEAD + "\n".join(writer.lines) + "\n"
