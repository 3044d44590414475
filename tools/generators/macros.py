"""Macros: by reference and by value, bodies that leak into expressions, recursion, return by #break."""

from generators import expressions, strings
from generators.writer import Writer


def piece(w: Writer) -> None:
    w.pick((_value, _value, _leak, _reference, _reference, _recursion, _return, _nested, _statements, _dynamic))(w)


def _argument(w: Writer) -> str:
    return expressions.number(w, w.rng.randint(0, 2))


def _value(w: Writer) -> None:
    """A macro of a float value, which later expressions may call."""
    name = w.fresh("M")
    body = w.pick(("(A*2 + B)", "(A < B ? A : B)", "max(A, B) - 1", "#local R = A*A + B; R", "#if (A > B) A #else B #end",
                   "#local R = 0; #for (K, 1, 3) #local R = R + A/K; #end (R)", "vlength(<A, B, 1>)"))
    w.line(f"#macro {name}(A{w.pick((',', ', ', ' '))}B) {body} #end")
    first, second = _argument(w), _argument(w)
    w.show("f", f"({name}({first}, {second}))")
    w.show("v3", f"<{name}({first}, 1), {name}(2, {second}), 0>")
    w.line(f"#declare {w.fresh('V')} = {name}({first}, {second});" if "#if" not in body else "")


def _leak(w: Writer) -> None:
    """The body takes part in the expression around the call."""
    name = w.fresh("L")
    body = w.pick(("A + B", "A - B", "A*B", "A/B + 1", "-A", "A", "A < B", "A + B > 3", "<A, B, 1>", "<A,B,2>*B"))
    w.line(f"#macro {name}(A, B) {body} #end")
    call = f"{name}({w.rng.randint(1, 9)}, {w.rng.randint(1, 9)})"
    vector = body.startswith("<")
    shapes = (f"({call}.y)", f"({call}.x*2)", f"vlength({call})") if vector else \
        (f"(2*{call})", f"({call}*2)", f"(10 - {call})", f"({call} + {call}*2)", f"abs({call})", f"(!{call})", f"(-{call} + 1)",
         f"(1 + {call} < 4)", f"({call} ? 7 : 8)")
    for _ in range(2):
        w.show("f", w.pick(shapes))


def _reference(w: Writer) -> None:
    """Whether the caller's variable changes, for every way to write the argument."""
    name, kind = w.fresh("R"), w.pick(("f", "v3", "s", "c", "f"))
    new = {"f": "P + 10", "v3": "P*2 + x", "s": 'concat(P, "!")', "c": "P*0.5"}[kind]
    other = w.pick((new, new, {"f": '"text"', "v3": "5", "s": "3", "c": "1"}[kind]))
    how = w.pick(("declare", "local"))
    w.line(f"#macro {name}(P) #{how} P = {other}; #end")
    variable = w.fresh("V")
    start = {"f": "4", "v3": "<1,2,3>", "s": '"s"', "c": "rgbft <.1,.2,.3,.4,.5>"}[kind]
    w.line(f"#declare {variable} = {start};")
    forms = [variable] + {"f": [f"({variable})", f"+{variable}", f"{variable}+0"], "v3": [f"({variable})", f"{variable}+0"],
                          "s": [f"concat({variable})"], "c": [f"({variable})", f"color {variable}"]}[kind]
    w.line(f"{name}({w.pick(forms)})")
    after = kind
    if other != new:
        w.line(f"#declare {variable} = {start};")
    w.show(after, variable)
    w.declare(kind, variable)
    if kind == "f" and other == new:
        array = w.fresh("A")
        w.line(f"#declare {array} = array[3] {{ 1, 2, 3 }}")
        w.line(f"{name}({array}[{w.rng.randint(0, 2)}])")
        w.show("v3", f"<{array}[0], {array}[1], {array}[2]>")
        outer = w.fresh("O")
        w.line(f"#macro {outer}(Q) {name}(Q) #{how} Q = Q*2; #end {outer}({variable})")
        w.show("f", variable)


def _recursion(w: Writer) -> None:
    name = w.fresh("F")
    body = w.pick((f"#if (N <= 1) 1 #else (N*{name}(N - 1)) #end", f"#if (N > 0) (N + {name}(N - 2)) #else 0 #end",
                   f"#if (N < 2) (N) #else ({name}(N - 1) + {name}(N - 2)) #end"))
    w.line(f"#macro {name}(N) {body} #end")
    w.show("f", f"({name}({w.rng.randint(0, 7)}))")


def _return(w: Writer) -> None:
    name, result = w.fresh("B"), w.fresh("G")
    w.line(f"#declare {result} = 0;")
    where = w.pick(("#if (N > 2) #break #end", "#break", "#while (1) #break #end", "#for (K, 1, 5) #if (K > N) #break #end #end",
                    "#switch (N) #case (1) #break #case (3) #end", "#if (N = 1) #if (1) #break #end #end"))
    w.line(f"#macro {name}(N) #declare {result} = {result} + 1; {where} #declare {result} = {result} + 10; #end")
    for value in range(1, 4):
        w.line(f"{name}({value})")
    w.show("f", result)


def _nested(w: Writer) -> None:
    """A macro that defines another, and a redefinition."""
    outer, inner = w.fresh("D"), w.fresh("N")
    w.line(f"#macro {outer}(P) #macro {inner}(Q) (Q + {w.rng.randint(1, 9)}) #end (P*2) #end")
    w.show("f", f"({outer}(3))")
    w.show("f", f"({inner}({expressions.number(w, 1)}))")
    if w.chance(0.5):
        w.line(f"#macro {inner}(Q, S) (Q*S) #end")
        w.show("f", f"({inner}(4, 5))")


def _statements(w: Writer) -> None:
    name = w.fresh("T")
    w.line(f"#macro {name}(Text, V)")
    w.line(f'  #local Both = concat(Text, "/", vstr(3, V, " ", 0, 3));')
    w.line(f'  #debug concat(Both, "\\n")')
    w.line(f"  #ifdef (Hidden) #debug \"hidden\\n\" #end")
    w.line("#end")
    for _ in range(w.rng.randint(1, 2)):
        w.line(f"{name}({strings.string(w, 1)}, {expressions.vector(w, 3, 1)})")
    w.line(f"#ifdef (Both) #debug \"leaked\\n\" #end")


def _dynamic(w: Writer) -> None:
    """Names are looked up through the callers."""
    inner, outer, name = w.fresh("I"), w.fresh("O"), w.fresh("Z")
    w.line(f"#declare {name} = 1;")
    change = w.pick((f"#declare {name} = {name} + 1;", f"#local {name} = 5;", f"#local Old = {name}; #local {name} = Old + 1;"))
    w.line(f"#macro {inner}() {change} ({name}) #end")
    w.line(f"#macro {outer}() #{w.pick(('declare', 'local'))} {name} = 50; #local R = {inner}(); (R + {name}/1000) #end")
    w.show("f", f"({outer}())")
    w.show("f", name)
    w.show("f", f"({inner}())")
    w.show("f", name)
