// golden: +W160 +H120 -A; psnr >= 50; every pattern without a bump of its own as a normal, and waves of normals
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4, 3, -10> direction z right 8*x up 6*y }
light_source { <-20, 30, -30> rgb 0.8 }
light_source { <30, -5, -20> rgb <0.2, 0.1, 0.3> shadowless }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.4 roughness 0.02 } }
#declare N = 0;
#macro Ball(B)
  sphere {
    0, 0.48
    pigment { rgb <0.8, 0.7, 0.5> }
    normal { B }
    translate <mod(N, 8) + 0.5, div(N, 8) + 0.5, 0>
  }
  #declare N = N + 1;
#end
Ball(normal { boxed 0.5 frequency 4 })
Ball(normal { cylindrical 0.5 frequency 4 rotate 90*x })
Ball(normal { spherical 0.5 frequency 5 sine_wave })
Ball(normal { planar 0.6 frequency 6 })
Ball(normal { cells 0.4 scale 0.2 })
Ball(normal { square 0.3 scale 0.2 rotate 90*x })
Ball(normal { triangular 0.3 scale 0.3 rotate 90*x })
Ball(normal { cubic 0.5 rotate <20, 30, 0> })
Ball(normal { spiral2 4, 0.4 scale 0.4 })
Ball(normal { mandel 12 bump_size 0.6 scale 0.25 translate 0.1*x })
Ball(normal { julia <-0.4, 0.5>, 10 bump_size 0.6 scale 0.3 })
Ball(normal { magnet 1 mandel 12 bump_size 0.4 scale 0.2 })
Ball(normal { tiling 7 bump_size 0.5 scale 0.15 rotate 90*x })
Ball(normal { tiling 27 bump_size 0.5 scale 0.15 rotate 90*x })
Ball(normal { pavement number_of_sides 4 number_of_tiles 5 pattern 3 bump_size 0.5 scale 0.12 rotate 90*x })
Ball(normal { pavement number_of_sides 6 number_of_tiles 2 interior 1 bump_size -0.5 scale 0.12 rotate 90*x })
Ball(normal { slope y, 0.2 })
Ball(normal { aoi 0.3 frequency 6 })
Ball(normal { pigment_pattern { gradient x color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.2>] } } 0.6 scale 0.2 })
Ball(normal { uv_mapping gradient x 0.4 scale 0.1 })
Ball(normal { uv_mapping checker 0.3 scale <0.1, 0.2, 1> })
Ball(normal { gradient x, 0.4 scallop_wave scale 0.2 })
Ball(normal { gradient x, 0.4 cubic_wave scale 0.2 })
Ball(normal { gradient x, 0.4 poly_wave 2 scale 0.2 })
Ball(normal { gradient x, 0.4 triangle_wave phase 0.3 frequency 2 scale 0.3 })
Ball(normal { planar 0.5 slope_map { [0 <0, 1>] [1 <1, 0>] } frequency 3 triangle_wave })
Ball(normal { wood 0.4 slope_map { [0 <0, 0.5>] [0.5 <0.5, 0.5>] [1 <1, 0>] } scale 0.15 turbulence 0.1 })
Ball(normal { gradient x, 0.4 accuracy 0.2 scale 0.2 })
Ball(normal { gradient x, 0.4 accuracy 0.0001 scale 0.2 })
Ball(normal { bumps 0.6 scale 0.12 warp { repeat 0.3*x flip x } warp { turbulence 0.4 } })
Ball(normal { bozo 0.5 scale 0.15 warp { black_hole <0, 0, -0.4>, 0.4 strength 2 } })
Ball(normal { leopard 0.4 warp { spherical orientation y } scale 0.03 })
Ball(normal { wrinkles 0.7 scale 0.4 no_bump_scale })
Ball(normal { dents 2 scale <0.1, 0.3, 0.1> no_bump_scale rotate 40 })
Ball(normal { waves 0.1 frequency 10 scale 0.3 no_bump_scale })
Ball(normal { gradient y normal_map { [0.3 bumps 0.5 scale 0.1] [0.6 gradient x, 0.3 scale 0.1] } no_bump_scale })
Ball(normal { bozo scale 0.2 normal_map { [0.5 uv_mapping gradient x scale 0.1] [0.6 bumps scale 0.1] } })
Ball(normal { tiling 3 normal_map { [0.4 bumps 0.5 scale 0.1] [0.6 quilted 0.5 scale 0.1] } scale 0.3 rotate 90*x })
Ball(normal { cells normal_map { [0.3 facets coords 0.5 scale 0.1] [0.7 dents scale 0.1] } scale 0.3 })
Ball(normal { average normal_map { [1 bumps 0.5 scale 0.1] [0.5 average normal_map { [1 dents scale 0.1] [1 gradient x, 0.3 scale 0.1] }] } })
Ball(normal { hexagon normal { bumps scale 0.1 } normal { crackle 0.4 scale 0.1 } normal { bozo scale 0.05 } scale 0.2 rotate 90*x })
Ball(normal { cubic normal { bumps scale 0.1 } normal { dents scale 0.1 } normal { ripples 0.4 scale 0.05 } normal { bozo scale 0.1 } normal { agate 0.2 scale 0.2 } normal { quilted scale 0.1 } rotate 20 })
