// golden: +W64 +H48 -A; psnr >= 60; exact: media together scatter by the mean of their phase functions
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 50 }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { y, -1 pigment { rgb 0.7 } hollow }
plane { z, 5 inverse pigment { rgb 0.7 } hollow finish { ambient 0.1 } }
light_source { <4, 5, 4>, 1.2 }
sphere {
  0, 1.5 texture { Clear } hollow
  interior { media { scattering { 3, <0.2, 0.1, 0> } } media { scattering { 1, <0, 0.1, 0.2> } } media { absorption 0.1 } }
}
