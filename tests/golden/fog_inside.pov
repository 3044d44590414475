// golden: +W96 +H72 -A; psnr >= 45; bent and mirrored rays magnify last-bit differences at edges
#version 3.7;
global_settings { assumed_gamma 1 }
// No fog inside of solid bodies: of glass, unless it is hollow. In mirrors every way has its own.
camera { location <0, 1.2, -5> look_at <0, 0, 2> angle 50 }
light_source { <-6, 9, -6> rgb 1 media_attenuation on }
background { rgb <0.2, 0.3, 0.7> }
box { <-6, -1, -1>, <6, -0.9, 30> pigment { checker rgb 0.8, rgb <0.3, 0.35, 0.4> } }
sphere { <-1.7, 0, 0>, 0.9 pigment { rgbf <0.9, 1, 0.95, 0.9> } finish { reflection 0.1 } interior { ior 1.3 } }
sphere { <0.2, 0, 0>, 0.9 pigment { rgbf <0.9, 1, 0.95, 0.9> } finish { reflection 0.1 } interior { ior 1.3 } hollow }
sphere { <2.1, 0, 0>, 0.9 pigment { rgb 0.1 } finish { reflection 0.7 } }
box { <-3, -0.9, 6>, <3, 3, 6.2> pigment { rgb <0.8, 0.3, 0.2> } }
fog { distance 8 rgb <0.8, 0.8, 0.75> }
