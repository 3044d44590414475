// golden: +W64 +H48 -A; psnr >= 60; exact: several media everywhere, in and around a hollow ball
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 50 }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { y, -1 pigment { rgb 0.7 } hollow }
plane { z, 5 inverse pigment { rgb 0.7 } hollow finish { ambient 0.1 } }
light_source { <4, 5, -4>, 1.2 }
media { emission 0.04 absorption 0.02 density { spherical scale 3 } }
media { absorption <0.1, 0.06, 0.03> intervals 4 method 2 samples 4 }
sphere { -x, 0.9 pigment { rgbt 0.9 } finish { reflection 0.1 } interior { ior 1.4 } hollow }
sphere { 1.2*x, 0.8 pigment { rgbt 0.9 } interior { ior 1.2 } }
