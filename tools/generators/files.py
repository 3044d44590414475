"""Files: written as text and bytes, read back."""

from generators import expressions
from generators.writer import Writer


def piece(w: Writer) -> None:
    w.pick((_round_trip, _round_trip, _bytes, _bytes, _append, _blanks))(w)


def _file(w: Writer) -> str:
    return f"durer-differential-{w.rng.randint(0, 10**9)}.txt"


def _round_trip(w: Writer) -> None:
    path, handle = _file(w), w.fresh("F")
    kinds = [w.pick(("f", "v3", "s", "v2", "v4")) for _ in range(w.rng.randint(1, 4))]
    w.line(f'#fopen {handle} "{path}" write')
    for kind in kinds:
        text = f'"\\"", "t{w.rng.randint(0, 9)}", "\\""' if kind == "s" else expressions.literal(w, int(kind[1]), 0) \
            if kind != "f" else f"{w.rng.uniform(-100, 100):.5f}"
        w.line(f'#write ({handle}, {text}, ",\\n")')
    w.line(f"#fclose {handle}")
    w.line(f'#fopen {handle} "{path}" read')
    for kind in kinds:
        name = w.fresh("D")
        w.line(f"#read ({handle}, {name})")
        w.line(f"#ifdef ({name})")
        w.show(kind, name)
        w.line("#end")
    w.show("f", f"defined({handle})")
    w.line(f"#read ({handle}, {w.fresh('D')})")
    w.show("f", f"defined({handle})")
    w.show("f", f'file_exists("{path}")')


def _blanks(w: Writer) -> None:
    """Values that commas do not part, or that end without one."""
    path, handle = _file(w), w.fresh("F")
    text = w.pick(("1 2 3 4 5", "1,2 3,4", "<1,2,3> 4,5", "1,\\n2,\\n3", "1, -2, +3,", "7", "1,,2", "\\\"a\\\" \\\"b\\\", 3"))
    w.line(f'#fopen {handle} "{path}" write #write ({handle}, "{text}") #fclose {handle}')
    w.line(f'#fopen {handle} "{path}" read')
    name = w.fresh("D")
    w.line(f"#while (defined({handle})) #read ({handle}, {name}) #debug \"r\" #end")
    w.show("f", f"defined({name})")


def _bytes(w: Writer) -> None:
    """Bytes cannot be read back, so printable ones are written between quotes."""
    path, handle, name = _file(w), w.fresh("F"), w.fresh("B")
    form = w.pick(("sint8", "uint8", "uint16be", "uint16le", "sint16be", "sint16le", "sint32be", "sint32le"))
    size = {"8": 1, "6": 2, "2": 4}[form.rstrip("bel")[-1]]

    def value() -> str:
        number = sum(w.rng.randint(65, 90) << (8 * k) for k in range(size))
        return w.pick((str(number), f"{number}.4", f"{number} - 0.5"))

    values = w.pick((value(), f"{value()}, 12", f"<{value()}, {value()}>", f"{value()} {w.rng.randint(1, 9)}*0+{value()}"))
    w.line(f'#fopen {handle} "{path}" write #write ({handle}, "\\"", {form} {values}, "\\",") #fclose {handle}')
    w.line(f'#fopen {handle} "{path}" read #read ({handle}, {name})')
    w.show("s", name)


def _append(w: Writer) -> None:
    path, handle, name = _file(w), w.fresh("F"), w.fresh("D")
    # In parentheses: POV-Ray writes no colours, not even a component of one.
    w.line(f'#fopen {handle} "{path}" write #write ({handle}, ({expressions.number(w, 0)}), ",") #fclose {handle}')
    w.line(f'#fopen {handle} "{path}" append #write ({handle}, {w.rng.randint(0, 99)}, ",") #fclose {handle}')
    w.line(f'#fopen {handle} "{path}" read #while (defined({handle})) #read ({handle}, {name}) #ifdef ({name})')
    w.show("f", name)
    w.line("#end #end")
