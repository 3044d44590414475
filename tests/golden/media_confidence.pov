// golden: +W64 +H48 -A; psnr >= 50; random samples, as many as variance and confidence ask for
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 50 }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { y, -1 pigment { rgb 0.7 } hollow }
plane { z, 5 inverse pigment { rgb 0.7 } hollow finish { ambient 0.1 } }
light_source { <4, 5, -4>, 1.2 }
sphere {
  0, 1.4 texture { Clear } hollow
  interior {
    media {
      method 2 intervals 4 samples 8, 80 confidence 0.99 variance 0.00001
      emission 0.4 absorption 0.4 density { spherical turbulence 0.3 }
    }
  }
}
