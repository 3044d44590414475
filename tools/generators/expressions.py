"""Numbers and vectors: every operator, level and length, and the numeric built-ins."""

from generators.writer import Writer

LITERALS = ("0", "1", "2", "3", "7", "10", "0.5", ".25", "1.", "1e1", "2.5e-1", "1.e2", "007", "1e", "3.14159",
            "0.1", "0.2", "0.3", "1e-10", "1e-11", "123456.789", "90", "45", "1e6")
CONSTANTS = ("pi", "true", "no", "on", "off", "yes", "false", "clock", "clock_on", "version", "image_width")
ONE = ("abs", "ceil", "floor", "int", "cos", "sin", "tan", "atan", "degrees", "radians", "sinh", "cosh", "tanh",
       "asinh", "asin", "acos")
GUARDED = (("sqrt", "abs({})"), ("ln", "abs({})+0.001"), ("log", "abs({})+0.5"), ("exp", "mod({},20)"),
           ("acosh", "abs({})+1"), ("atanh", "mod({},1)*0.99"))
COMPONENTS = {2: "xyuv", 3: "xyzuv", 4: "xyztuv"}
COLOUR_COMPONENTS = ("red", "green", "blue", "filter", "transmit", "gray", "x", "y", "z", "t", "u", "v")


def piece(w: Writer) -> None:
    """Declares a variable or prints an expression, a few times."""
    if w.chance(0.1):
        turbulence(w)
    for _ in range(w.rng.randint(1, 4)):
        kind = w.pick(("f", "f", "f", "v3", "v3", "v2", "v4"))
        text = of_kind(w, kind, w.rng.randint(1, 4))
        if w.chance(0.5):
            name = w.pick(w.known(kind)) if w.known(kind) and w.chance(0.3) else w.fresh("V")
            w.line(f"#{w.pick(('declare', 'local'))} {name} = {text};")
            w.declare(kind, name)
            w.show(kind, name)
        else:
            w.show(kind, text)


def of_kind(w: Writer, kind: str, depth: int) -> str:
    """An additive-level expression of this kind."""
    if kind == "f":
        return number(w, depth)
    if kind == "c":
        return colour(w, depth)
    return vector(w, int(kind[1]), depth)


def number(w: Writer, depth: int) -> str:
    if depth <= 0 or w.chance(0.1):
        return _leaf(w)
    return w.pick((_sum, _sum, _product, _product, _call, _call, _sign, _full, _full, _component, _measure))(w, depth - 1)


def _leaf(w: Writer) -> str:
    choices = [lambda: w.pick(LITERALS), lambda: w.pick(CONSTANTS)]
    if w.known("f"):
        choices += [lambda: w.pick(w.known("f"))] * 3
    if w.known("v3"):
        choices += [lambda: w.pick(w.known("v3")) + "." + w.pick(COMPONENTS[3])]
    if w.known("c"):
        choices += [lambda: w.pick(w.known("c")) + "." + w.pick(COLOUR_COMPONENTS)]
    if w.known("float source"):
        choices += [lambda: w.pick(w.known("float source"))] * 2
    return w.pick(choices)()


def _sum(w: Writer, depth: int) -> str:
    gap = w.pick(("", " "))
    return f"{number(w, depth)}{gap}{w.pick('+-')}{gap}{number(w, depth)}"


def _product(w: Writer, depth: int) -> str:
    return f"{factor(w, depth)}{w.pick('**/')}{factor(w, depth)}"


def factor(w: Writer, depth: int) -> str:
    """A number that binds as tightly as a factor."""
    text = number(w, depth)
    return text if text.replace(".", "").replace("_", "").isalnum() else f"({text})"


def _sign(w: Writer, depth: int) -> str:
    return w.pick(("-", "!", "+", "--", "-!", "!-", "+-")) + factor(w, depth)


def full(w: Writer, depth: int) -> str:
    """An expression of the full level: relations, logic, conditional."""
    kind = w.rng.randint(0, 5)
    if kind == 0 or depth <= 0:
        return f"{number(w, depth)} {w.pick(('<', '<=', '=', '!=', '>=', '>'))} {number(w, depth)}"
    if kind == 1:
        return f"{full(w, depth - 1)} {w.pick('&|')} {full(w, depth - 1)}"
    if kind == 2:
        return f"{full(w, depth - 1)} ? {number(w, depth - 1)} : {number(w, depth - 1)}"
    if kind == 3:
        return f"{number(w, depth)} {w.pick('<>=')} {number(w, depth)} {w.pick('<>&|')} {number(w, depth)}"
    if kind == 4 and w.known("s"):
        return f"{w.pick(w.known('s'))} {w.pick(('<', '<=', '=', '!=', '>=', '>'))} {w.pick((w.pick(w.known('s')), chr(34) + 'm' + chr(34)))}"
    return number(w, depth)


def _full(w: Writer, depth: int) -> str:
    return f"({full(w, depth)})"


def _call(w: Writer, depth: int) -> str:
    kind = w.rng.randint(0, 7)
    if kind <= 1:
        argument = full(w, depth) if w.chance(0.2) else number(w, depth)
        return f"{w.pick(ONE)}({argument})"
    if kind == 2:
        name, guard = w.pick(GUARDED)
        return f"{name}({guard.format(factor(w, depth))})"
    comma = w.pick((", ", ",", " "))
    first, second = number(w, depth), number(w, depth)
    if comma == " ":
        first, second = f"({first})", f"({second})"
    if kind == 3:
        return f"{w.pick(('mod', 'div', 'atan2'))}({first}{comma}{second})" if w.chance(0.7) \
            else f"pow(abs({first}){comma}mod(abs({second}),4)+0.1)"
    if kind == 4:
        more = "".join(f",{number(w, depth - 1)}" for _ in range(w.rng.randint(0, 2)))
        return f"{w.pick(('min', 'max'))}({number(w, depth)}{more})"
    if kind == 5:
        more = "".join(f",{number(w, depth - 1)}" for _ in range(w.rng.randint(0, 2)))
        return f"bitwise_{w.pick(('and', 'or', 'xor'))}({number(w, depth)}{more})"
    if kind == 6:
        last = f", {number(w, depth - 1)}" if w.chance(0.5) else ""
        return f"select({first}{comma}{second}{comma}{factor(w, depth - 1)}{last})"
    return f"rand({_stream(w)})"


def _stream(w: Writer) -> str:
    """A random stream, made if there is none."""
    if not w.known("stream"):
        if w.prefix:
            return f"seed({w.rng.randint(-9, 99)})"
        name = w.fresh("Dice")
        w.line(f"#declare {name} = seed({w.pick((0, 3, 77, -5, 2.7, 123456))});")
        w.declare("stream", name)
    return w.pick(w.known("stream"))


def _component(w: Writer, depth: int) -> str:
    if w.known("c") and w.chance(0.3):
        return f"({colour(w, depth)}).{w.pick(COLOUR_COMPONENTS)}"
    length = w.pick((2, 3, 3, 4))
    return f"({vector(w, length, depth)}).{w.pick(COMPONENTS[length])}"


def _measure(w: Writer, depth: int) -> str:
    kind = w.rng.randint(0, 3)
    if kind == 0:
        return f"vlength({promoted(w, depth)})"
    if kind == 1:
        return f"vdot({promoted(w, depth)}, {promoted(w, depth)})"
    if kind == 2 and w.known("s"):
        return f"{w.pick(('strlen', 'asc', 'val'))}({w.pick(w.known('s'))})"
    return f'strcmp("ab", "{w.pick(("ab", "b", "a", "AB", ""))}")'


def promoted(w: Writer, depth: int) -> str:
    """What may stand where a vector is wanted: shorter values too, and components with their quirk."""
    kind = w.rng.randint(0, 6)
    if kind <= 2:
        return vector(w, 3, depth)
    if kind == 3:
        return vector(w, 2, depth)
    if kind == 4 and w.known("v3"):
        text = w.pick(("", "-", "")) + w.pick(w.known("v3")) + "." + w.pick(COMPONENTS[3])
        return text + w.pick(("", f"+{_leaf(w)}", f"*{_leaf(w)}", f"*{vector(w, 3, 0)}"))
    return number(w, depth)


def vector(w: Writer, length: int, depth: int) -> str:
    """An expression that is exactly so long."""
    kind = w.rng.randint(0, 9)
    if depth <= 0 or kind <= 2:
        known = w.known(f"v{length}")
        if known and w.chance(0.6):
            return w.pick(known)
        if length == 3 and w.chance(0.3):
            return w.pick("xyz")
        if length == 2 and w.chance(0.3):
            return w.pick("uv")
        return literal(w, length, min(depth, 1))
    if kind <= 5:
        return f"{vector(w, length, depth - 1)} {w.pick('+-')} {vector(w, length, depth - 1)}"
    if kind == 6:
        other = w.pick((number(w, depth - 1), vector(w, w.rng.randint(2, length), depth - 1)))
        left, right = _paren(vector(w, length, depth - 1)), _paren(other)
        if w.chance(0.5):
            left, right = right, left
        return f"{left}{w.pick('**/')}{right}"
    if kind == 7:
        return w.pick("-!") + _paren(vector(w, length, depth - 1))
    if kind == 8:
        relation = w.pick(("<", "<=", "=", "!=", ">=", ">", "&", "|"))
        return f"({vector(w, length, depth - 1)} {relation} {vector(w, length, depth - 1)})"
    return _vector_call(w, depth - 1) if length == 3 else literal(w, length, depth - 1)


def _paren(text: str) -> str:
    return f"({text})"


def literal(w: Writer, length: int, depth: int) -> str:
    comma = w.pick((", ", ",", ",", " "))
    parts = [number(w, depth) for _ in range(length)]
    if comma == " ":
        parts = [_paren(part) for part in parts]
    trailing = "," if length < 5 and w.chance(0.03) else ""
    return f"<{comma.join(parts)}{trailing}>"


def _vector_call(w: Writer, depth: int) -> str:
    kind = w.rng.randint(0, 3)
    if kind == 0:
        return f"vcross({promoted(w, depth)}, {promoted(w, depth)})"
    if kind == 1:
        return f"vnormalize({promoted(w, depth)})"
    if kind == 2:
        return f"vrotate({promoted(w, depth)}, {promoted(w, depth)})"
    return f"vaxis_rotate({promoted(w, depth)}, {promoted(w, depth)} + <0.1,0.2,0.3>, {number(w, depth)})"


def turbulence(w: Writer) -> None:
    """Printed with fewer digits: the order in which noise is summed shows in the last."""
    point = ", ".join(f"{w.rng.uniform(-5, 5):.3f}" for _ in range(3))
    w.show("v3", f'vturbulence({w.pick(("2", "1.5"))}, {w.pick(("0.5", "0.7"))}, {w.rng.randint(0, 11)}, <{point}>)', 9)


def colour(w: Writer, depth: int) -> str:
    """A 5-component additive expression."""
    if w.known("c") and w.chance(0.7):
        text = w.pick(w.known("c"))
    else:
        text = literal(w, 5, min(depth, 1))
    if depth > 0 and w.chance(0.4):
        text = f"{text}{w.pick('*+-')}{_paren(w.pick((number(w, depth - 1), vector(w, 3, depth - 1))))}"
    return text
