// golden: +W96 +H72 -A File_Gamma=1; psnr >= 50; the conversion between scene and file is given exactly
// A file of linear numbers, asked for by an option.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> look_at 0 right 4*x up 3*y }
light_source { <-3, 4, -6> rgb 1 }
box { <-1.9, 0.6, 0>, <1.9, 1.4, 1> pigment { gradient x scale 3.81 translate -1.905*x } finish { ambient 1 diffuse 0 } }
sphere { <-1, -0.4, 0>, 0.8 pigment { rgb <0.8, 0.4, 0.2> } }
sphere { <0.9, -0.4, 0>, 0.8 pigment { rgb <0.25, 0.5, 0.75> } finish { ambient 0.4 phong 0.6 } }
box { <-1.9, -1.45, -1>, <1.9, -1.25, 1> pigment { color rgb <0.5, 0.5, 0.5> } finish { ambient 1 diffuse 0 } }
