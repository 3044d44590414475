"""User functions: their own expression grammar, sums, calls of one another, vector functions."""

from generators.writer import Writer

ONE = ("abs", "ceil", "floor", "int", "cos", "sin", "tan", "atan", "degrees", "radians", "sinh", "cosh", "tanh", "exp",
       "sqrt", "ln", "log", "asin", "acos", "asinh", "acosh", "atanh")
POINTS = ("0", "1", "-1", "0.5", "2", "-2.25", "3.7", "1e-11", "10")


def piece(w: Writer) -> None:
    w.pick((_scalar, _scalar, _scalar, _scalar, _transform, _spline, _pigment))(w)


def _scalar(w: Writer) -> None:
    name = w.fresh("Fn")
    listed = w.chance(0.6)
    parameters = w.rng.sample(("A", "B", "C", "x", "y", "z", "u", "v"), w.rng.randint(1, 3)) if listed else ["x", "y", "z"]
    if {"x", "u"} <= set(parameters) or {"y", "v"} <= set(parameters):
        parameters = ["x", "y"]
    head = f"({', '.join(parameters)})" if listed else ""
    w.line(f"#declare {name} = function{head} {{ {body(w, parameters, w.rng.randint(1, 4))} }}")
    for _ in range(w.rng.randint(1, 3)):
        w.show("f", f"{name}({', '.join(w.pick(POINTS) for _ in parameters)})")
    w.names.setdefault("function", []).append(f"{name}/{len(parameters)}")


def body(w: Writer, names: list[str], depth: int, later: bool = False) -> str:
    """A function expression over these names. `later`: in the second or a later argument of a call."""
    if depth <= 0 or w.chance(0.1):
        choices = [w.pick(names), w.pick(names), w.pick(("1", "2", "0.5", "3", "10", "pi", "clock"))]
        if w.known("f") and w.chance(0.3):
            choices.append(w.pick(w.known("f")))
        return w.pick(choices)
    inner = lambda: body(w, names, depth - 1, later)
    other = lambda: body(w, names, depth - 1, True)
    kind = w.rng.randint(0, 11)
    if kind <= 2:
        return f"({inner()} {w.pick('+-*/')} {inner()})"
    if kind == 3:
        return f"{inner()} {w.pick('+-*')} {inner()}"
    if kind == 4:
        return f"({inner()} {w.pick(('<', '<=', '=', '!=', '>=', '>', '&', '|'))} {inner()})"
    if kind == 5:
        return f"({inner()} {w.pick('<>=')} {inner()} {w.pick('&|')} {inner()} {w.pick('&|')} {inner()})"
    if kind == 6:
        return f"{w.pick(ONE)}({inner()})"
    if kind == 7:
        return _power(w, names, depth - 1, later)
    if kind == 8:
        return f"{w.pick(('min', 'max'))}({inner()}, {other()}{w.pick(('', ', ' + other()))})"
    if kind == 9:
        return f"{w.pick(('mod', 'div', 'atan2'))}({inner()}, {other()})"
    if kind == 10:
        return f"select({inner()}, {other()}, {other()}{w.pick(('', ', ' + other()))})"
    if w.known("function") and w.chance(0.5):
        name, count = w.pick(w.known("function")).split("/")
        return f"{name}({', '.join([inner(), *(other() for _ in range(int(count) - 1))])})"
    index = w.fresh("k")
    term = body(w, [*names, index], 1, True)
    return f"{w.pick(('sum', 'prod'))}({index}, {w.rng.randint(-1, 2)}, {w.rng.randint(0, 4)}, {term})"


def _power(w: Writer, names: list[str], depth: int, later: bool) -> str:
    """Constant exponents are literals: in parentheses, and in later arguments, POV-Ray calls the C
    library for the powers that durer multiplies out, which shows in the last bit."""
    exponents = ["1", "2", "0.5", "-1", "-2", f"({body(w, names, depth, True)} + {w.pick(names)})"]
    if not later:
        exponents += "3456789"
    return f"pow({body(w, names, depth, later)}, {w.pick(exponents)})"


def _transform(w: Writer) -> None:
    name = w.fresh("Ft")
    steps = " ".join(w.pick((f"rotate {w.rng.randint(-90, 90)}*{w.pick('xyz')}", f"translate <{w.rng.randint(-3, 3)}, 1, 2>",
                             f"scale <{w.rng.uniform(0.5, 3):.2f}, 2, 1>", "scale 2")) for _ in range(w.rng.randint(1, 3)))
    w.line(f"#declare {name} = function {{ transform {{ {steps} }} }}")
    w.show("v3", f"{name}(1, 2, 3)")
    w.show("f", f"{name}(1, -1, 0.5).{w.pick('xyz')}")
    outer = w.fresh("Fn")
    w.line(f"#declare {outer} = function(A) {{ {name}(A, 1, 2).{w.pick('xyz')} + A }}")
    w.show("f", f"{outer}(0.5)")


def _spline(w: Writer) -> None:
    name = w.fresh("Fs")
    kind = w.pick(("linear_spline", "quadratic_spline", "cubic_spline", "natural_spline"))
    w.line(f"#declare {name} = function {{ spline {{ {kind} 0, <1,2,3> 1, <2,0,5> 2, <4,1,1> 3, <0,0,{w.rng.randint(0, 5)}> }} }}")
    w.show("v3", f"{name}({w.rng.uniform(-0.5, 3.5):.3f})")
    w.show("f", f"{name}(1.5).{w.pick('xyz')}")


def _pigment(w: Writer) -> None:
    name = w.fresh("Fp")
    # Patterns are asked for their values by the tests of patterns; here the colours matter.
    pigment = w.pick(("rgb <0.1, 0.5, 0.9>", "rgbft <.1,.2,.3,.4,.5>", "gradient x color_map { [0 rgb 0] [1 rgb <1,2,3>] }",
                      "checker rgb 1, rgb <1,0.5,0>", "gradient y color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 3"))
    w.line(f"#declare {name} = function {{ pigment {{ {pigment} }} }}")
    point = ", ".join(f"{w.rng.uniform(0, 3):.3f}" for _ in range(3))
    # Colours are single precision, and interpolated so.
    w.show("c", f"{name}({point}) + 1e-9", 5)
    member = w.pick(("red", "green", "blue", "filter", "transmit", "gray", "x", "t"))
    w.show("f", f"{name}({point}).{member} + 1e-9", 5)
    outer = w.fresh("Fn")
    w.line(f"#declare {outer} = function {{ {name}(x, y, z).{w.pick(('gray', 'red', 'hf', 'grey', 'blue'))}*2 }}")
    w.show("f", f"{outer}({point}) + 1e-9", 5)
