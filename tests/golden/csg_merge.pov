// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// Inner surfaces show in a transparent union and are gone in a merge.
camera { location <0, 1.5, -6> look_at 0 angle 42 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
#declare Parts = array[2] { sphere { -0.4*x, 0.7 }, cylinder { -0.1*x, 1*x, 0.4 } }
union { object { Parts[0] } object { Parts[1] } pigment { rgbt <0.9, 0.5, 0.3, 0.6> } translate -1.2*x rotate 15*y }
merge { object { Parts[0] } object { Parts[1] } pigment { rgbt <0.9, 0.5, 0.3, 0.6> } translate 1*x rotate 15*y }
plane { y, -1 pigment { rgb 0.8 } }
