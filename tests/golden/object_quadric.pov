// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// Ellipsoid, hyperboloid, elliptic cylinder and cone, cut by what clips them.
camera { location <0, 2.5, -7> look_at 0 angle 52 }
light_source { <-4, 6, -6> rgb 1 }
quadric { <1, 2, 1>, <0, 0, 0>, <0, 0, 0>, -0.7 pigment { rgb <0.9, 0.5, 0.3> } translate -2.2*x }
quadric { <1, -0.6, 1>, <0.2, 0, 0>, <0, 0, 0>, -0.1 clipped_by { box { -1, 1 } } pigment { rgb <0.4, 0.8, 0.4> } translate -0.6*x }
quadric { <1, 0, 2>, <0, 0, 0>, <0, 0, 0>, -0.3 clipped_by { box { -0.8, 0.8 rotate 10*z } } pigment { rgb <0.3, 0.5, 0.9> } translate 1*x }
quadric { <1, -1, 1>, <0, 0, 0>, <0, 0, 0>, 0 clipped_by { box { -0.9, 0.9 } } pigment { rgb <0.8, 0.7, 0.3> } translate 2.6*x }
plane { y, -1 pigment { rgb 0.7 } }
