"""Colours: the colour words, their order, single precision."""

from generators import expressions
from generators.writer import Writer

WORDS = {"rgb": 3, "rgbf": 4, "rgbt": 4, "rgbft": 5, "srgb": 3, "srgbf": 4, "srgbt": 4, "srgbft": 5}


def piece(w: Writer) -> None:
    for _ in range(w.rng.randint(1, 3)):
        name = w.fresh("C")
        w.line(f"#declare {name} = {colour(w)};")
        w.declare("c", name)
        w.show("c", name)
        if w.chance(0.5):
            w.show("f", f"{name}.{w.pick(expressions.COLOUR_COMPONENTS)}")
        if w.chance(0.4):
            w.show("c", expressions.colour(w, 2))


def colour(w: Writer) -> str:
    """A colour as `#declare` reads it."""
    start = w.pick(("", "color ", "colour "))
    kind = w.rng.randint(0, 5)
    if kind <= 2:
        word = w.pick(list(WORDS))
        return f"{start}{word} {_operand(w, WORDS[word])}{_components(w, 0.3)}"
    if kind == 3 and w.known("c"):
        return f"{start or 'color '}{expressions.colour(w, 1)}{_components(w, 0.5)}"
    if kind == 4:
        return f"{start or 'color '}{w.pick(('0.3', '<1,0.5,0.2>', '2*<0.1,0.2,0.3>', '<.1,.2,.3,.4,.5>'))}{_components(w, 0.3)}"
    return f"{start or 'color '}{w.pick(('red', 'green', 'blue'))} {_share(w)}{_components(w, 0.6)}"


def _operand(w: Writer, length: int) -> str:
    kind = w.rng.randint(0, 5)
    if kind == 0:
        return _share(w)
    if kind == 1:
        return f"<{','.join(_share(w) for _ in range(length))}>*{_share(w)}"
    if kind == 2 and w.known("c"):
        return w.pick(w.known("c")) + w.pick(("", f"*{_share(w)}", f"+{_share(w)}"))
    if kind == 3 and w.known("v3"):
        return w.pick(w.known("v3")) + w.pick(("", ".y", ".x+0.5"))
    if kind == 4:
        return f"({_share(w)} < {_share(w)})"
    return f"<{', '.join(_share(w) for _ in range(length))}>"


def _components(w: Writer, probability: float) -> str:
    text = ""
    while w.chance(probability):
        text += f" {w.pick(('red', 'green', 'blue', 'filter', 'transmit', 'alpha'))} {_share(w)}"
    return text


def _share(w: Writer) -> str:
    return w.pick(("0", "1", ".5", "0.25", "0.1", f"{w.rng.uniform(0, 1):.4f}"))
