// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// Three coloured lamps: shadows in the mixed colours; a dark one takes light away.
camera { location <0, 4, -6> look_at <0, 0.2, 0> angle 42 }
light_source { <-3, 4, -3> rgb <0.9, 0.2, 0.1> }
light_source { <3, 4, -3> rgb <0.1, 0.8, 0.2> }
light_source { <0, 4, 3> color rgb <0.2, 0.3, 1> }
light_source { <0, 1.5, -4> rgb -0.15 }
sphere { <0, 0.6, 0>, 0.6 pigment { rgb 0.9 } }
cylinder { <-1.6, 0, 0>, <-1.6, 1, 0>, 0.2 pigment { rgb 0.9 } }
plane { y, 0 pigment { rgb 0.9 } }
