// golden: +W80 +H60 -A +FN5 +THFS; psnr >= 60; errors are handed on to the last bit
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -z right 2*x up 1.5*y }
plane { -z, 0 pigment { function { (x + 1)*0.5*(0.3 + 0.7*(y*0.6 + 0.5)) } color_map { [0 rgb <0, 0.02, 0.1>] [1 rgb <1, 0.6, 0.9>] } } finish { ambient 1 diffuse 0 } }
