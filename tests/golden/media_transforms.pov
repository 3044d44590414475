// golden: +W64 +H48 -A; psnr >= 60; exact: transformations move densities and leave coefficients alone
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { z, 3 inverse pigment { checker rgb 1, rgb 0.3 translate 0.5*x } finish { ambient 1 diffuse 0 } hollow }
#declare Core = media { absorption 2 density { spherical scale 0.8 } }
#declare Body = sphere { 0, 1 texture { Clear } hollow interior { media { Core } } }
object { Body scale 0.5 translate <-1.3, 0.7, 0> }
object { Body scale <1, 0.5, 1> rotate 40*z translate <0.2, 0.6, 0> }
sphere { 0, 0.6 texture { Clear } hollow scale <1, 0.7, 1> interior { media { Core translate 0.2*x scale 0.5 } } translate <1.4, 0.7, 0> }
sphere { 0, 0.7 hollow material { texture { Clear } interior { media { Core } } scale 0.6 } translate <-1, -0.7, 0> }
union {
  sphere { -0.5*x, 0.4 } sphere { 0.5*x, 0.4 }
  texture { Clear } hollow interior { media { absorption 3 scale 0.1 density { boxed } rotate 30*z } } translate <0.9, -0.7, 0>
}
