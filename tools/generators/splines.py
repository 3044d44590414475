"""Splines of all kinds, with float, vector and colour values."""

from generators.writer import Writer

KINDS = ("linear_spline", "quadratic_spline", "cubic_spline", "natural_spline")


def piece(w: Writer) -> None:
    name, length = w.fresh("P"), w.pick((1, 2, 3, 3, 4, 5))
    count = w.rng.randint(1, 6)
    keys = [w.pick((str(k), f"{k * 0.5}", f"{w.rng.uniform(-2, 4):.2f}")) for k in range(count)]
    if w.chance(0.3):
        w.rng.shuffle(keys)
    values = [_value(w, length) for _ in keys]
    comma = w.pick((", ", " "))
    if any(key.startswith("-") for key in keys) or length == 1:
        comma = ", "
    entries = comma.join(f"{key}, {value}" for key, value in zip(keys, values))
    w.line(f"#declare {name} = spline {{ {w.pick((*KINDS, ''))} {entries} }}")
    kind = {1: "v2", 2: "v2", 3: "v3", 4: "v4", 5: "c"}[length]
    for _ in range(w.rng.randint(1, 3)):
        at = w.pick(("0", "1", "0.5", "-9", "9", f"{w.rng.uniform(-1, 4):.3f}"))
        w.show(kind, f"{name}({at}{w.pick(('', '', ', ' + w.pick(KINDS)))})")
    w.show("f", f"{name}({w.rng.uniform(0, 3):.2f}).{w.pick('xy')}")
    if w.chance(0.4):
        copy = w.fresh("P")
        w.line(w.pick((f"#declare {copy} = {name};", f"#declare {copy} = spline {{ {name} }}",
                       f"#declare {copy} = spline {{ {name} {w.pick(KINDS)} 1.25, {_value(w, length)} }}")))
        w.show(kind, f"{copy}({w.rng.uniform(0, 3):.2f})")


def _value(w: Writer, length: int) -> str:
    part = lambda: f"{w.rng.uniform(-5, 5):.2f}" if w.chance(0.5) else str(w.rng.randint(-3, 9))
    return part() if length == 1 else "<" + ", ".join(part() for _ in range(length)) + ">"
