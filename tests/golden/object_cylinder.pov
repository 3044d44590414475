// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at 0 angle 42 }
light_source { <-4, 6, -6> rgb 1 }
cylinder { <-1.6, -1, 0>, <-1.6, 0.7, 0>, 0.7 pigment { rgb <0.9, 0.6, 0.2> } }
cylinder { <0.1, -1, 0.5>, <0.9, 1, -0.4>, 0.45 open pigment { rgb <0.2, 0.6, 0.8> } }
cylinder { -x, x, 0.35 scale <1, 1, 1.8> rotate 70*y translate <1.9, -0.6, -0.4> pigment { rgb <0.6, 0.3, 0.7> } }
plane { y, -1 pigment { rgb 0.75 } }
