// golden: +W64 +H48 -A; psnr >= 60; exact: the defaults of version 3.1
#version 3.1;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 50 }
light_source { <4, 5, -4>, 1.2 }
plane { y, -1 pigment { rgb 0.7 } hollow }
sphere {
  0, 1.2 pigment { rgbt 1 } hollow
  interior { media { emission 0.4 absorption 0.3 samples 3 method 2 density { spherical } } }
}
