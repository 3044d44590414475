// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// Colours without the word color, and components set after them.
camera { orthographic location <0.013, 0.007, -5> look_at <0.013, 0.007, 0> right 4*x up 3*y }
light_source { <-3, 5, -9> rgb 1 }
#default { finish { ambient 0.3 diffuse 0.6 } }
plane { z, 1 pigment { gradient x color_map { [0 rgb 0.1] [1 rgb <0.9, 0.9, 0.3>] } scale 0.6 } }
#declare Rust = rgb <0.7, 0.3, 0.1>;
#declare Clear = rgbf <0.4, 0.8, 0.5, 0.6>;
sphere { <-1.5, 1, 0>, 0.45 pigment { Rust filter 0.7 } }
sphere { <-0.5, 1, 0>, 0.45 pigment { Rust*1.2 transmit 0.6 } }
sphere { <0.5, 1, 0>, 0.45 pigment { Clear transmit 0.3 } }
sphere { <1.5, 1, 0>, 0.45 pigment { color Rust green 0.6 filter 0.4 } }
sphere { <-1.5, 0, 0>, 0.45 pigment { color <0.2, 0.4, 0.8> } }
sphere { <-0.5, 0, 0>, 0.45 pigment { red 0.8 blue 0.3 filter 0.5 } }
sphere { <0.5, 0, 0>, 0.45 pigment { rgbft <0.9, 0.6, 0.3, 0.2, 0.5> } }
sphere { <1.5, 0, 0>, 0.45 pigment { Clear filter 0 } }
sphere { <-1.5, -1, 0>, 0.45 pigment { checker Rust Clear scale 0.2 } }
sphere { <-0.5, -1, 0>, 0.45 pigment { checker Rust filter 0.8 Clear transmit 0.2 scale 0.2 } }
sphere { <0.5, -1, 0>, 0.45 pigment { gradient y color_map { [0 Rust] [0.5 Clear filter 0.1] [1 Rust transmit 0.7] } scale 0.4 } }
sphere { <1.5, -1, 0>, 0.45 pigment { Rust } pigment { color .5 } }
