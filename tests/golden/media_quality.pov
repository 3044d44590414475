// golden: +W64 +H48 -A +Q8; psnr >= 60; exact: below quality 9 there are no media
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 50 }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { y, -1 pigment { rgb 0.7 } hollow }
plane { z, 5 inverse pigment { rgb 0.7 } hollow finish { ambient 0.1 } }
light_source { <2, 5, -3>, 1.2 }
media { absorption 0.1 }
sphere { 0, 1 texture { Clear } hollow interior { media { absorption 2 } } }
