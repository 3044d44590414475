// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// Rows of a matrix are where the axes go; the last row moves. Shear bends normals too.
camera { location <0, 2, -6> look_at 0 angle 42 }
light_source { <-4, 6, -6> rgb 1 }
box { -0.6, 0.6 matrix <1, 0.5, 0,  0, 1, 0,  0, 0.3, 1,  -1.5, 0.1, 0> pigment { rgb <0.9, 0.5, 0.3> } }
sphere { 0, 0.7 matrix <1, 0, 0,  0.8, 1, 0,  0, 0, 1,  1.1, 0, 0> pigment { rgb <0.3, 0.6, 0.9> } finish { phong 0.8 phong_size 20 } }
plane { y, -0.9 pigment { rgb 0.7 } }
