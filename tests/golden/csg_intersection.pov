// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at 0 angle 52 }
light_source { <-4, 6, -6> rgb 1 }
intersection {                                // a die
  box { -0.8, 0.8 pigment { rgb <0.9, 0.4, 0.3> } }
  sphere { 0, 1.08 pigment { rgb <0.3, 0.4, 0.9> } }
  rotate <15, 35, 0> translate -1.3*x
}
intersection {                                // a lens on edge
  sphere { -0.7*x, 1 }
  sphere { 0.7*x, 1 }
  pigment { rgb <0.4, 0.8, 0.5> } rotate 55*y translate 0.6*x
}
intersection {                                // half-spaces alone make a body
  plane { y, 0.5 } plane { -y, 0.7 } plane { <1, 0, -1>, 0.4 } plane { <-1, 0, -1>, 0.4 } plane { z, 0.3 }
  pigment { rgb <0.9, 0.8, 0.4> } translate 2*x
}
plane { y, -1.2 pigment { rgb 0.7 } }
