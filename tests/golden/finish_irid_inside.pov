// golden: +W96 +H72 -A; psnr >= 45; bent and mirrored rays magnify last-bit differences at edges
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
// Films tint total internal reflection too: that of the outermost layer.
camera { location <0, 1.4, -7> look_at <0, -0.1, 0> angle 40 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
#declare Film = finish { diffuse 0.02 reflection 0.05 irid { 0.6 thickness 0.7 } }
box { -0.7, 0.7 pigment { rgbf 1 } finish { Film } interior { ior 1.5 } rotate <0, 30, 0> translate <-1.7, 0, 0> }
cone { <0, -0.75, 0>, 0.8, <0, 0.8, 0>, 0.1
  texture { pigment { rgbf 1 } finish { irid { 0.3 thickness 2 } } } texture { pigment { rgbt <1, 1, 0.8, 0.9> } finish { Film } } interior { ior 1.4 } }
box { -0.7, 0.7 pigment { rgbf 1 } finish { Film } interior { ior 1.5 dispersion 1.1 dispersion_samples 7 } rotate <20, 50, 0> translate <1.7, 0, 0> }
box { <-3.5, -1, -3.5>, <3.5, -0.9, 2.5> pigment { checker rgb 0.8, rgb <0.35, 0.45, 0.4> } }
