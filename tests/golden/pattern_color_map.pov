// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// Entries before the first key, after the last, doubled keys, the two-colour form, and a declared map.
camera { orthographic location <0, 0, -5> look_at 0 right 4*x up 3*y }
#default { finish { ambient 1 diffuse 0 } }
light_source { -9*z rgb 0 }
#declare Steps = color_map { [0.0, 0.25 color rgb <0.8, 0.1, 0.1> color rgb <0.9, 0.8, 0.2>] [0.25, 0.6 color rgb <0.1, 0.4, 0.3> color rgb <0.2, 0.9, 0.6>] [0.6, 1.0 color rgb 0.1 color rgb 0.9] }
box { <-1.9, 0.55, 0>, <1.9, 1.4, 1> pigment { gradient x color_map { Steps } scale 1.9 } }
box { <-1.9, -0.45, 0>, <1.9, 0.45, 1> pigment { gradient x color_map { [0.2 rgb <0.2, 0.2, 0.8>] [0.4 rgb <0.9, 0.3, 0.3>] [0.4 rgb <0.3, 0.9, 0.3>] [0.9 rgb <1, 1, 0.6>] } scale 1.27 } }
box { <-1.9, -1.4, 0>, <1.9, -0.55, 1> pigment { gradient x color_map { [0.5 rgb <0.9, 0.6, 0.3>] [0.5 rgb <0.3, 0.2, 0.4>] } scale 0.31 translate 0.07*x } }
