// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// Cut faces take the texture of the cutter where it has one, else the difference's.
camera { location <1.5, 2.5, -6> look_at 0 angle 40 }
light_source { <-4, 7, -6> rgb 1 }
difference {
  box { -1, 1 }
  sphere { <0, 0, -1>, 0.7 pigment { rgb <0.3, 0.5, 0.9> } }
  cylinder { -1.1*y, 1.1*y, 0.45 }
  box { <0.4, 0.4, -1.1>, <1.1, 1.1, 1.1> pigment { rgb <0.4, 0.8, 0.4> } }
  pigment { rgb <0.9, 0.6, 0.3> }
  rotate 20*y
}
plane { y, -1.2 pigment { rgb 0.7 } }
