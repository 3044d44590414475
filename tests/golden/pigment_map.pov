// golden: +W96 +H72 -A; psnr >= 45; a pattern edge may fall on the other side of a pixel
#version 3.7;
global_settings { assumed_gamma 1 }
// Maps of pigments, nested, and lists of pigments in block patterns.
camera { orthographic location <0.013, 0.007, -5> look_at <0.013, 0.007, 0> right 4*x up 3*y }
light_source { -9*z rgb 0 }
#default { finish { ambient 1 diffuse 0 } }
#declare N = 0;
#macro Next()
  translate <mod(N, 4) - 1.5, 1 - div(N, 4), 0>
  #declare N = N + 1;
#end
#declare A = pigment { checker rgb <0.9, 0.3, 0.2> rgb <1, 0.9, 0.6> scale 0.11 }
#declare B = pigment { gradient y color_map { [0 rgb <0.1, 0.3, 0.6>] [1 rgb <0.6, 0.9, 0.9>] } scale 0.2 }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { gradient x pigment_map { [0.2 A] [0.8 B] } scale 0.94 translate -0.47 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { checker pigment { A }, pigment { B } scale 0.3 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { spherical pigment_map { [0 rgb 0.2] [0.5 A scale 0.5] [0.5 B] [1 A rotate 45*z] } scale 0.6 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { brick pigment { rgb 0.8 } pigment { A } brick_size <0.4, 0.2, 1> mortar 0.03 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { hexagon pigment { A } pigment { B } pigment { rgb 0.3 } rotate 90*x scale 0.15 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { gradient x pigment_map { [0 gradient y pigment_map { [0 A] [1 B] } scale 0.5] [1 rgb 1] } scale 0.94 translate 0.47 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { radial pigment_map { [0 A] [0.5 B] [1 A] } rotate 90*x } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { boxed pigment_map { [0.3 A] [0.3 B] } scale 0.5 } Next() }
