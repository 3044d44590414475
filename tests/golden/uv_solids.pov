// golden: +W120 +H90 -A; psnr >= 45; balls, boxes and rings have coordinates that turn with them
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -9> look_at <0, 0, 0> angle 46 }
light_source { <-8, 10, -12> rgb 1 }
background { rgb <.3, .4, .5> }
#declare Map = pigment { image_map { png "images/colour.png" interpolate 2 } scale <.25, .5, 1> }
#declare Lattice = texture { pigment { checker rgb 1 rgb <.8, .3, .2> scale 1/16 } }
// Turned, stretched, sheared, mirrored; marked as a whole or in the pigment.
sphere { 0, .8 uv_mapping texture { Lattice } rotate <20, 30, 40> translate <-2.7, 1.9, 0> }
sphere { <.2, 0, 0>, -.7 uv_mapping pigment { Map } scale <-1, 1.2, .8> rotate 30*z translate <-.9, 1.9, 0> }
sphere { 0, .7 pigment { uv_mapping checker rgb 1 rgb <.2, .3, .8> scale 1/12 }
  matrix <1, .4, 0, 0, 1, .3, 0, 0, 1, .9, 1.9, 0> }
box { -.6, .6 uv_mapping pigment { Map } rotate <25, 35, 0> translate <2.7, 1.9, 0> }
box { <.5, -.6, -.5>, <-.5, .6, .5> pigment { uv_mapping gradient x color_map { [0 rgb x] [.5 rgb y] [1 rgb z] } scale .5 }
  rotate <-25, -35, 10> translate <-2.7, 0, 0> }
torus { .6, .25 uv_mapping texture { Lattice scale <.5, 2, 1> } rotate <-40, 20, 10> translate <-.9, 0, 0> }
torus { .6, .3 uv_mapping pigment { Map } scale <1, .8, -1> rotate <-70, 0, 30> translate <.9, 0, 0> }
// Bumps and whole textures; a solid that hands its texture down; a part that has its own.
sphere { 0, .7 pigment { rgb <.8, .8, .4> } normal { uv_mapping bumps 1 scale .05 } rotate 50*y translate <2.7, 0, 0> }
difference {
  box { -.6, .6 }
  sphere { <.3, .3, -.6>, .6 }
  torus { .5, .2 texture { pigment { rgb <.3, .8, .4> } } }
  uv_mapping texture { Lattice } rotate <20, 30, 0> translate <-2.7, -1.9, 0>
}
intersection {
  sphere { 0, .8 texture { uv_mapping Lattice } rotate 40*x }
  box { -.55, .55 texture { uv_mapping pigment { Map } finish { phong .5 } } rotate 20*y }
  rotate 10*z translate <-.9, -1.9, 0>
}
#declare Ball = sphere { 0, .4 uv_mapping pigment { checker rgb 1 rgb <.5, .2, .6> scale 1/8 } };
union {
  object { Ball rotate 60*x translate .45*x }
  object { Ball scale <1, .7, 1> rotate 60*z translate -.45*x }
  box { -.3, .3 uv_mapping pigment { Map } rotate 45*y translate .5*y }
  translate <.9, -1.9, 0>
}
merge { object { Ball } box { 0, .5 } rotate <0, 200, 20> uv_mapping pigment { Map } translate <2.7, -1.9, 0> }
