"""Arrays: dimensions, element types, unset elements, arrays of arrays, copies."""

from generators import expressions
from generators.writer import Writer

ELEMENTS = {"f": lambda w: expressions.number(w, 1), "v3": lambda w: expressions.literal(w, 3, 0),
            "v2": lambda w: expressions.literal(w, 2, 0), "c": lambda w: f"rgb <{w.rng.randint(0, 3)},0.5,0.25>",
            "s": lambda w: f'"t{w.rng.randint(0, 99)}"', "v4": lambda w: expressions.literal(w, 4, 0)}


def piece(w: Writer) -> None:
    w.pick((_flat, _flat, _grid, _unset, _of_arrays, _copy, _indices, _loop))(w)


def _flat(w: Writer) -> None:
    name, kind, size = w.fresh("A"), w.pick(list(ELEMENTS)), w.rng.randint(1, 5)
    values = [ELEMENTS[kind](w) for _ in range(size)]
    comma = ", " if kind == "f" or w.chance(0.8) else " "
    w.line(f"#declare {name} = array[{size}] {{ {comma.join(values)}{w.pick(('', ','))} }}{w.pick(('', ';'))}")
    for _ in range(2):
        w.show(kind, f"{name}[{w.rng.randint(0, size - 1)}]")
    w.show("f", f"dimension_size({name}, {w.rng.randint(0, 2)}) + 10*dimensions({name})")
    at = w.rng.randint(0, size - 1)
    w.line(f"#declare {name}[{at}] = {ELEMENTS[kind](w)};")
    w.show(kind, f"{name}[{at}]")
    if kind == "f":
        w.declare("float source", f"{name}[{at}]")
    if kind in ("v3", "c") and w.chance(0.5):
        w.show("f", f"{name}[{at}].{w.pick('xyz')}")


def _grid(w: Writer) -> None:
    name = w.fresh("G")
    sizes = [w.rng.randint(1, 3) for _ in range(w.rng.randint(2, 5))]

    def level(rest: list[int]) -> str:
        if not rest:
            return str(w.rng.randint(0, 99))
        return "{ " + ", ".join(level(rest[1:]) for _ in range(rest[0])) + " }"

    subscripts = "".join(f"[{size}]" for size in sizes)
    w.line(f"#declare {name} = array{subscripts} {level(sizes)}")
    for _ in range(2):
        at = "".join(f"[{w.rng.randint(0, size - 1)}]" for size in sizes)
        w.show("f", f"{name}{at}")
    w.show("f", f"dimensions({name})*100 + dimension_size({name}, {w.rng.randint(1, len(sizes))})")


def _unset(w: Writer) -> None:
    name, kind = w.fresh("U"), w.pick(list(ELEMENTS))
    w.line(f"#declare {name} = array[4]")
    w.line(f"#declare {name}[{w.rng.randint(0, 3)}] = {ELEMENTS[kind](w)};")
    for at in range(4):
        w.line(f"#ifdef ({name}[{at}])")
        w.show(kind, f"{name}[{at}]")
        w.line(f"#else #debug \"unset\\n\" #end")
    w.show("f", f"defined({name}[{w.rng.randint(0, 3)}])")
    if w.chance(0.5):
        w.line(f"#declare {name}[1] = {ELEMENTS[kind](w)};")
        w.line(f"#undef {name}[1]")
        w.show("f", f"defined({name}[1])")


def _of_arrays(w: Writer) -> None:
    name = w.fresh("N")
    w.line(f"#declare {name} = array[2] {{ array[2] {{ 1, 2 }}, array[3] {{ 3, 4, 5 }} }}")
    w.show("f", f"{name}[{w.rng.randint(0, 1)}][{w.rng.randint(0, 1)}]")
    w.show("f", f"{name}[1][2]")
    w.show("f", f"dimension_size({name}, 1)")
    w.show("f", f"dimension_size({name}[1], 1)")
    w.line(f"#declare {name}[0][1] = 77;")
    w.show("f", f"{name}[0][1]")


def _copy(w: Writer) -> None:
    first, second = w.fresh("A"), w.fresh("B")
    w.line(f"#declare {first} = array[2] {{ 1, 2 }}")
    w.line(f"#declare {second} = {first};")
    w.line(f"#declare {second}[0] = 9;")
    w.show("v2", f"<{first}[0], {second}[0]>")
    macro = w.fresh("M")
    how = w.pick(("declare", "local"))
    w.line(f"#macro {macro}(P) #{how} P[1] = 5; #{how} {second}[1] = 6; #end {macro}({first})")
    w.show("v4", f"<{first}[0], {first}[1], {second}[0], {second}[1]>")


def _indices(w: Writer) -> None:
    name = w.fresh("X")
    w.line(f"#declare {name} = array[3] {{ 10, 20, 30 }}")
    w.show("f", f"{name}[{w.pick(('0.99999999999', '1.5', '2.9', '-0.5', '1e-12', 'true', '2.99999999999', '1/3*3', '-1e-12'))}]")
    w.show("f", f"{name} [{w.rng.randint(0, 2)}]")
    w.show("f", f"{name}[{name}[0]/10]")


def _loop(w: Writer) -> None:
    name = w.fresh("L")
    w.line(f"#declare {name} = array[{w.rng.randint(3, 6)}][2]")
    w.line(f"#for (I, 0, dimension_size({name}, 1) - 1) #for (K, 0, 1) #declare {name}[I][K] = I*10 + K; #end #end")
    w.line(f"#declare Total = 0; #for (I, 0, 2) #declare Total = Total*2 + {name}[I][mod(I, 2)]; #end")
    w.show("f", "Total")
