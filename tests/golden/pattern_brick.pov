// golden: +W96 +H72 -A; psnr >= 45; a pattern edge may fall on the other side of a pixel
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 2.5, -6> look_at <0, 0.3, 0> angle 46 }
light_source { <-4, 6, -6> rgb 1 }
box { <-2.2, -0.5, 0>, <0.4, 1.7, 0.5> pigment { brick rgb 0.8, rgb <0.7, 0.3, 0.2> brick_size <0.8, 0.3, 0.45> mortar 0.06 } }
box { -0.6, 0.6 rotate 30*y translate <1.4, 0.11, -0.6> pigment { brick scale 0.1 } }
plane { y, -0.5 pigment { brick rgb <0.3, 0.3, 0.4> rgb <0.7, 0.7, 0.6> brick_size <1, 1, 0.5> mortar 0.1 } }
