// golden: +W96 +H72 -A; psnr >= 45; bent and mirrored rays magnify last-bit differences at edges
#version 3.7;
global_settings { assumed_gamma 1 }
// Plain mirrors, grey and coloured, and an exponent.
camera { location <0, 1.4, -7> look_at <0, -0.1, 0> angle 40 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
sphere { <-1.8, 0, 0>, 0.552 pigment { rgb <0.9, 0.55, 0.25> } finish { reflection 0.3 } }
sphere { <-0.6, 0, 0>, 0.552 pigment { rgb <0.9, 0.55, 0.25> } finish { reflection 0.8 diffuse 0.2 } }
sphere { <0.6, 0, 0>, 0.552 pigment { rgb <0.9, 0.55, 0.25> } finish { reflection rgb <0.9, 0.4, 0.2> diffuse 0 } }
sphere { <1.8, 0, 0>, 0.552 pigment { rgb <0.9, 0.55, 0.25> } finish { reflection 0.7 reflection_exponent 0.5 diffuse 0.1 } }
box { <-3.5, -1, -3.5>, <3.5, -0.9, 2.5> pigment { checker rgb 0.8, rgb <0.35, 0.45, 0.4> } }
