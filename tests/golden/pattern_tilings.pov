// golden: +W96 +H72 -A; psnr >= 50; all tilings; the last ones never repeat
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4.5, 3.375, -10> direction z right 9*x up 6.75*y }
background { rgb <.1, .2, .3> }
#declare N = 0;
#default { finish { ambient 1 diffuse 0 } }
#macro Tile(T)
  box {
    <0.02, 0.02, 0>, <0.98, 0.98, 1>
    texture { T }
    translate <mod(N, 9), div(N, 9), 0>
  }
  #declare N = N + 1;
#end
#declare S = .12;
#for (I, 1, 27) Tile(texture { pigment { tiling I color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } rotate -90*x scale S translate <.0371, .0113, 0> } }) #end
Tile(texture { pigment { tiling 7 scallop_wave frequency 2 turbulence .2 scale .2 } })
Tile(texture { pigment { tiling 21 color_map { [0 rgb x] [1/6 rgb x] [1/6 rgb y] [2/6 rgb y] [2/6 rgb z] [.5 rgb z] [.5 rgb 1] [4/6 rgb 1] [4/6 rgb .5] [5/6 rgb .5] [5/6 rgb <1, 1, 0>] [1 rgb <1, 1, 0>] } rotate 90*x scale .1 } })
