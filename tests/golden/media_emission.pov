// golden: +W64 +H48 -A; psnr >= 60; exact: emission is seen through the depth before it
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { z, 3 inverse pigment { checker rgb 1, rgb 0.3 translate 0.5*x } finish { ambient 1 diffuse 0 } hollow }
sphere { -x, 0.9 texture { Clear } hollow interior { media { emission <0.3, 0.1, 0.2> } } }
sphere { x, 0.9 texture { Clear } hollow interior { media { emission <0.5, 0.1, 0.2> absorption 1 intervals 3 samples 4 } } }
