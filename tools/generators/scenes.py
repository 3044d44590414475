"""Random scenes: objects of every type under CSG, with random textures, lamps and cameras."""

import random
from collections.abc import Callable, Sequence
from typing import TypeVar

T = TypeVar("T")

PATTERNS = ("agate", "bozo", "boxed", "bumps", "cells", "crackle", "crackle {a} solid", "cubic", "cylindrical", "dents",
            "gradient x", "gradient <1, 1, 0>", "granite", "leopard", "marble", "onion", "planar", "quilted", "radial",
            "ripples", "spherical", "spiral1 3", "spiral2 5", "spotted", "square", "triangular 3", "waves", "wood",
            "wrinkles", "julia <0.353, 0.288>, 30", "mandel 30", "magnet 1 mandel 20", "tiling 7", "tiling 18",
            "pavement {a} number_of_sides 4 number_of_tiles 3 pattern 2",
            "crackle {a} form <-0.4, 0.9, 0.2> metric 3", "function {{ abs(sin(4*x)*cos(5*y) + 0.3*z) }}")
SOLIDS = ("sphere", "box", "cone", "cylinder", "torus", "superellipsoid", "blob", "lathe", "sor", "prism",
          "sphere_sweep", "isosurface", "ovus")
CAMERAS = ("location <0, 1.2, -5> look_at 0 angle 40", "orthographic location <1, 2, -5> look_at 0 right 4*x up 3*y",
           "fisheye location <2, 1, -4> look_at 0 angle 70", "ultra_wide_angle location <-2, 2, -4> look_at 0 angle 80",
           "panoramic location <0, 1, -4> look_at 0 angle 80", "cylinder 1 location <0, 0.5, -4> look_at 0 angle 60",
           "location <0, 1, -5> look_at 0 angle 40 normal { bumps 0.05 scale 0.2 }")
WAVES = ("ramp_wave", "sine_wave", "triangle_wave", "scallop_wave", "cubic_wave", "poly_wave 1.7")


def scene(seed: int) -> str:
    """The text of the scene with that number."""
    return Scene(random.Random(seed)).text()


class Scene:
    """One scene in the making. Methods give source text."""

    def __init__(self, rng: random.Random) -> None:
        self.rng = rng

    def text(self) -> str:
        """All of it."""
        noise = self.maybe(0.25, lambda: f"noise_generator {self.rng.randint(1, 3)}")
        parts = ["#version 3.7;",
                 f"global_settings {{ assumed_gamma {self.pick(('1', '1', '2.2'))} max_trace_level 6 {noise}}}",
                 "#default { finish { ambient 0.1 } }",
                 f"camera {{ {self.pick((CAMERAS[0],) * 5 + CAMERAS[1:])} }}",
                 f"background {{ {self.plain()} }}",
                 self.maybe(0.3, lambda: f"sky_sphere {{ {self.pigment()} }}"),
                 self.maybe(0.1, lambda: f"fog {{ distance {self.number(8, 25)} {self.plain()} }}"),
                 self.maybe(0.5, lambda: f"plane {{ y, -1.1 {self.pigment()} {self.normal()} {self.finish()} }}")]
        parts += [self.lamp() for _ in range(self.rng.randint(1, 3))]
        parts += [self.object() for _ in range(self.rng.randint(1, 3))]
        return "\n".join(part for part in parts if part) + "\n"

    def pick(self, choices: Sequence[T]) -> T:
        """One of several."""
        return self.rng.choice(choices)

    def maybe(self, share: float, make: Callable[[], str]) -> str:
        """Something or, more or less often, nothing."""
        return make() + " " if self.rng.random() < share else ""

    def number(self, low: float = 0, high: float = 1) -> float:
        """A number of three digits."""
        return round(self.rng.uniform(low, high), 3)

    def vector(self, low: float = -1, high: float = 1) -> str:
        """Three of them."""
        return f"<{self.number(low, high)}, {self.number(low, high)}, {self.number(low, high)}>"

    def plain(self) -> str:
        """An opaque colour."""
        return f"rgb {self.vector(0, 1)}"

    def colour(self) -> str:
        """One that may let light through."""
        clear = f"<{self.number()}, {self.number()}, {self.number()}, {self.number(0, 0.9)}>"
        return self.pick((self.plain(), self.plain(), f"rgbt {clear}", f"rgbf {clear}"))

    def moves(self, most: int = 3) -> str:
        """Transformations."""
        size = (0.6, 1.5)
        kinds = (lambda: f"rotate {self.vector(-180, 180)}", lambda: f"translate {self.vector(-0.4, 0.4)}",
                 lambda: f"scale {self.number(*size)}", lambda: f"scale {self.vector(*size)}",
                 lambda: f"scale <-1, {self.number(*size)}, 1>",
                 lambda: f"matrix <1, {self.number(-0.4, 0.4)}, 0, 0, 1, {self.number(-0.4, 0.4)}, 0, 0, 1, 0, 0, 0>")
        return " ".join(self.pick(kinds)() for _ in range(self.rng.randint(0, most)))

    def turbulence(self) -> str:
        """Stirring, or none."""
        return self.pick(("", "", f"turbulence {self.number()} ",
                          f"turbulence {self.vector(0, 1)} octaves {self.rng.randint(1, 8)} omega {self.number(0.2, 0.8)} "
                          f"lambda {self.number(1.2, 3)} "))

    def warp(self) -> str:
        """A warp."""
        return "warp { " + self.pick((
            f"turbulence {self.vector(0, 0.6)}", f"repeat {self.pick('xyz')} * {self.number(0.4, 1)}",
            f"repeat x * 0.7 flip {self.pick('xyz')} offset {self.vector(0, 0.3)}",
            f"black_hole {self.vector(-0.5, 0.5)}, {self.number(0.2, 0.6)} strength {self.number(0.5, 2)}",
            "cylindrical", "toroidal", "planar")) + " } "

    def waves(self) -> str:
        """How a pattern's value is shaped."""
        return self.maybe(0.4, lambda: self.pick(WAVES)) + self.maybe(
            0.4, lambda: f"frequency {self.number(0.5, 4)} phase {self.number()}")

    def pigment(self, depth: int = 0) -> str:
        """A pigment, perhaps of pigments."""
        kind = self.rng.random()
        if kind < 0.25:
            body = self.colour()
        elif kind < 0.35:
            body = self.pick((f"checker {self.colour()}, {self.colour()}",
                              f"hexagon {self.colour()} {self.colour()} {self.colour()}",
                              f"brick {self.colour()}, {self.colour()} mortar {self.number(0.05, 0.3)}"))
        elif kind < 0.45 and depth < 2:
            inner = [self.pigment(depth + 1).removeprefix("pigment {").removesuffix("}") for _ in range(2)]
            body = f"{self.pattern()} pigment_map {{ [0 {inner[0]}] [{self.number(0.3, 1)} {inner[1]}] }}"
        else:
            keys = sorted(self.number() for _ in range(self.rng.randint(2, 4)))
            colours = "color_map { " + " ".join(f"[{key} {self.colour()}]" for key in keys) + " } "
            body = f"{self.pattern()} {self.turbulence()}{self.pick(('', colours))}{self.waves()}" + self.maybe(0.3, self.warp)
        return f"pigment {{ {body} {self.moves(2)} scale {self.number(0.2, 1)} }}"

    def pattern(self, amount: str = "") -> str:
        """A pattern; the amount of bumps stands right behind the name of those with options."""
        text = self.pick(PATTERNS)
        if "{a}" in text:
            return text.format(a=amount)
        return f"{text.format()} {amount}"

    def normal(self) -> str:
        """Bumps, or none."""
        return self.maybe(0.35, lambda: f"normal {{ {self.pattern(str(self.number(0.1, 1)))} {self.turbulence()}"
                                        f"{self.moves(1)} scale {self.number(0.2, 0.8)} }}")

    def finish(self) -> str:
        """A few of the settings."""
        ranges = (("ambient", 0, 0.4), ("diffuse", 0.2, 1), ("phong", 0, 1), ("phong_size", 5, 80), ("specular", 0, 1),
                  ("roughness", 0.005, 0.2), ("brilliance", 0.5, 3), ("metallic", 0, 1), ("reflection", 0, 0.6),
                  ("emission", 0, 0.3), ("irid {{ 0.3 thickness {} }}", 0.1, 1),
                  ("reflection {{ {}, 0.9 fresnel on }} conserve_energy", 0, 0.4))
        chosen = [(name, self.number(low, high)) for name, low, high in ranges if self.rng.random() < 0.2]
        words = [name.format(value) if "{" in name else f"{name} {value}" for name, value in chosen]
        return "finish { " + " ".join(words) + " }"

    def texture(self) -> str:
        """One of one layer or two, or a map."""
        kind = self.rng.random()
        if kind < 0.75:
            return f"texture {{ {self.pigment()} {self.normal()}{self.finish()} {self.moves(1)} }}"
        if kind < 0.87:
            veil = f"color_map {{ [0.3 rgbt 1] [0.5 rgbt <{self.number()}, {self.number()}, {self.number()}, 0.4>] }}"
            return (f"texture {{ {self.pigment()} {self.normal()}{self.finish()} }} "
                    f"texture {{ pigment {{ {self.pattern()} {veil} scale {self.number(0.2, 0.8)} }} {self.finish()} }}")
        return (f"texture {{ {self.pattern()} texture_map {{ [0.2 {self.pigment()} {self.finish()}] "
                f"[0.8 {self.pigment()} {self.normal()}] }} scale {self.number(0.3, 1)} }}")

    def interior(self) -> str:
        """What is inside."""
        return self.maybe(0.4, lambda: "interior { " + self.pick((
            f"ior {self.number(1, 1.8)}", "ior 1.4 dispersion 1.05",
            f"ior 1.3 fade_distance {self.number(0.5, 2)} fade_power 2 fade_color {self.vector(0, 1)}")) + " }")

    def primitive(self) -> str:
        """A primitive without its closing brace."""
        n, v = self.number, self.vector
        spline = self.pick(("linear_spline", "cubic_spline"))
        rods = " ".join(self.pick((f"sphere {{ {v(-0.6, 0.6)}, {n(0.5, 1)}, {n(0.5, 1.2)} }}",
                                   f"cylinder {{ {v(-0.6, 0.6)}, {v(-0.6, 0.6)}, {n(0.3, 0.7)}, 0.9 }}"))
                        for _ in range(self.rng.randint(1, 4)))
        grid = ", ".join(f"<{x}, {n(-0.4, 0.4)}, {z}>" for z in (-0.9, -0.3, 0.3, 0.9) for x in (-0.9, -0.3, 0.3, 0.9))
        return self.pick((
            f"sphere {{ {v(-0.4, 0.4)}, {n(0.4)}", f"box {{ {v(-0.9, -0.2)}, {v(0.2, 0.9)}",
            f"cone {{ {v(-0.7, 0)}, {n(0.2, 0.8)}, {v(0.2, 0.9)}, {n(0, 0.5)}",
            f"cylinder {{ {v(-0.8, -0.1)}, {v(0.1, 0.8)}, {n(0.2, 0.7)}", f"torus {{ {n(0.4, 0.8)}, {n(0.1, 0.35)}",
            f"superellipsoid {{ <{n(0.2, 1.8)}, {n(0.2, 1.8)}> scale 0.8", f"disc {{ 0, {v()}, {n(0.5)}, {n(0, 0.3)}",
            f"blob {{ threshold {n(0.3, 0.7)} {rods}",
            f"lathe {{ {spline} 5 <0, -0.8>, <{n(0.2, 0.8)}, -0.5>, <{n(0.2, 0.8)}, 0>, <0.4, 0.4>, <{n(0, 0.5)}, 0.8>",
            f"prism {{ -0.5, 0.5, 5 <-0.6, -0.6>, <0.7, -0.5>, <{n(0.2, 0.8)}, 0.6>, <-0.5, {n(0.2, 0.8)}>, <-0.6, -0.6>",
            f"sphere_sweep {{ {spline} 4 <-0.8, {n(-0.5, 0.5)}, 0>, {n(0.1, 0.3)} <-0.2, 0.2, 0>, {n(0.1, 0.3)} "
            f"<0.4, {n(-0.5, 0.5)}, 0.1>, 0.2 <0.8, 0, 0>, {n(0.1, 0.3)}",
            f"quadric {{ <{n(0.5, 2)}, {n(-1, 2)}, {n(0.5, 2)}>, 0, 0, -{n(0.2, 0.8)} clipped_by {{ box {{ -1, 1 }} }}",
            f"isosurface {{ function {{ x*x + {n(0.6, 2)}*y*y + z*z - 0.6 + 0.1*sin(8*x)*sin(7*y) }} max_gradient 9 "
            "contained_by { sphere { 0, 1.1 } } accuracy 0.0005 all_intersections",
            f"cubic {{ <0, 0, 0, 1, 0, 0, 0, 0, 0, -0.6, 0, 0, 0, 0, 0, 0, 1, 0, 0.3, {n(-0.2, 0.2)}> "
            "clipped_by { sphere { 0, 1.1 } }",
            f"triangle {{ {v()}, {v()}, {v()}", f"mesh {{ triangle {{ {v()}, {v()}, {v()} }} triangle {{ {v()}, {v()}, {v()} }}",
            f"smooth_triangle {{ <-0.8, -0.6, 0>, <0.1, 0.2, -1>, <0.9, -0.5, {n(-0.3, 0.3)}>, <-0.3, 0.1, -1>, <0.1, 0.9, 0>, -z",
            f"bicubic_patch {{ type 1 flatness 0.001 u_steps 4 v_steps 4 {grid}",
            f"height_field {{ function 20, 20 {{ 0.5 + 0.4*sin(9*x)*cos({n(3, 9)}*y) }} translate -0.5 scale 1.6",
            f"ovus {{ {n(0.4, 0.7)}, {n(0.2, 0.35)} translate -0.3*y",
            f"plane {{ {v()}, -{n(0, 0.3)} clipped_by {{ box {{ -1, 1 }} }}"))

    def leaf(self, solid: bool = False, textured: bool = True) -> str:
        """A whole primitive."""
        body = self.primitive()
        while solid and not body.startswith(SOLIDS):
            body = self.primitive()
        look = self.texture() if textured else ""
        return f"{body} {look} {self.interior()}{self.moves()} {self.flag()} }}"

    def object(self, depth: int = 0) -> str:
        """A primitive, or several under CSG."""
        if depth > 1 or self.rng.random() < 0.6:
            return self.leaf()
        kind = self.pick(("union", "difference", "intersection", "merge"))
        parts = [self.object(depth + 1) if kind == "union" else self.leaf(True, self.rng.random() < 0.5)
                 for _ in range(self.rng.randint(2, 3))]
        extras = {"union": ("", "split_union on"), "merge": ("", "clipped_by { box { -0.8, 0.8 } }")}
        extra = self.pick(extras.get(kind, ("", "cutaway_textures", "clipped_by { plane { y, 0.3 } }")))
        inside = "\n  ".join(parts)
        return f"{kind} {{\n  {inside}\n  {self.texture()} {self.interior()}{extra} {self.moves(2)} {self.flag()} }}"

    def flag(self) -> str:
        """A modifier without operands, sometimes."""
        return self.pick(("",) * 5 + ("no_shadow", "no_reflection", "no_image", "double_illuminate", "hollow"))

    def lamp(self) -> str:
        """A light source."""
        kinds = ("", "", "", f"spotlight point_at 0 radius {self.number(5, 12)} falloff {self.number(14, 25)}",
                 "parallel point_at 0", f"fade_distance {self.number(4, 9)} fade_power {self.rng.randint(1, 3)}",
                 "cylinder point_at 0 radius 1.5 falloff 2.5", "shadowless")
        place = f"<{self.number(-8, 8)}, {self.number(3, 9)}, {self.number(-9, -2)}>"
        return f"light_source {{ {place} {self.plain()} {self.pick(kinds)} }}"
