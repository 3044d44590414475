// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
sphere { <-1.4, 0, 0>, 1 pigment { rgb <0.9, 0.3, 0.2> } }
sphere { 0, 1 scale <0.4, 1.3, 0.8> rotate -25*z translate <0.9, 0.2, -0.3> pigment { rgb <0.2, 0.7, 0.4> } }
sphere { <1.9, -0.5, 1>, 0.5 pigment { rgb <0.3, 0.4, 0.9> } }
plane { y, -1.2 pigment { rgb 0.7 } }
