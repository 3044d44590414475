// golden: +W96 +H72 -A; psnr >= 45; bent and mirrored rays magnify last-bit differences at edges
#version 3.7;
global_settings { assumed_gamma 1 }
// Weak in front, strong at the rim; falloff, exponent, metallic.
camera { location <0, 1.4, -7> look_at <0, -0.1, 0> angle 40 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
sphere { <-1.8, 0, 0>, 0.552 pigment { rgb <0.9, 0.55, 0.25> } finish { diffuse 0.2 reflection { 0 1 } } }
sphere { <-0.6, 0, 0>, 0.552 pigment { rgb <0.9, 0.55, 0.25> } finish { diffuse 0.2 reflection { 0.1, 0.9 falloff 3 } } }
sphere { <0.6, 0, 0>, 0.552 pigment { rgb <0.9, 0.55, 0.25> } finish { diffuse 0.2 reflection { rgb <0.8, 0.2, 0.1> rgb 1 exponent 0.6 } } }
sphere { <1.8, 0, 0>, 0.552 pigment { rgb <0.9, 0.55, 0.25> } finish { diffuse 0.2 reflection { 0.2, 1 metallic } } }
box { <-3.5, -1, -3.5>, <3.5, -0.9, 2.5> pigment { checker rgb 0.8, rgb <0.35, 0.45, 0.4> } }
