// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// filter tints what lies behind, transmit only thins; 0.5 of each together.
camera { location <0, 1.5, -6> look_at <0, 0, 0> angle 42 }
light_source { <-4, 6, -6> rgb 1 shadowless }
plane { z, 2 pigment { checker rgb <0.9, 0.9, 0.9>, rgb <0.3, 0.5, 0.9> scale 0.8 } }
box { <-2.2, -0.9, 0>, <-1.3, 0.9, 0.1> pigment { rgbf <0.9, 0.3, 0.2, 0.7> } }
box { <-1.1, -0.9, 0>, <-0.2, 0.9, 0.1> pigment { rgbt <0.9, 0.3, 0.2, 0.7> } }
box { <0, -0.9, 0>, <0.9, 0.9, 0.1> pigment { color rgbft <0.9, 0.3, 0.2, 0.5, 0.5> } }
box { <1.1, -0.9, 0>, <2, 0.9, 0.1> pigment { rgb <0.9, 0.3, 0.2> filter 0.3 transmit 0.3 } }
