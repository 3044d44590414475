// golden: +W160 +H120 -A; psnr >= 50; `cutaway_textures`: cut surfaces look like what they cut
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right 8*x up 6*y }
light_source { <-8, 10, -12> rgb 1 }
#default { pigment { rgb <1, 1, 0> } finish { ambient .4 diffuse .6 } }
plane { z, 3 pigment { checker rgb .3 rgb .6 scale .4 } }
#macro At(X, Y) rotate <20, 30, 0> translate <X, Y, 0> #end
#declare R = pigment { rgb x }
#declare G = pigment { rgb y }
#declare B = pigment { rgb z }
#declare Halves = union { box { <-1, -1, -1>, <.3, 1, 1> pigment { R } } box { <-.3, -1.01, -1.01>, <1, 1.01, 1.01> pigment { B } } }
#declare Hole = sphere { <0, 0, -1>, .8 }
// The base lends its textures, all that it has there, and placed where they are.
difference { object { Halves } object { Hole } cutaway_textures scale .6 At(-3.1, 2) }
difference { box { -1, 1 pigment { checker rgb x rgb 1 scale .25 } rotate 30*z } object { Hole } cutaway_textures scale .6 At(-1.1, 2) }
difference { box { -1, 1 uv_mapping pigment { checker rgb x rgb 1 scale .1 } } object { Hole } cutaway_textures scale .6 At(.9, 2) }
difference { object { Halves } box { 0, <2, 2, -2> pigment { G } } object { Hole } cutaway_textures scale .6 At(2.9, 2) }
// Layers, and matter that one sees through.
difference {
  sphere { 0, 1.2 texture { pigment { rgb <.4, .6, 1> } }
    texture { pigment { gradient y color_map { [.5 rgbt 1] [.5 rgb <1, .5, 0>] } scale .3 } finish { phong 1 } } }
  box { <0, 0, -2>, 2 } cutaway_textures scale .6 At(-3.1, 0)
}
difference { box { -1, 1 pigment { rgbt <1, .6, .6, .6> } interior { ior 1.2 } } object { Hole } cutaway_textures scale .6 At(-1.1, 0) }
// Intersections: everybody who holds the point, in equal parts; unions in them and clips too.
intersection { box { -1, 1 pigment { R } } sphere { 0, 1.4 pigment { B } } cylinder { -2*z, 2*z, 1.1 } cutaway_textures scale .6 At(.9, 0) }
intersection {
  box { -1, 1 pigment { B } }
  union { box { -1.1, 0 pigment { R } } box { -1.1, 1.1 pigment { G } clipped_by { plane { -y, .5 } } } }
  sphere { 0, 1.3 } cutaway_textures scale .6 At(2.9, 0)
}
// Who is bare: not what has its own texture or that of the solid, nor the children of a union.
difference { box { -1, 1 pigment { R } } object { Hole } cutaway_textures pigment { B } scale .6 At(-3.1, -2) }
difference { union { box { <-1, -1, -1>, <0, 1, 1> pigment { R } } box { <0, -1, -1>, <1, 1, 1> } } object { Hole } cutaway_textures scale .6 At(-1.1, -2) }
difference { box { -1, 1 pigment { B } } union { sphere { <-.5, 0, -1>, .7 } sphere { <.5, 0, -1>, .7 pigment { G } } } cutaway_textures scale .6 At(.9, -2) }
difference { box { -1, 1 } sphere { <-.3, 0, -1>, .8 pigment { R } } sphere { <.5, 0, -1>, .6 } cutaway_textures scale .6 At(2.9, -2) }
