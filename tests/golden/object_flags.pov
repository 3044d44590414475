// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// no_shadow, no_image, no_reflection, double_illuminate and hollow.
camera { location <0, 2, -6> look_at <0, 0.2, 0> angle 46 }
light_source { <-4, 6, -2> rgb 1 }
box { <-3, -1, 2>, <3, 2.2, 2.1> pigment { rgb 0.05 } finish { reflection 0.7 } }
sphere { <-1.8, 0, 0>, 0.6 pigment { rgb <0.9, 0.4, 0.3> } no_shadow }
sphere { <-0.3, 0, 0>, 0.6 pigment { rgb <0.4, 0.8, 0.4> } no_image }
sphere { <1.2, 0, 0>, 0.6 pigment { rgb <0.4, 0.5, 0.9> } no_reflection hollow }
disc { <2.3, 0.6, -0.6>, <1, 0.1, -1>, 0.6 pigment { rgb <0.9, 0.8, 0.3> } }
disc { <2.3, -0.5, -0.6>, <1, 0.1, -1>, 0.5 pigment { rgb <0.9, 0.8, 0.3> } double_illuminate }
plane { y, -1 pigment { rgb 0.7 } }
