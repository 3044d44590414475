// golden: +W160 +H120 -A; psnr >= 45; escape-time fractals, slope, aoi and pigment_pattern
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4, 3, -10> direction z right 8*x up 6*y }
#declare N = 0;
#macro Tile(P)
  sphere {
    0, 1
    pigment { P }
    finish { ambient 1 diffuse 0 }
    translate <2*mod(N, 4) + 1, 2*div(N, 4) + 1, 0>
  }
  #declare N = N + 1;
#end
#declare C = color_map { [0 rgb 0] [0.1 rgb z] [0.3 rgb x] [0.6 rgb y] [1 rgb 1] }
Tile(pigment { mandel 40 translate 0.5*x scale 0.6 })
Tile(pigment { mandel 30 exponent 4 color_map { C } interior 1, 1 scale 0.7 })
Tile(pigment { julia <-0.4, 0.6>, 40 exterior 6, 0.1 color_map { C } scale 0.6 })
Tile(pigment { magnet 1 mandel 30 color_map { C } interior 1, 1 scale 0.3 translate -0.3*x })
Tile(pigment { magnet 2 julia <0.3, 0.7>, 30 color_map { C } exterior 7, 3 scale 0.3 })
Tile(pigment { slope y color_map { C } })
Tile(pigment { slope { <1, 1, 0>, 0.2, 0.9 altitude y, -1, 1 } color_map { C } })
Tile(pigment { slope { point_at <0, 5, -8>, 0.5, 1 } color_map { C } })
Tile(pigment { aoi color_map { C } frequency 2 })
Tile(pigment { pigment_pattern { bozo scale 0.2 } color_map { C } })
Tile(pigment { pigment_pattern { gradient x color_map { C } scale 0.7 } pigment_map { [0.3 checker rgb 1 rgb x scale 0.2] [0.7 agate scale 0.3] } turbulence 0.2 })
Tile(pigment { average pigment_map { [1 rgb x] [0.5 bozo scale 0.2] [2 slope z color_map { C }] } })
