"""Conditions, switches and loops, nested into one another."""

from generators import expressions
from generators.writer import Writer


def piece(w: Writer) -> None:
    construct(w, w.rng.randint(1, 3))


def construct(w: Writer, depth: int) -> None:
    w.pick((_if, _if, _switch, _for, _for, _while))(w, depth)


def _body(w: Writer, depth: int) -> None:
    """Some items in a branch that may or may not run: no name declared in it is relied on later."""
    before, prefix = w.snapshot(), w.prefix
    w.prefix = prefix + "  "
    for _ in range(w.rng.randint(1, 2)):
        kind = w.rng.randint(0, 5)
        if kind <= 1 and depth > 0:
            construct(w, depth - 1)
        elif kind <= 3 and w.known("f"):
            name = w.pick(w.known("f"))
            w.line(f"#declare {name} = {w.pick((f'{name} + 1', f'mod({name}*3, 17)', expressions.number(w, 1)))};")
        else:
            w.show("f", expressions.number(w, 2))
    w.prefix, w.names = prefix, before


def _condition(w: Writer) -> str:
    return expressions.full(w, w.rng.randint(0, 2))


def _if(w: Writer, depth: int) -> None:
    if w.chance(0.2):
        name = w.pick(w.known("f") or ["Nothing"]) if w.chance(0.6) else "Nothing"
        w.line(f"#{w.pick(('ifdef', 'ifndef'))} ({name})")
    else:
        w.line(f"#if ({_condition(w)})")
    _body(w, depth)
    for _ in range(w.rng.choice((0, 0, 1, 2))):
        w.line(f"#elseif ({_condition(w)})")
        _body(w, depth)
    if w.chance(0.5):
        w.line("#else")
        _body(w, depth)
    w.line("#end")


def _switch(w: Writer, depth: int) -> None:
    w.line(f"#switch ({w.pick((str(w.rng.randint(0, 5)), f'mod(abs({expressions.factor(w, 1)}), 5)', expressions.number(w, 1)))})")
    for _ in range(w.rng.randint(1, 4)):
        if w.chance(0.6):
            w.line(f"  #case ({w.pick((str(w.rng.randint(0, 5)), expressions.number(w, 0)))})")
        else:
            low = w.rng.randint(-2, 4)
            w.line(f"  #range ({low}, {low + w.rng.randint(0, 3)})")
        _body(w, depth)
        if w.chance(0.6):
            w.line("  #break")
    if w.chance(0.5):
        w.line("  #else")
        _body(w, depth)
    w.line("#end")


def _for(w: Writer, depth: int) -> None:
    name = w.fresh("I")
    start, end = w.rng.randint(-2, 3), w.rng.randint(-2, 6)
    step = w.pick(("", ", 0.5", ", 2", ", -1", ", .1*3", " 1.5"))
    w.line(f"#for ({name}, {start}, {end}{step})")
    before = w.snapshot()
    w.declare("f", name)
    w.show("f", name)
    w.forget(name)
    w.declare("float source", name)  # may be read but not assigned: the loop must end
    _body(w, depth - 1)
    if w.chance(0.2):
        w.line(f"  #if ({name} > {w.rng.randint(0, 3)}) #break #end")
    if w.chance(0.15):
        w.line(f"  #declare {name} = {name} + 0.5;" if not step.startswith(", -") else f"  #declare {name} = {name} - 1;")
    w.names = before
    w.line("#end")
    w.declare("f", name)
    w.show("f", name)


def _while(w: Writer, depth: int) -> None:
    name = w.fresh("W")
    w.line(f"#declare {name} = 0;")
    w.line(f"#while ({name} < {w.rng.randint(0, 4)}{w.pick(('', ' & ' + str(w.rng.randint(0, 1)), ' | 0'))})")
    before = w.snapshot()
    w.declare("float source", name)
    _body(w, depth - 1)
    if w.chance(0.2):
        w.line(f"  #if ({name} > 1) #break #end")
    w.names = before
    w.line(f"  #declare {name} = {name} + {w.pick(('1', '1', '0.7'))};")
    w.line("#end")
    w.declare("f", name)
    w.show("f", name)
