// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// A difference of differences and unions, with coincident faces on the outside only.
camera { location <2, 3, -5> look_at <0, -0.1, 0> angle 42 }
light_source { <-4, 7, -6> rgb 1 }
#declare Pipe = difference {
  cylinder { -1.5*x, 1.5*x, 0.5 }
  cylinder { -1.6*x, 1.6*x, 0.35 }
}
difference {
  union { object { Pipe } object { Pipe rotate 90*y } }
  union { cylinder { -1.6*x, 1.6*x, 0.35 } cylinder { -1.6*z, 1.6*z, 0.35 } }
  difference { box { <-2, 0, -2>, <2, 2, 2> } box { <-2, -1, 0.1>, <2, 3, 2> } }
  pigment { rgb <0.8, 0.7, 0.5> }
  rotate 15*y
}
plane { y, -0.7 pigment { rgb <0.5, 0.6, 0.7> } }
