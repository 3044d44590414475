// golden: +W64 +H48 -A; psnr >= 60; exact: shadows of balls in the fog of a spotlight
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 50 }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { y, -1 pigment { rgb 0.7 } hollow }
plane { z, 5 inverse pigment { rgb 0.7 } hollow finish { ambient 0.1 } }
light_source { <3, 4, -2>, 2 spotlight point_at <0, -1, 0> radius 14 falloff 20 }
sphere { <1, 1, -0.7>, 0.25 pigment { rgb <1, 0.5, 0.3> } }
box { <1.3, 1, -1.5>, <1.6, 1.3, -1.2> pigment { rgbf <1, 0.3, 0.3, 0.9> } }
media { scattering { 1, 0.08 extinction 0.5 } intervals 4 samples 30 }
