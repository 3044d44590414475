"""Questions to objects: trace, inside and extents of simple shapes."""

from generators.writer import Writer


def piece(w: Writer) -> None:
    name, kind = w.fresh("Ob"), w.rng.randint(0, 3)
    # POV-Ray keeps the box of solids that are inverted, and its rays miss what lies beyond.
    moves = (_move, _changes, _moves, _moves)[kind]
    w.line(f"#declare {name} = {shape(w, w.rng.randint(0, 2), moves)}")
    if kind == 0:
        # It keeps a corner and a size in single precision, and rounds at every transformation. It
        # turns boxes at every step, or not at all.
        _show(w, f"min_extent({name})", 2)
        _show(w, f"max_extent({name})", 2)
    elif kind == 1:
        inner = w.fresh("Ob")
        w.line(f"#declare {inner} = object {{ {name} {_changes(w)} }}")
        for _ in range(3):
            w.show("f", f"inside({inner}, {_point(w, 1.5)})")
    else:
        normal = w.fresh("No")
        w.line(f"#declare {normal} = <9, 9, 9>;")
        for _ in range(2):
            _show(w, f"trace({name}, {_point(w, 4)}, {_point(w, 1)}, {normal})", 7)
            _show(w, normal, 7)


def _show(w: Writer, text: str, digits: int) -> None:
    """With fewer digits than other values: the two programs solve equations in other ways. What is
    added keeps zeros and the halves of short decimals from being rounded either way."""
    w.show("v3", f"{text} + 0.000137912", digits)


def _point(w: Writer, size: float) -> str:
    return "<" + ", ".join(f"{w.rng.uniform(-size, size):.2f}" for _ in range(3)) + ">"


def shape(w: Writer, depth: int, moves) -> str:
    """No two faces of a program lie in one plane: there POV-Ray takes either surface, as rounding has it."""
    end = lambda: f"{w.rng.uniform(0.2, 1):.4f}"
    simple = (f"sphere {{ {_point(w, 1)}, {w.rng.uniform(0.5, 2):.2f} {'' if moves is _move else moves(w)} }}",
              f"box {{ <-{end()},-{end()},-{end()}>, <{end()},{end()},{end()}> {moves(w)} }}",
              f"cylinder {{ -{end()}*y, <0,{end()},{end()}>, 0.7 {moves(w)} }}",
              f"cone {{ -{end()}*y, 1, {end()}*y, {w.rng.uniform(0, 0.8):.2f} {moves(w)} }}",
              f"torus {{ 1, {w.rng.uniform(0.1, 0.5):.4f} {moves(w)} }}")
    if depth == 0 or w.chance(0.3):
        return w.pick(simple)
    return f"{w.pick(('union', 'intersection', 'difference', 'merge'))} {{ {shape(w, depth - 1, moves)} {shape(w, depth - 1, moves)} {moves(w)} }}"


def _move(w: Writer) -> str:
    return w.pick(("", f"translate {_point(w, 1)}", f"rotate {w.rng.randint(-90, 90)}*{w.pick('xyz')}",
                   f"scale {w.rng.uniform(0.5, 2):.2f}", f"scale <1, {w.rng.uniform(0.5, 2):.2f}, 1>"))


def _moves(w: Writer) -> str:
    return " ".join(_move(w) for _ in range(w.rng.choice((0, 1, 2))))


def _changes(w: Writer) -> str:
    """Up to two moves, and perhaps the inside turned out."""
    return f"{_moves(w)} {w.pick(('', '', '', 'inverse'))}"
