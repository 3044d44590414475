// golden: +W48 +H36 +A0.0 +AM1 +R9 -J; psnr >= 45; the mean of 82 grains in either picture: 1.1 steps of 255 apart, without bias
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -4> look_at 0 angle 40 }
light_source { <-4, 8, -6> rgb 1 }
plane { y, -1 pigment { rgb <0.7, 0.8, 0.9> } finish { ambient 0.3 diffuse 0.6 crand 0.15 } }
sphere { <-0.7, 0, 0>, 0.7 pigment { rgb <0.9, 0.6, 0.4> } finish { ambient 0.4 diffuse 0.6 crand 0.3 } }
sphere { <0.8, -0.1, 0>, 0.6 pigment { rgb <0.4, 0.7, 0.5> } finish { ambient 0.4 diffuse 0.6 crand 0.3 phong 0.5 } }
