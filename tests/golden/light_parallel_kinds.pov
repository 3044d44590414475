// golden: +W96 +H72 -A; psnr >= 50; the samples of the grid are where the oracle has them
#version 3.7;
global_settings { assumed_gamma 1 }
// Everything can be parallel.
light_source { <-1, 1.2, -2> rgb 0.4 parallel point_at <0, 0, 0> fade_distance 2 fade_power 1 }
light_source { <2, 3, -1> rgb <0.5, 0.6, 0.8> spotlight radius 5 falloff 20 parallel point_at <0.8, 0, 0> }
light_source { <0, 5, 1> rgb <0.4, 0.3, 0.2> parallel shadowless point_at <0.5, 0, 0> }
camera { location <0, 3, -5> look_at <0, 0.3, 0.4> angle 50 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <-0.9, 0.5, 0.2>, 0.5 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.7 } }
box { <0.4, 0, -0.4>, <0.9, 1, 0.3> pigment { rgb <0.4, 0.6, 0.9> } rotate y * 20 }
cylinder { <1.6, 0, 1>, <1.6, 1.6, 1>, 0.1 pigment { rgb 0.7 } }
