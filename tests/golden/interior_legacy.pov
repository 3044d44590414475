// golden: +W96 +H72 -A; psnr >= 45; bent rays magnify last-bit differences at edges
#version 3.6;
global_settings { assumed_gamma 1 }
// What finishes said of interiors in old scenes, and refraction that dims.
camera { location <0, 1.2, -7> look_at <0, 0, 0> angle 40 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
box { <-4, -1, -1>, <4, -0.9, 6> pigment { checker rgb 0.8, rgb <0.35, 0.45, 0.4> } }
sphere { <-1.7, 0, 0>, 0.75 pigment { rgbf 1 } finish { ior 1.4 refraction 0.7 } }
sphere { <0, 0, 0>, 0.75 pigment { rgbt <1, 0.7, 0.7, 0.8> } finish { refraction 1 ior 1.2 reflection 0.2 phong 0.8 } interior { ior 2 } }
sphere { <1.7, 0, 0>, 0.75 pigment { checker rgbf <0.9, 1, 0.8, 0.9>, rgbt 0.8 scale 0.4 } interior { ior 1.3 refraction 0.5 } }
