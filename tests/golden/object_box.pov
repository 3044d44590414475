// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// Corners in any order, a flat slab and a turned box.
camera { location <2, 3, -6> look_at <0, -0.1, 0> angle 52 }
light_source { <-4, 7, -5> rgb 1 }
box { -0.7, 0.7 rotate 30*y translate -1.2*x pigment { rgb <0.8, 0.5, 0.2> } }
box { <2, 0.9, 0.3>, <0.8, -0.7, -0.6> rotate <20, 0, 25> pigment { rgb <0.3, 0.5, 0.8> } }
box { <-3, -1, -3>, <3, -0.9, 3> pigment { rgb <0.6, 0.7, 0.6> } }
