// golden: +W64 +H48 +A0.0 +AM1 +R9 +J; psnr >= 38; both are means of 82 random grids per pixel
#version 3.7;
global_settings { assumed_gamma 1 }
// Jitter: the mean of many samples is smooth.
light_source { <-3, 4, -3> rgb 0.6 area_light <2, 0, 0>, <0, 0, 2>, 3, 3 jitter }
light_source { <4, 4, -1> rgb <0.4, 0.5, 0.6> area_light <1, 1, 0>, <0, 0.5, 2>, 3, 3 jitter circular adaptive 1 }
camera { location <0, 3, -5> look_at <0, 0.3, 0.4> angle 50 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <-0.9, 0.5, 0.2>, 0.5 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.7 } }
box { <0.4, 0, -0.4>, <0.9, 1, 0.3> pigment { rgb <0.4, 0.6, 0.9> } rotate y * 20 }
cylinder { <1.6, 0, 1>, <1.6, 1.6, 1>, 0.1 pigment { rgb 0.7 } }
