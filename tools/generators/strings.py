"""Strings: the string functions, formatting, escapes, comparisons."""

from generators import expressions
from generators.writer import Writer

TEXTS = ("", "a", "abc", "Hello, World", "x = 1", "12.5e1xyz", "-7", "  9", "1e400", "AbC", "tab\\there",
         "quo\\\"te", "b\\\\s", "apo\\'s", "\\u0041\\u0042", "0", ".5.5", "+3", "0x10", "naN", "infx", "1e", "e5")


def piece(w: Writer) -> None:
    for _ in range(w.rng.randint(1, 4)):
        text = string(w, w.rng.randint(1, 3))
        if w.chance(0.5):
            name = w.fresh("S")
            w.line(f"#declare {name} = {text}{w.pick((';', '', ';'))}")
            w.declare("s", name)
            w.show("s", name)
        else:
            w.show("s", text)
        if w.chance(0.4):
            w.show("f", _question(w))


def string(w: Writer, depth: int) -> str:
    kind = w.rng.randint(0, 9)
    if depth <= 0 or kind == 0:
        return w.pick(w.known("s")) if w.known("s") and w.chance(0.5) else f'"{w.pick(TEXTS)}"'
    if kind <= 2:
        parts = [string(w, depth - 1) for _ in range(w.rng.randint(1, 3))]
        return f"concat({w.pick((', ', ','))[:2].join(parts)})"
    if kind <= 5:
        return f"str({expressions.number(w, 2)}, {w.rng.randint(-14, 14)}, {w.rng.randint(-1, 9)})"
    if kind == 6:
        length = w.rng.randint(1, 6)
        value = expressions.vector(w, w.rng.randint(2, 4), 1) if w.chance(0.8) else w.pick(expressions.LITERALS)
        return f'vstr({length}, {value}, "{w.pick((",", "; ", "", " "))}", {w.rng.randint(-6, 6)}, {w.rng.randint(-1, 4)})'
    if kind == 7:
        return f"{w.pick(('strupr', 'strlwr'))}({string(w, depth - 1)})"
    if kind == 8:
        inner = string(w, depth - 1)
        start = w.rng.randint(1, 5)
        return f'substr(concat({inner}, "0123456789"), {start}, {w.rng.randint(0, 6)})'
    return w.pick((f"chr({w.rng.randint(33, 126)})", f"datetime({w.rng.uniform(-4000, 9000):.5f})",
                   f'datetime({w.rng.uniform(-400, 9000):.3f}, "%Y %j %H")'))


def _question(w: Writer) -> str:
    kind = w.rng.randint(0, 4)
    if kind == 0:
        return f"strcmp({string(w, 1)}, {string(w, 1)})"
    if kind == 1:
        return f"({string(w, 1)} {w.pick(('<', '<=', '=', '!=', '>=', '>'))} {string(w, 1)})"
    return f"{('strlen', 'asc', 'val')[kind - 2]}({string(w, 2)})"
