"""Scopes: #declare, #local, #undef, defined, changes of type, #default-free names."""

from generators import expressions
from generators.writer import Writer


def piece(w: Writer) -> None:
    w.pick((_undef, _retype, _shadow, _old_value, _defined, _semicolons))(w)


def _undef(w: Writer) -> None:
    name, macro = w.fresh("U"), w.fresh("M")
    w.line(f"#declare {name} = {expressions.number(w, 1)};")
    w.line(w.pick((f"#undef {name}", f"#macro {macro}() #undef {name} #end {macro}()",
                   f"#macro {macro}() #local {name} = 7; #undef {name} #end {macro}()",
                   f"#macro {macro}() #local {name} = 7; #undef {name} #undef {name} #end {macro}()")))
    w.show("f", f"defined({name})")


def _retype(w: Writer) -> None:
    name = w.fresh("T")
    values = {"f": "1", "s": '"s"', "v3": "<1,2,3>", "c": "rgb 1", "v2": "<1,2>", "v4": "<1,2,3,4>"}
    for kind in w.rng.sample(list(values), 3):
        w.line(f"#{w.pick(('declare', 'local'))} {name} = {values[kind]};")
        w.show(kind, name)


def _shadow(w: Writer) -> None:
    """Assignments to one name at three levels, as variable or parameter.

    The old value is read into a name of its own: POV-Ray makes the new local before it reads.
    """
    name, inner, outer = w.fresh("H"), w.fresh("I"), w.fresh("O")
    word = lambda: w.pick(("declare", "local"))
    by_parameter = w.chance(0.5)
    w.line(f"#{word()} {name} = 1;")
    w.line(f"#macro {inner}({name if by_parameter else ''}) #local Old = {name}; #{word()} {name} = Old*3 + 1; "
           f'#debug concat(str({name}, 0, 1), "\\n") #end')
    call = f"{inner}({w.pick((name, f'({name})', '8')) if by_parameter else ''})"
    w.line(f"#macro {outer}() #{word()} {name} = 20; {call} #{word()} {name} = 7; {call} #end")
    w.line(f"{outer}() {call}")
    w.show("f", name)


def _old_value(w: Writer) -> None:
    name = w.fresh("Q")
    w.line(f"#declare {name} = {w.rng.randint(1, 9)};")
    w.line(f"#declare {name} = <{name}, {name} + 1, {name}*2>;")
    w.show("v3", name)
    w.line(f"#declare {name} = {name}.y + {name}.z;")
    w.show("f", name)


def _defined(w: Writer) -> None:
    for name in w.rng.sample(("sphere", "sin", "x", "image_width", "clock", "Nothing", "pi", "frame_number", "version",
                              "array", *w.known("f")[:3]), 3):
        w.show("f", f"defined({name})")


def _semicolons(w: Writer) -> None:
    name = w.fresh("E")
    w.line(w.pick((f"#declare {name} = 1;;", f"#declare {name} = #if (1) 1; #else 2; #end", f"#declare {name} = <1, #if (0) 2 #else 7 #end, 3>.y;",
                   f"#declare {name} = (1 #if (1) +2 #end);", f"#declare {name} = /* c */ 4 // c\n;", f"# declare {name} = 2;",
                   f"#declare\n{name}\n=\n5\n;")))
    w.show("f", name)
