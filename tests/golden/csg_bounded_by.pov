// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// A bound that holds the object changes nothing; bounded_by { clipped_by } takes over the clip.
camera { location <0, 2, -6> look_at 0 angle 42 }
light_source { <-4, 6, -6> rgb 1 }
union {
  sphere { -0.5*x, 0.5 } sphere { 0.5*x, 0.5 }
  bounded_by { box { <-1.05, -0.55, -0.55>, <1.05, 0.55, 0.55> } }
  pigment { rgb <0.9, 0.5, 0.3> } translate <-1.2, 0.2, 0>
}
torus { 0.8, 0.3 clipped_by { plane { -z, 0.1 } } bounded_by { clipped_by } rotate 20*y pigment { rgb <0.3, 0.6, 0.9> } translate 1.2*x }
plane { y, -1 pigment { rgb 0.7 } }
