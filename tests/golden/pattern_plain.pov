// golden: +W96 +H72 -A; psnr >= 45; a pattern edge may fall on the other side of a pixel
#version 3.7;
global_settings { assumed_gamma 1 }
// Patterns that need no noise, scaled and moved so that their repeats and centres show.
camera { orthographic location <0.013, 0.007, -5> look_at <0.013, 0.007, 0> right 4*x up 3*y }
light_source { -9*z rgb 0 }
#default { finish { ambient 1 diffuse 0 } }
#declare N = 0;
#macro Next()
  translate <mod(N, 4) - 1.5, 1 - div(N, 4), 0>
  #declare N = N + 1;
#end
#declare Map = color_map { [0 rgb <0.1, 0.1, 0.4>] [0.4 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.8>] }
#macro Placed() color_map { Map } scale 0.4 rotate <20, 30, 10> translate <0.1, 0.05, 0.1> #end
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { leopard color_map { Map } scale 0.06 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { onion Placed() scale 0.3 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { radial color_map { Map } rotate <90, 0, 30> translate 0.1*x } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { planar Placed() } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { boxed Placed() } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { cylindrical Placed() } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { spherical Placed() } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { square rgb x, rgb y, rgb z, rgb 1 rotate 90*x scale 0.21 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { triangular rgb x, rgb y, rgb z, rgb x+y, rgb y+z, rgb x+z rotate 80*x scale 0.21 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { cubic rgb x, rgb y, rgb z, rgb x+y, rgb y+z, rgb x+z rotate <30, 40, 0> translate 0.1 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { radial frequency 5 rotate 90*x } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { spherical scale 0.7 } Next() }
