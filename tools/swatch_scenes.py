"""What is written to show something in a swatch: the parts of its scene that a name alone does not tell."""

WAYS = {  # kind → how a swatch shows it; what it shows fits into the ball of radius 1 at the origin
    "color": "sphere {{ 0, 1 pigment {{ {} }} }}",
    "pigment": "sphere {{ 0, 1 pigment {{ {} }} }}",
    "color_map": "box {{ -1, 1 pigment {{ gradient x color_map {{ {} }} scale 2 translate -x }} }}",
    "texture": "sphere {{ 0, 1 texture {{ {} }} }}",
    "finish": "sphere {{ 0, 1 pigment {{ rgb <0.7, 0.5, 0.3> }} finish {{ {} }} }}",
    "interior": "sphere {{ 0, 1 pigment {{ rgbf 0.9 }} finish {{ specular 0.5 }} interior {{ {} fade_color rgb <0.3, 0.7, 0.5> }} }}",
    "material": "sphere {{ 0, 1 material {{ {} }} }}",
    "letter": "object {{ {} pigment {{ rgb <0.8, 0.7, 0.5> }} translate -2.5 * y scale 0.37 }}",
    # walls and balls, so that both what changes over a place and what changes with the surface are seen
    "pattern": "box {{ <-1, -1, 0>, <1, 1, 0.1> pigment {{ {} scale 0.5 }} finish {{ ambient 0.9 diffuse 0.1 }} }}",
    "floor": "box {{ <-1, -1, 0>, <1, 1, 0.1> pigment {{ {} scale 0.5 rotate -90 * x }} finish {{ ambient 0.9 diffuse 0.1 }} }}",
    "ball": "sphere {{ 0, 1 pigment {{ {} }} finish {{ ambient 0.9 diffuse 0.1 }} }}",
    "bump": "sphere {{ 0, 1 pigment {{ rgb <0.8, 0.7, 0.5> }} normal {{ {} }} finish {{ specular 0.4 }} }}",
    "shape": "object {{ {} pigment {{ rgb <0.8, 0.7, 0.5> }} finish {{ specular 0.4 }} rotate <-20, 25, 0> }}",
    "made": "object {{ Fitted({}) }}",
}
OBJECT = ("intersection {{{{ object {{{{ {{}} }}}} box {{{{ -{0}, {0} }}}} pigment {{{{ rgb <0.8, 0.7, 0.5> }}}} "
          "finish {{{{ specular 0.4 }}}} rotate <-20, 25, 0> scale {1:.4g} }}}}")
SURFACE = OBJECT.replace("intersection", "object").replace("box {{{{", "clipped_by {{{{ box {{{{", 1).replace("}}}} pigment", "}}}} }}}} pigment", 1)
WINDOWS = {  # how much is shown of objects that are much larger or smaller than 1
    "Tetrahedron": 3, "HalfCone_Y": 1, "Pyramid2": 1.1, "Bicorn": 1, "Crossed_Trough": 3, "Torus_40_12": 10,
    "Hyperbolic_Torus_40_12": 12, "Parabolic_Torus_40_12": 12, "Glob_5": 1.2, "Twin_Glob": 1.2, "Piriform": 1.2, "Lemniscate": 1.2,
    "Steiner_Surface": 0.8, "Square_X": 1.2, "Square_Y": 1.2, "Square_Z": 1.2, "Devils_Curve": 4, "Folium": 3, "Witch_Hat": 3,
    "Helix": 2.5, "Helix_1": 2.5, "Sinsurf": 6, "Quartic_Cylinder": 2.5, "Quartic_Paraboloid": 3, "Quartic_Loop_1": 1.4,
}

GREY = " color_map { [0 rgb 0.05] [1 rgb 0.95] }"
_ALONE = ("agate", "boxed", "bozo", "brick", "bumps", "checker", "crackle", "cylindrical", "granite", "leopard", "marble", "onion",
          "planar", "quilted", "ripples", "spherical", "spotted", "waves", "wood", "wrinkles", "cells")
PATTERNS = {name: (name, "pattern") for name in _ALONE} | {name: (name, "floor") for name in ("hexagon", "radial", "square", "triangular")} | {
    "aoi": ("aoi", "ball"), "average": ("average pigment_map { [1 gradient x] [1 gradient y] }", "pattern"), "cubic": ("cubic", "ball"),
    "dents": ("dents 1 scale 0.3", "bump"), "facets": ("facets coords 0.4", "bump"),
    "function": ("function { 0.5 + 0.25 * sin(7 * x * y) + 0.25 * cos(5 * x) }", "pattern"), "gradient": ("gradient x", "pattern"),
    "image_map": ("image_map { function 64, 64 { pattern { marble turbulence 1 scale 0.4 } } } translate <-0.5, -0.5, 0> scale 4", "pattern"),
    "julia": ("julia <0.353, 0.288>, 30", "pattern"), "magnet": ("magnet 1 mandel 25", "pattern"), "mandel": ("mandel 25", "pattern"),
    "object": ("object { torus { 1, 0.4 rotate 90 * x } rgb 0.95 rgb <0.6, 0.2, 0.1> }", "pattern"),
    "pavement": ("pavement number_of_sides 4 number_of_tiles 4 pattern 2 form 2", "floor"),
    "pigment_pattern": ("pigment_pattern { crackle turbulence 0.3 }", "pattern"), "slope": ("slope y", "ball"),
    "spiral1": ("spiral1 3", "pattern"), "spiral2": ("spiral2 3", "pattern"), "tiling": ("tiling 7", "floor"),
}
FLAT = ("agate", "average", "brick", "checker", "cubic", "granite", "marble", "wood", "hexagon", "image_map", "object", "square", "triangular")

_SQUARE = "<-0.8, -0.6>, <0.8, -0.6>, <0.8, 0.6>, <0, 0.1>, <-0.8, 0.6>, <-0.8, -0.6>"
SHAPES = {
    "bicubic_patch": "bicubic_patch { type 1 u_steps 4 v_steps 4 " + ", ".join(
        f"<{0.6 * x - 0.9:.4g}, {(0.8 if x in (1, 2) and y in (1, 2) else -0.3)}, {0.6 * y - 0.9:.4g}>" for y in range(4) for x in range(4)) + " }",
    "blob": "blob { threshold 0.5 sphere { <-0.4, 0, 0>, 0.9, 1 } sphere { <0.4, 0.2, 0>, 0.8, 1 } }",
    "box": "box { -0.65, 0.65 }", "cone": "cone { -0.8 * y, 0.8, 0.9 * y, 0.1 }", "cylinder": "cylinder { -0.8 * y, 0.8 * y, 0.6 }",
    "disc": "disc { 0, y + z, 0.9, 0.3 }",
    "height_field": "height_field { function 60, 60 { pattern { spotted scale 0.3 } } smooth scale <2, 0.8, 2> translate <-1, 0, -1> }",
    "isosurface": "isosurface { function { x*x + y*y + z*z - 0.7 + 0.2*sin(12*x)*sin(12*y)*sin(12*z) } contained_by { box { -1, 1 } } max_gradient 5 }",
    "julia_fractal": "julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 30 scale 0.6 }",
    "lathe": "lathe { quadratic_spline 6, <0, -0.9>, <0.3, -0.9>, <0.6, -0.4>, <0.2, 0.2>, <0.4, 0.8>, <0.5, 0.9> }",
    "lemon": "lemon { -y, 0.1, y, 0.1, 1.2 }",
    "mesh": "mesh { triangle { <-0.9, -0.6, 0>, <0.9, -0.6, 0>, <0, 0.9, 0> } triangle { <-0.9, -0.6, 0>, <0.9, -0.6, 0>, <0, -0.3, -0.9> } }",
    "ovus": "ovus { 0.7, 0.35 translate -0.3 * y }",
    "parametric": "parametric { function { cos(u) * (1 + 0.4 * cos(v)) } function { 0.4 * sin(v) } function { sin(u) * (1 + 0.4 * cos(v)) } "
                  "<0, 0>, <4.5, 2 * pi> contained_by { box { -1.5, 1.5 } } max_gradient 3 accuracy 0.002 scale 0.65 }",
    "plane": "intersection { plane { y, 0 } box { <-1, -0.01, -1>, 1 } }",
    "poly": "intersection { poly { 4, <1, 0, 0, 0, 0, 0, 0, 0, 0, -2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -2, 0, 0, 0, 0, 0, 1, 0, -2, 0, 1.2> } box { -1.6, 1.6 } scale 0.6 }",
    "polygon": f"polygon {{ 6, {_SQUARE} }}", "prism": f"prism {{ -0.4, 0.4, 6, {_SQUARE} }}",
    "quadric": "intersection { quadric { <1, -0.5, 1>, 0, 0, -0.15 } box { -0.9, 0.9 } }",
    "smooth_triangle": "smooth_triangle { <-0.9, -0.7, 0>, <-1, -1, -1>, <0.9, -0.5, 0>, <1, -1, -1>, <0, 0.9, 0>, <0, 1, -1> }",
    "sor": "sor { 6, <0.3, -1.1>, <0.5, -0.9>, <0.8, -0.3>, <0.3, 0.4>, <0.5, 0.9>, <0.6, 1.1> }",
    "sphere": "sphere { 0, 0.9 }",
    "sphere_sweep": "sphere_sweep { cubic_spline 6, <-1.2, -1, 0>, 0.2, <-0.7, -0.6, 0>, 0.3, <0.5, -0.3, 0.3>, 0.2, <-0.3, 0.4, 0>, 0.25, <0.7, 0.6, 0>, 0.15, <1, 1, 0>, 0.1 }",
    "superellipsoid": "superellipsoid { <0.3, 0.3> scale 0.8 }", "text": 'text { ttf "DejaVuSans.ttf" "Ag" 0.4, 0 translate <-0.6, -0.25, -0.2> scale 1.4 }',
    "torus": "torus { 0.65, 0.25 rotate -30 * x }", "triangle": "triangle { <-0.9, -0.7, 0>, <0.9, -0.5, 0>, <0, 0.9, 0> }",
}

PRELUDES = {  # what the calls below use
    "shapes.inc": "#declare F_ = function(x, y, z) { 0.5 + 0.5 * sin(4 * pi * x) * sin(4 * pi * y) };\n"
                  "#declare G_ = function(x, y, z) { 0.5 + 0.5 * sin(7 * x) * sin(7 * y) * sin(7 * z) };\n",
    "meshmaker.inc": "#declare FX = function(u, v) { sin(v) * cos(u) } #declare FY = function(u, v) { 0.7 * cos(v) } #declare FZ = function(u, v) { sin(v) * sin(u) }\n"
                     "#declare F_ = function(u, v) { 0.4 * sin(3 * u) * cos(3 * v) }\n"
                     "#declare Star = spline { natural_spline 0, x 0.2, <0.2, 0, 0.5> 0.4, <-0.9, 0, 0.7> 0.6, <-0.5, 0, -0.3> 0.8, <0.4, 0, -0.9> 1, x }\n"
                     "#declare Vase = spline { natural_spline 0, 0.5 * x 0.3, <0.9, 0.6, 0> 0.6, <0.3, 1.2, 0> 1, <0.5, 1.8, 0> }\n"
                     "#declare Way = spline { natural_spline 0, -x 0.3, <-0.3, 0.4, 0.5> 0.7, <0.4, -0.3, 0.3> 1, <1, 0.2, -0.4> }\n"
                     "#declare Ring = spline { cubic_spline -0.25, -y 0, x 0.25, y 0.5, -x 0.75, -y 1, x 1.25, y }\n"
                     "#declare Wide = spline { linear_spline 0, 0.35 * x 1, 0.1 * x }\n"
                     "#declare S1 = spline { natural_spline 0, 0 0.5, <0.5, 0.4, 0> 1, x } #declare S2 = spline { natural_spline 0, x 0.5, <1, -0.3, 0.5> 1, x + z }\n"
                     "#declare S3 = spline { natural_spline 0, x + z 0.5, <0.5, 0.4, 1> 1, z } #declare S4 = spline { natural_spline 0, z 0.5, <0, 0.4, 0.5> 1, 0 }\n"
                     "#declare Both = array[5] { spline { linear_spline 0, <0, 0, -0.5> 1, <1, 0, -0.5> }, S1, spline { linear_spline 0, <0, 0.5, 0.5> 1, <1, 0.2, 0.5> }, "
                     "spline { natural_spline 0, z 0.5, <0.5, 0.5, 1> 1, x + z }, spline { linear_spline 0, <0, 0, 1.5> 1, <1, 0, 1.5> } }\n",
}
_UP = "<0, 0, 0>, <0, 2, 0>"
CALLS = {  # include → macros that make objects, called
    "shapes.inc": [
        "intersection { object { Wedge(70) } cylinder { -0.4 * y, 0.4 * y, 1 } }", "Spheroid(<0, 0, 0>, <1, 0.6, 0.8>)", "Supertorus(1, 0.3, 0.5, 1.5, 0.001, 2)",
        "Supercone(<0, -1, 0>, 1, 0.6, <0, 1, 0>, 0.3, 0.5)", "Connect_Spheres(<0, 0, 0>, 0.6, <1, 1, 0>, 0.3)",
        "Wire_Box(<-1, -1, -1>, <1, 1, 1>, 0.12, false)", "Round_Box(<-1, -1, -1>, <1, 1, 1>, 0.3, false)",
        "Round_Cylinder(-y, y, 0.8, 0.25, false)", "Round_Cone(-y, 0.9, y, 0.4, 0.15, false)", "Round_Cone2(-y, 0.9, y, 0.4, false)",
        "Round_Cone3(-y, 0.9, y, 0.4, false)", 'HF_Square(F_, 1, 0, <60, 60>, 1, "", <-1, 0, -1>, <1, 0.5, 1>)',
        'HF_Sphere(G_, 0, 0, <90, 60>, 1, "", <0, 0, 0>, 1, 0.3)', 'HF_Cylinder(G_, 0, 0, <90, 60>, 1, "", -y, y, 0.8, 0.2)',
        'HF_Torus(G_, 0, 0, <90, 60>, 1, "", 1, 0.35, 0.2)', 'Bevelled_Text("DejaVuSans.ttf", "B", 8, 30, 0.05, 0.3, 0, false)',
        'Circle_Text("DejaVuSans.ttf", "round", 0.6, 0.05, 0.2, 1, false, Align_Center, 90)'],
    "shapes3.inc": [
        "Segment_of_Object(Egg, 250)", "Segment_of_CylinderRing(1, 0.5, 0.6, 250)", "Segment_of_Torus(1, 0.25, 250)", "Pyramid_N(6, 1, 0.4, 1.6)",
        "Column_N(6, 0.6, 1.8)", "Egg_Shape(1.1, 1.5)", "Facetted_Sphere(8, 14)", "Facetted_Egg_Shape(8, 14, 1.1, 1.5)",
        "Facetted_Egg(8, 14)", "Ring_Sphere(1, 1, 0.04, 0.04, 8, 8)", "Round_Pyramid_N_out(5, <0, 0, 0>, 1, <0, 1.4, 0>, 0.5, 0.12, true, false)",
        "Round_Pyramid_N_in(5, <0, 0, 0>, 1, <0, 1.4, 0>, 0.5, 0.12, true, false)", "Rounded_Tube(1, 0.6, 0.1, 1.2, false)",
        f"Round_Cylinder_Tube({_UP}, 0.8, 0.15, false, false)", "Round_N_Tube_Polygon(5, 0.12, 1, 0.3, false, false)",
        "Round_Conic_Torus(1.2, 0.3, 0.6, 0.12, true)", "Round_Conic_Prism(1.2, 0.3, 0.6, 0.8, 0.08, true)",
        "Half_Hollowed_Rounded_Cylinder1(2.2, 0.6, 0.1, 1, false)", "Half_Hollowed_Rounded_Cylinder2(2.2, 0.6, 0.25, 0.1, 1, false)"],
    "meshmaker.inc": [
        'MSM(Both, 24, "Cubic", 24, "")', 'Parametric(FX, FY, FZ, <0, FromV(0)>, <1.6 * pi, ToV(pi)>, 40, 30, "")', 'Prism(Star, 60, 0.7, 1, "")',
        'Prism1(Star, 60, Vase, 30, "")', 'Lathe(Vase, 30, 360, 40, "")', 'Coons(S1, S2, S3, S4, 20, 20, "")',
        'TwoVarSurf(F_, <-1, 1>, <-1, 1>, 40, 40, "")', 'SweepSpline1(Way, Ring, Wide, 40, 24, "")', 'SweepSpline2(Way, Ring, Wide, 40, 24, "")'],
    "logo.inc": ["Povray_Logo", "Povray_Logo_Prism", "Povray_Logo_Bevel"],
    "makegrass.inc": [
        "mesh { MakeBlade(true, <0, 0, 0>, 20, 12, 10, 1, 0.1, 0.5, <0, 1, 0.3>, <0, -1, 2>, 3, true, false) }",
        'MakeGrassPatch(10, 7, 60, 8, 12, 0.6, 0.1, true, <0, 1, 0.3>, <0, -1, 2>, 3, seed(1), 1, 360, 1, 0.3, true, false, "")'],
}
CALLED_PATTERNS = {  # include → macros that make patterns, called, and the plane they lie in
    "textures.inc": [("Irregular_Bricks_Ptrn(0.1, 1, 0.5, 0.5)", "pattern"), ("Tiles_Ptrn()", "pattern"), ("Hex_Tiles_Ptrn()", "floor"),
                     ("Star_Ptrn(0.8, 5, 2)", "pattern")],
}

STAGE = """#version {version};
global_settings {{ assumed_gamma 1 max_trace_level 6 }}
#include "{include}"
camera {{ orthographic location -20 * z direction z right {columns} * x up {rows} * y }}
light_source {{ <-60, 80, -100> rgb 1 }}
light_source {{ <80, -10, -60> rgb 0.3 shadowless }}
sky_sphere {{ pigment {{ gradient y color_map {{ [0 rgb <0.25, 0.22, 0.2>] [0.5 rgb <0.75, 0.8, 0.85>] [1 rgb <0.4, 0.55, 0.8>] }} scale 2 translate -y }} }}
plane {{ -z, -2 hollow pigment {{ {backdrop} }} finish {{ ambient 1 diffuse 0 }} }}
"""
CHECKERS = "checker rgb 0.75, rgb 0.55 scale 0.25"
BACKDROPS = {"skies.inc": "rgb <0.12, 0.25, 0.6>", "stars.inc": "rgb 0.3"}
# An object turned and fitted into a ball; letters of at most one swatch's width.
HELPERS = """#macro Fitted(O)
  #local A_ = object { O rotate <-20, 25, 0> }
  #local L_ = min_extent(A_); #local H_ = max_extent(A_);
  object { A_ translate -(L_ + H_) / 2 scale 2 / max(H_.x - L_.x, H_.y - L_.y, 0.01) pigment { rgb <0.8, 0.7, 0.5> } finish { specular 0.4 } }
#end
#macro Caption(Line, At)
  #local T_ = text { ttf "DejaVuSans.ttf" Line 0.01, 0 }
  #local W_ = max_extent(T_).x - min_extent(T_).x;
  object { T_ translate -min_extent(T_).x * x - W_ / 2 * x scale min(0.165, 0.97 / W_) translate At - 1.9 * z
    pigment { rgb 0 } finish { ambient 1 diffuse 0 } no_shadow no_reflection }
#end
"""
SKY = """#version 3.7;
global_settings {{ assumed_gamma 1 }}
#include "colors.inc"
#include "{include}"
camera {{ location y look_at <0, 1.4, 1> angle 70 right x up y }}
sky_sphere {{ {name} }}
light_source {{ <-50, 80, -60> rgb 1 }}
plane {{ y, 0 pigment {{ rgb <0.3, 0.35, 0.25> }} }}
"""
