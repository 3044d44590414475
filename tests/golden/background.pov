// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// Rays that meet nothing, seen directly, through glass and in a mirror.
camera { location <0, 0.5, -5> look_at 0 angle 56 }
background { rgb <0.2, 0.5, 0.7> }
light_source { <-4, 6, -6> rgb 1 }
sphere { <-1.1, 0, 0>, 0.9 pigment { rgbf <1, 0.6, 0.3, 0.8> } finish { phong 0.5 } }
sphere { <1.1, 0, 0>, 0.9 pigment { rgb 0.1 } finish { reflection 0.8 } }
