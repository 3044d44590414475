// golden: +W64 +H48 -A; psnr >= 60; exact: a body that is not hollow keeps media out
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 50 }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { y, -1 pigment { rgb 0.7 } hollow }
plane { z, 5 inverse pigment { rgb 0.7 } hollow finish { ambient 0.1 } }
light_source { <4, 5, -4>, 1.2 }
sphere { 0, 1.2 texture { Clear } hollow interior { media { emission 0.4 absorption 0.3 density { boxed rotate 30*z } } } }
box { <0.2, -0.6, -2>, <0.9, 0.6, 2> texture { Clear } }
box { <-0.9, -0.6, -2>, <-0.2, 0.6, 2> texture { Clear } hollow }
media { absorption 0.05 }
