// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// The pattern repeats; below zero it runs on, not backwards. Without a map: black to white.
camera { orthographic location <0, 0, -5> look_at 0 right 4*x up 3*y }
light_source { <-3, 5, -9> rgb 1 }
#default { finish { ambient 1 diffuse 0 } }
box { <-1.95, 0.1, 0>, <-0.05, 1.45, 1> pigment { gradient x } }
box { <0.05, 0.1, 0>, <1.95, 1.45, 1> pigment { gradient <1, 1, 0> color_map { [0 rgb <1, 0, 0>] [0.5 rgb <1, 1, 0>] [1 rgb <0, 0, 1>] } } }
box { <-1.95, -1.45, 0>, <-0.05, -0.1, 1> pigment { gradient y color_map { [0.3 rgb <0, 0.5, 0>] [0.3 rgb <0.9, 0.9, 0.5>] [0.7 rgb <0.9, 0.5, 0.1>] [0.7 rgb 0.2] } scale 0.53 rotate 25*z } }
box { <0.05, -1.45, 0>, <1.95, -0.1, 1> pigment { gradient -x color_map { [0.25 rgb 1] [0.75 rgb <0.1, 0.2, 0.5>] } scale 0.77 } }
