// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// Both sides of a disc are lit alike; the hole is open; the normal need not be a unit vector.
camera { location <0, 2, -5> look_at 0 angle 44 }
light_source { <-3, 5, -5> rgb 1 }
disc { <-1, 0.2, 0>, <1, 2, -2>, 1, 0.4 pigment { rgb <0.9, 0.6, 0.2> } }
disc { <1.2, 0, 0.5>, <-1, 0.5, -1>, 0.9 pigment { rgb <0.3, 0.6, 0.8> } }
disc { <0.3, -0.6, -1>, <0, -3, 1>, 0.5, 0.45 pigment { rgb <0.8, 0.3, 0.4> } }
plane { y, -1 pigment { rgb 0.75 } }
