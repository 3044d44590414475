// golden: +W96 +H72 -A; psnr >= 50; the samples of the grid are where the oracle has them
#version 3.7;
global_settings { assumed_gamma 1 }
// The whole area shines, not only its centre.
light_source { <-2, 2.5, -2> rgb 0.6 area_light <3, 0, 0>, <0, 0, 2>, 5, 4 area_illumination fade_distance 3 fade_power 2 }
light_source { <3, 3, -1> rgb 0.6 spotlight radius 10 falloff 25 point_at <1, 0, 0> area_light <1, 0, 0>, <0, 0, 1>, 3, 3 area_illumination on }
camera { location <0, 3, -5> look_at <0, 0.3, 0.4> angle 50 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <-0.9, 0.5, 0.2>, 0.5 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.7 } }
box { <0.4, 0, -0.4>, <0.9, 1, 0.3> pigment { rgb <0.4, 0.6, 0.9> } rotate y * 20 }
cylinder { <1.6, 0, 1>, <1.6, 1.6, 1>, 0.1 pigment { rgb 0.7 } }
