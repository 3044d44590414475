// golden: +W64 +H48 -A; psnr >= 50; random: both methods that know jitter
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 50 }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { y, -1 pigment { rgb 0.7 } hollow }
plane { z, 5 inverse pigment { rgb 0.7 } hollow finish { ambient 0.1 } }
light_source { <4, 5, -4>, 1.2 }
sphere {
  -1.4*x, 1.2 texture { Clear } hollow
  interior { media { method 3 jitter 0.5 samples 20 emission 0.6 density { spherical turbulence 0.3 translate -1.4*x } } }
}
sphere {
  1.4*x, 1.2 texture { Clear } hollow
  interior { media { method 2 jitter 1 intervals 4 samples 10 emission 0.6 density { spherical turbulence 0.3 translate 1.4*x } } }
}
