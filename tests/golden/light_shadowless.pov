// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// No shadows and no highlights from the second lamp.
camera { location <0, 3, -6> look_at <0, 0.2, 0> angle 42 }
light_source { <-4, 5, -4> rgb 0.5 }
light_source { <4, 5, -4> rgb <0.5, 0.6, 0.8> shadowless }
sphere { <-0.8, 0.7, 0>, 0.7 pigment { rgb <0.9, 0.4, 0.3> } finish { phong 1 } }
box { <0.4, 0, -0.4>, <1.2, 1, 0.4> pigment { rgb <0.4, 0.8, 0.4> } finish { specular 1 roughness 0.1 } }
plane { y, 0 pigment { rgb 0.8 } }
