// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// Clipping opens a surface without closing it: the inside shows.
camera { location <0, 2.2, -6> look_at 0 angle 52 }
light_source { <-4, 6, -6> rgb 1 }
sphere { 0, 0.9 clipped_by { plane { <0.3, 1, -0.4>, 0.2 } } pigment { rgb <0.9, 0.5, 0.3> } translate -1.9*x }
union {
  box { -0.7, 0.7 } cylinder { -1.2*y, 1.2*y, 0.3 }
  clipped_by { sphere { <0.2, 0, 0>, 0.98 } plane { x, 0.45 } }
  pigment { rgb <0.3, 0.6, 0.9> } rotate 30*y translate 0.1*x
}
difference {
  sphere { 0, 0.9 } sphere { 0, 0.75 }
  clipped_by { box { <-0.3, -0.2, -1>, <1, 1, 0.1> inverse } }
  pigment { rgb <0.5, 0.8, 0.4> } translate 1.9*x
}
plane { y, -1.2 pigment { rgb 0.7 } }
