// golden: +W96 +H72 -A; psnr >= 45; a pattern edge may fall on the other side of a pixel
#version 3.7;
global_settings { assumed_gamma 1 }
// No vanishing point; the window by right and up.
camera { orthographic location <3, 3, -5> right 6*x up 4.5*y look_at <0, 0.2, 0> }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
#for (I, -3, 3) sphere { <I, 0, 0>, 0.35 pigment { rgb <0.5 + I/7, 0.4, 0.5 - I/7> } } #end
cone { 0.3*y, 0.3, 1.4*y, 0 translate 1*x pigment { rgb <0.9, 0.8, 0.3> } }
plane { y, -0.4 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.4> } }
