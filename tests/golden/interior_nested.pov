// golden: +W96 +H72 -A; psnr >= 45; bent and mirrored rays magnify last-bit differences at edges
#version 3.7;
global_settings { assumed_gamma 1 }
// A bubble of air in glass, a heavy core in light glass, and hollow glass by difference.
camera { location <0, 1.4, -6> look_at <0, -0.1, 0> angle 56 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.5, 0.7, 0.9> }
#declare Clear = texture { pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.05 } }
sphere { <-1.9, 0, 0>, 0.85 texture { Clear } interior { ior 1.5 } }
sphere { <-1.9, 0, 0>, 0.4 texture { Clear } interior { ior 1 } }
sphere { <0, 0, 0>, 0.85 texture { Clear } interior { ior 1.2 } }
sphere { <0, 0, 0>, 0.4 pigment { rgbf <1, 0.7, 0.4, 0.9> } interior { ior 1.8 } }
difference { sphere { <1.9, 0, 0>, 0.85 } sphere { <1.9, 0, 0>, 0.75 } texture { Clear } interior { ior 1.5 } }
box { <-4, -1.2, -4>, <4, -0.9, 3> pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.7> scale 0.6 } }
