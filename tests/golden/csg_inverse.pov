// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// inverse turns a solid inside out: intersecting with it subtracts.
camera { location <0, 2, -6> look_at 0 angle 42 }
light_source { <-4, 6, -6> rgb 1 }
intersection {
  sphere { 0, 1 }
  box { <0, 0, -2>, <2, 2, 0.2> inverse pigment { rgb <0.3, 0.5, 0.9> } }
  pigment { rgb <0.9, 0.6, 0.3> } translate -1.2*x
}
difference {                       // subtracting an inverted solid intersects with it
  box { -0.8, 0.8 }
  sphere { 0, 1.05 inverse pigment { rgb <0.4, 0.8, 0.4> } }
  pigment { rgb <0.9, 0.4, 0.5> } rotate <20, 30, 0> translate 1.2*x
}
plane { y, -1.2 pigment { rgb 0.7 } }
