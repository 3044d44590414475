// golden: +W64 +H48 -A; psnr >= 60; exact: lamps that the atmosphere dims, or does not reach
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 50 }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { y, -1 pigment { rgb 0.7 } hollow }
plane { z, 5 inverse pigment { rgb 0.7 } hollow finish { ambient 0.1 } }
light_source { <3, 4, -2>, 1 }
light_source { <-3, 4, -2>, <1, 0.2, 0.2> media_attenuation on }
light_source { <-5, 4, -2>, <0, 0.2, 1> parallel point_at 0 media_attenuation }
light_source { <0, 4, -6>, 0.4 media_attenuation media_interaction off }
light_source { <0, 4, 2>, 0.2 shadowless }
sphere { <1.6, 1, 0>, 0.4 pigment { rgb 1 } }
sphere { -x, 0.8 pigment { rgbf <1, 0.7, 0.7, 0.8> } interior { media { absorption 0.6 density { spherical scale 0.8 translate -x } } } hollow }
sphere { <1, -0.1, 0>, 0.8 pigment { rgbf <1, 0.8, 0.8, 0.8> } interior { media { absorption 1 scattering { 1, 1 extinction 0.5 } } } hollow }
media { emission 0.01 absorption 0.06 scattering { 1, 0.01 } density { gradient y scale 8 translate -2*y } }
