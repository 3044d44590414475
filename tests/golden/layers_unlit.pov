// golden: +W80 +H60 -A; psnr >= 60; the top layer ignores the light, the one below it does not
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> look_at 0 angle 50 }
light_source { <-3, 4, -6> rgb 1 }
light_source { <5, 2, -1> rgb <0.2, 0.3, 0.5> }
#declare Glow = texture { pigment { checker rgbt <1, 0.3, 0, 0.7> rgbt <0, 0.4, 1, 0.9> scale 0.5 } finish { diffuse 0 ambient 0.6 } }
#declare Clay = texture { pigment { rgb <0.9, 0.8, 0.7> } finish { phong 0.5 } }
sphere { -0.9*x, 0.8 texture { Clay } texture { Glow } }
box { <0.2, -0.7, -0.6>, <1.4, 0.6, 0.6> texture { Clay } texture { Glow } rotate 20*y }
plane { y, -0.8 texture { Clay } texture { Glow } }
