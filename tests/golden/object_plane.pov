// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// Distances along normals that are not unit vectors, and a plane seen from behind.
camera { location <0, 1, -5> look_at <0, 0.4, 0> angle 60 }
light_source { <-2, 4, -4> rgb 1 }
plane { 2*y, -0.5 pigment { rgb <0.8, 0.7, 0.5> } }
plane { <1, 0.2, -1>, -3 pigment { rgb <0.4, 0.6, 0.8> } }
plane { <-3, 1, 2>, 2.5 inverse pigment { rgb <0.7, 0.4, 0.4> } }
