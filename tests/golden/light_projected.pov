// golden: +W96 +H72 -A; psnr >= 50; the samples of the grid are where the oracle has them
#version 3.7;
global_settings { assumed_gamma 1 }
// Light through windows only; what lies behind them casts no shadow.
light_source { <-2, 4, -3> rgb 0.8 projected_through { box { <-1.8, 2, -2>, <-0.8, 2.1, -1> } } }
light_source { <2.5, 4, -2> rgb <0.4, 0.5, 0.7> shadowless projected_through { disc { <1.2, 2, -0.6>, <1, 2, -1>, 0.8, 0.2 } } }
sphere { <-1.6, 3, -2.1>, 0.2 pigment { rgb 0.5 } }
sphere { <-0.75, 0.9, -0.6>, 0.15 pigment { rgb 0.5 } }
camera { location <0, 3, -5> look_at <0, 0.3, 0.4> angle 50 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <-0.9, 0.5, 0.2>, 0.5 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.7 } }
box { <0.4, 0, -0.4>, <0.9, 1, 0.3> pigment { rgb <0.4, 0.6, 0.9> } rotate y * 20 }
cylinder { <1.6, 0, 1>, <1.6, 1.6, 1>, 0.1 pigment { rgb 0.7 } }
