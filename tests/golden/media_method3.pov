// golden: +W64 +H48 -A; psnr >= 60; exact: without jitter all samples are known; threshold and level
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 50 }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { y, -1 pigment { rgb 0.7 } hollow }
plane { z, 5 inverse pigment { rgb 0.7 } hollow finish { ambient 0.1 } }
light_source { <4, 5, -4>, 1.2 }
#macro Cloud(P, M)
  sphere { 0, 1 texture { Clear } hollow interior { media { M density { spherical turbulence 0.6 } } } translate P }
#end
Cloud(<-1.6, 0.6, 0>, media { emission 2 samples 4 aa_threshold 0.01 aa_level 5 })
Cloud(<1.6, 0.6, 0>, media { emission 2 samples 4 aa_threshold 0.5 aa_level 1 })
Cloud(<0, -0.6, 1>, media { scattering { 1, 1 } intervals 3 samples 6 aa_threshold 0.05 aa_level 2 })
