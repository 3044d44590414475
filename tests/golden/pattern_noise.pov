// golden: +W160 +H120 -A; psnr >= 50; noise as patterns, one per tile
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4, 3, -10> direction z right 8*x up 6*y }
#declare N = 0;
#macro Tile(P)
  box {
    <0.02, 0.02, 0>, <0.98, 0.98, 1>
    pigment { P scale 0.3 rotate <10, 20, 30> translate <N, -N, 3> }
    finish { ambient 1 diffuse 0 }
    translate <mod(N, 8), div(N, 8), 0>
  }
  #declare N = N + 1;
#end
#macro Plain(P) Tile(pigment { P }) #end
Tile(pigment { bozo })
Tile(pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } noise_generator 1 })
Tile(pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } noise_generator 3 })
Tile(pigment { spotted })
Tile(pigment { bumps turbulence 0.4 })
Tile(pigment { dents })
Tile(pigment { granite })
Tile(pigment { granite noise_generator 1 })
Tile(pigment { granite noise_generator 3 turbulence <0.1, 0.5, 0.2> })
Tile(pigment { wrinkles })
Tile(pigment { wrinkles noise_generator 1 })
Tile(pigment { agate })
Tile(pigment { agate turbulence 0.5 agate_turb 0.4 octaves 3 omega 0.7 lambda 3 })
Tile(pigment { marble })
Tile(pigment { marble turbulence 1 })
Tile(pigment { marble turbulence <0.5, 3, 2> octaves 2 noise_generator 1 sine_wave })
Tile(pigment { wood })
Tile(pigment { wood turbulence 0.3 })
Tile(pigment { wood turbulence <0.2, 0.1, 9> octaves 3 frequency 3 phase 0.2 ramp_wave })
Tile(pigment { cells })
Tile(pigment { crackle })
Tile(pigment { crackle solid })
Tile(pigment { crackle form <0.5, -0.25, 0.4> metric 1 })
Tile(pigment { crackle turbulence 0.2 metric 3.5 offset 0.25 form <1, 0, 0> })
Tile(pigment { ripples })
Tile(pigment { ripples frequency 3 phase 0.3 turbulence 0.2 })
Tile(pigment { waves })
Tile(pigment { waves frequency 2 phase 0.1 scallop_wave })
Tile(pigment { spiral1 3 })
Tile(pigment { spiral1 2 turbulence 0.3 })
Tile(pigment { spiral2 5 })
Tile(pigment { spiral2 4 turbulence 0.1 ramp_wave })
Tile(pigment { quilted })
Tile(pigment { quilted control0 0.2 control1 0.7 turbulence 0.3 })
Tile(pigment { leopard turbulence 0.5 })
Tile(pigment { onion turbulence 0.3 omega 0.8 })
Tile(pigment { radial frequency 5 turbulence 0.2 lambda 4 })
Tile(pigment { gradient x frequency 4 turbulence 0.3 triangle_wave })
Tile(pigment { checker rgb 1 rgb x turbulence 0.3 })
Tile(pigment { hexagon turbulence 0.2 })
Tile(pigment { cylindrical turbulence 0.4 })
Tile(pigment { spherical frequency 3 turbulence 0.4 })
Tile(pigment { planar phase 0.3 turbulence 0.2 })
Tile(pigment { boxed turbulence 0.3 })
Tile(pigment { bozo scale 0.3 color_map { [0 rgb 0] [0.5 rgbt <1, 0, 0, 0.4>] [1 rgb y] } })
Tile(pigment { wrinkles poly_wave 3 color_map { [0 rgb z] [1 rgb 1] } })
Tile(pigment { granite cubic_wave pigment_map { [0.3 agate scale 0.3] [0.7 rgb 1] } })
Tile(pigment { marble pigment_map { [0.3 bozo turbulence 1] [0.6 cells scale 0.2] } turbulence 0.4 })
