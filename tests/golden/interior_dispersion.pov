// golden: +W96 +H72 -A; psnr >= 45; bent and mirrored rays magnify last-bit differences at edges
#version 3.7;
global_settings { assumed_gamma 1 }
// Glass splits white light; more samples make a smoother band.
camera { location <0, 0.4, -5> look_at <0, 0, 0> angle 48 }
light_source { <-4, 6, -6> rgb 1 }
#for (I, -8, 8) box { <I*0.5 - 0.04, -2, 2>, <I*0.5 + 0.04, 3, 2.1> pigment { rgb 1 } finish { ambient 1 diffuse 0 } } #end
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
sphere { <-1.1, 0, 0>, 0.9 texture { Clear } interior { ior 1.5 dispersion 1.2 } }
sphere { <1.1, 0, 0>, 0.9 texture { Clear } interior { ior 1.5 dispersion 1.1 dispersion_samples 20 } }
plane { y, -1.2 pigment { rgb 0.4 } }
