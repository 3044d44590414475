// golden: +W96 +H72 -A; psnr >= 45; a pattern edge may fall on the other side of a pixel
#version 3.7;
global_settings { assumed_gamma 1 }
// The same gradient through every wave form, with frequency and phase.
camera { orthographic location <0.013, 0.007, -5> look_at <0.013, 0.007, 0> right 4*x up 3*y }
light_source { -9*z rgb 0 }
#default { finish { ambient 1 diffuse 0 } }
#declare N = 0;
#macro Next()
  translate <mod(N, 4) - 1.5, 1 - div(N, 4), 0>
  #declare N = N + 1;
#end
#macro G() gradient <1, 1, 0> scale 0.5 #end
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { G() ramp_wave } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { G() triangle_wave } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { G() sine_wave } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { G() scallop_wave } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { G() cubic_wave } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { G() poly_wave 3 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { G() poly_wave 0.4 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { G() frequency 3 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { G() frequency 1.5 phase 0.3 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { G() frequency -2 triangle_wave } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { checker rgb 0.2 rgb 0.9 scale 0.2 } Next() }
box { -<0.47, 0.47, 0>, <0.47, 0.47, 1> pigment { spherical frequency 4 sine_wave scale 0.6 } Next() }
