// golden: +W64 +H48 -A; psnr >= 60; exact: bodies of media in each other, touching and overlapping
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { z, 3 inverse pigment { checker rgb 1, rgb 0.3 translate 0.5*x } finish { ambient 1 diffuse 0 } hollow }
sphere { 0, 1.3 texture { Clear } hollow interior { media { absorption <0.4, 0.1, 0> } } }
sphere { 0, 0.7 texture { Clear } hollow interior { media { absorption <0, 0.1, 1> emission <0.4, 0, 0> } } }
sphere { <1.1, 0.2, 0>, 0.7 texture { Clear } hollow interior { media { absorption 0.4 density { gradient y scale 0.5 } } ior 1.1 } }
sphere { <-0.9, 0, -0.5>, 0.5 pigment { rgb <1, 0.5, 0> } finish { ambient 1 } }
