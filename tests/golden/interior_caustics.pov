// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// Light focused by a formula: through balls, discs with bumps, and by the finish of old.
camera { location <0, 3, -5> look_at <0, 0, 0.3> angle 50 }
light_source { <-3, 6, -2> rgb 0.8 }
plane { y, 0 pigment { rgb 0.8 } }
sphere { <-1.6, 0.9, 0>, 0.7 pigment { rgbf <0.8, 0.9, 1, 0.9> } interior { ior 1.4 caustics 1 } }
disc { <0.2, 0.9, 0>, <0, 1, -0.3>, 0.7 pigment { rgbf <1, 0.8, 0.7, 0.8> } normal { bumps 0.8 scale 0.2 } interior { caustics 0.3 } }
sphere { <1.9, 0.9, 0>, 0.7 pigment { rgbt <0.8, 1, 0.8, 0.9> } finish { ior 1.2 caustics 3 } }
