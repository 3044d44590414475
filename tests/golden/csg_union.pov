// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// Nested unions: transformations add up, and a texture set outside reaches the bare children only.
camera { location <0, 2, -6> look_at 0 angle 42 }
light_source { <-4, 6, -6> rgb 1 }
#declare Pair = union {
  sphere { -0.6*x, 0.5 }
  box { <0.2, -0.4, -0.4>, <1, 0.4, 0.4> pigment { rgb <0.3, 0.5, 0.9> } }
}
union {
  object { Pair translate 0.7*y }
  union { object { Pair rotate 50*z } cylinder { -1.6*x, 1.6*x, 0.12 } translate -0.6*y }
  pigment { rgb <0.9, 0.6, 0.3> }
  rotate -20*y
}
plane { y, -1.6 pigment { rgb 0.7 } }
