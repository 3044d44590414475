// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// Shadows through several bodies, layers, patterns and interior textures.
camera { location <0, 4, -6> look_at <0, 0.2, 0.3> angle 45 }
light_source { <-4, 6, -3> rgb 0.7 }
light_source { <3, 7, 1> rgb 0.4 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <-1.5, 0.9, 0>, 0.6 pigment { rgbf <1, 0.4, 0.3, 0.9> } }
box { <-0.6, 0.4, -0.5>, <0.6, 0.5, 0.5> texture { pigment { checker rgbt <1, 1, 1, 0.9>, rgb 0.5 scale 0.25 } } texture { pigment { rgbf <0.5, 0.8, 1, 0.8> } } }
sphere { <1.5, 0.9, 0>, 0.6 texture { pigment { rgbf <0.4, 1, 0.4, 0.9> } } interior_texture { pigment { gradient y color_map { [0 rgbt 1] [1 rgbf <1, 0.5, 0, 0.7>] } scale 0.3 } } interior { fade_distance 0.7 fade_power 1001 fade_color <0.9, 0.8, 0.3> } }
sphere { <0, 1.6, 1.5>, 0.4 pigment { rgb 0.6 } no_shadow }
