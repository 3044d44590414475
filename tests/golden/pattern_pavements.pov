// golden: +W96 +H72 -A; psnr >= 50; stones of three, four and six sides
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
#macro Stones(K, T, P, E, I, F)
  Tile(texture { pigment { pavement number_of_sides K number_of_tiles T pattern P exterior E interior I form F color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } rotate -90*x scale S } })
#end
#for (T, 1, 6) Stones(3, T, 1, mod(T, 3), mod(T + 1, 3), mod(T, 2)) #end
#for (P, 1, 12) Stones(3, 6, P, 0, mod(P, 3), mod(P, 3)) #end
#for (T, 1, 6) Stones(4, T, 1, mod(T, 3), mod(T + 1, 3), mod(T, 4)) #end
#for (P, 1, 33, 4) Stones(4, 6, P, 1, mod(P, 3), mod(P, 4)) #end
#for (T, 1, 5) Stones(6, T, 1, 0, mod(T + 1, 3), mod(T, 3)) #end
#for (P, 2, 22, 3) Stones(6, 5, P, 0, 1, mod(P, 3)) #end
Tile(texture { pigment { pavement color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } rotate -90*x scale S } })
Tile(texture { pavement number_of_sides 4 number_of_tiles 3 pattern 2 texture_map { [.6 pigment { rgb <.8, .3, .2> }] [.9 pigment { rgb .9 }] } rotate 90*x scale .2 })
Tile(texture { pigment { pavement number_of_tiles 4 pattern 2 pigment_map { [.5 granite scale .2] [.8 rgb 0] } rotate 90*x scale .2 } })
