// golden: +W96 +H72 -A; psnr >= 50; layers, tiles and maps of maps
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <3, 2, -10> direction z right 6*x up 4*y }
light_source { <-20, 30, -30> rgb 0.8 }
light_source { <30, -5, -20> rgb <0.2, 0.1, 0.3> shadowless }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.4 roughness 0.02 } }
#declare N = 0;
#macro Ball(T)
  sphere { 0, 0.48 texture { T } translate <mod(N, 6) + 0.5, div(N, 6) + 0.5, 0> }
  #declare N = N + 1;
#end
Ball(texture { tiles { texture { pigment { rgb x } } tile2 texture { pigment { rgb z } normal { bumps 1 scale .1 } } } scale .3 })
#declare Layers = texture { pigment { wood turbulence .1 scale .2 } } texture { pigment { agate color_map { [0 rgbt <1, .8, .5, .3>] [1 rgbt <.5, .2, .1, .8>] } scale .5 } }
Ball(texture { Layers })
Ball(texture { average texture_map { [1 pigment { rgb x }] [2 pigment { granite } finish { phong 1 }] } })
Ball(texture { marble turbulence .5 texture_map { [.3 pigment { crackle scale .1 }] [.6 pigment { rgb .8 } normal { wrinkles 1 scale .2 }] } scale .4 })
Ball(texture { cells texture_map { [.2 pigment { rgb x }] [.8 pigment { rgb <1, 1, 0> } finish { reflection .3 }] } scale .3 })
Ball(texture { crackle solid texture_map { [.5 pigment { leopard scale .03 }] [.5 pigment { onion scale .11 }] } scale .3 })
Ball(texture { pigment { slope y color_map { [.3 rgb x] [.7 rgb y] } } normal { bumps 1 scale .2 } })
Ball(texture { pigment { aoi color_map { [.5 rgb x] [1 rgb z] } } normal { dents 1 scale .2 } })
Ball(texture { pigment { slope { point_at <0, 2, -3> .2, .9 } color_map { [0 rgb 0] [1 rgb 1] } } })
Ball(texture { pigment { slope { y altitude y, -.5, .5 } color_map { [0 rgb x] [1 rgb <0, 1, 1>] } } })
