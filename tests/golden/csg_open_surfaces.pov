// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// Surfaces without an inside in an intersection: kept where the solid holds them.
camera { location <0, 2.4, -6> look_at 0 angle 42 }
light_source { <-4, 6, -6> rgb 1 }
intersection { cylinder { -y, y, 0.8 open } sphere { 0, 1.05 } pigment { rgb <0.9, 0.5, 0.3> } translate -1.4*x }
intersection { disc { 0, <0.4, 1, -0.5>, 2 } box { -0.8, 0.8 } pigment { rgb <0.3, 0.6, 0.9> } translate 1.3*x }
plane { y, -1.3 pigment { rgb 0.7 } }
