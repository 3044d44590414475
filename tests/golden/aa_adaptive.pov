// golden: +W80 +H60 +A0.1 +AM2 +R4; psnr >= 60; which samples are taken is exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at <0, 0, 0> angle 44 }
light_source { <-4, 6, -6> rgb 1 }
sphere { <-0.9, 0.1, 0>, 0.8 pigment { rgb <0.9, 0.4, 0.3> } finish { phong 0.8 } }
torus { 0.6, 0.12 rotate <-50, 0, 20> translate <1, 0.1, 0> pigment { rgb <0.3, 0.5, 0.9> } }
plane { y, -0.8 pigment { checker rgb 0.9, rgb 0.2 scale 0.5 } }
