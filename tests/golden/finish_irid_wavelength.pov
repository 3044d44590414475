// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 irid_wavelength rgb <0.4, 0.66, 0.9> }
camera { location <0, 1.4, -7> look_at <0, -0.1, 0> angle 40 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
sphere { <-1.7, 0, 0>, 0.75 pigment { rgb 0.6 } finish { phong 0.6 irid { 0.4 thickness 0.3 } } }
sphere { <0, 0, 0>, 0.75 pigment { rgb 0.6 } finish { phong 0.6 irid { 0.6 thickness 1.2 } } }
sphere { <1.7, 0, 0>, 0.75 pigment { rgb 0.3 } finish { reflection 0.4 irid { 0.5 thickness 0.6 } } }
box { <-3.5, -1, -3.5>, <3.5, -0.9, 2.5> pigment { checker rgb 0.8, rgb <0.35, 0.45, 0.4> } }
