// golden: +W96 +H72 -A; psnr >= 50; the samples of the grid are where the oracle has them
#version 3.7;
global_settings { assumed_gamma 1 }
// Lamps with a shape, which does not stand in their light; moved before and after.
light_source { 0, rgb 0.5 looks_like { sphere { 0, 0.2 pigment { rgb <1, 0.9, 0.5> } finish { ambient 1 } } } translate <-0.3, 1.6, -0.8> }
light_source { <0.2, 0, 0>, rgb <0.4, 0.5, 0.7> translate <1.2, 1.5, -0.9> looks_like { box { -0.1, 0.1 finish { ambient 0.7 } } rotate y * 30 pigment { rgb <0.4, 0.6, 1> } } rotate y * -10 }
union { sphere { <0, 1.2, 1.5>, 0.3 } light_source { <-0.8, 1, 1>, rgb 0.3 looks_like { cone { -y * 0.2, 0.2, y * 0.2, 0 } } } pigment { rgb <0.9, 0.3, 0.6> } finish { ambient 0.5 } }
camera { location <0, 3, -5> look_at <0, 0.3, 0.4> angle 50 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <-0.9, 0.5, 0.2>, 0.5 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.7 } }
box { <0.4, 0, -0.4>, <0.9, 1, 0.3> pigment { rgb <0.4, 0.6, 0.9> } rotate y * 20 }
cylinder { <1.6, 0, 1>, <1.6, 1.6, 1>, 0.1 pigment { rgb 0.7 } }
