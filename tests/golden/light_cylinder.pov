// golden: +W96 +H72 -A; psnr >= 50; the samples of the grid are where the oracle has them
#version 3.7;
global_settings { assumed_gamma 1 }
// Beams: soft edges, tightness, fading.
light_source { <-1.5, 4, -2> rgb 0.8 cylinder radius 0.5 falloff 1 point_at <-0.9, 0, 0.2> }
light_source { <2, 4, -1> rgb <0.5, 0.8, 1> cylinder radius 0.2 falloff 1.1 tightness 2 point_at <0.8, 0, 0> fade_distance 4 fade_power 1 }
light_source { <0, 1.5, -1.6> rgb <1, 0.4, 0.4> cylinder radius 0.3 falloff 0.3 point_at <0, 0, -1.2> area_light x * 0.2, z * 0.2, 3, 3 }
camera { location <0, 3, -5> look_at <0, 0.3, 0.4> angle 50 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <-0.9, 0.5, 0.2>, 0.5 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.7 } }
box { <0.4, 0, -0.4>, <0.9, 1, 0.3> pigment { rgb <0.4, 0.6, 0.9> } rotate y * 20 }
cylinder { <1.6, 0, 1>, <1.6, 1.6, 1>, 0.1 pigment { rgb 0.7 } }
