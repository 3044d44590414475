// golden: +W96 +H72 -A; psnr >= 40; both gather with noise of their own
#version 3.7;
// What gathers light goes on behind panes and hollow bodies, and still sees no media there.
global_settings { assumed_gamma 1 radiosity { count 300 error_bound 0.4 recursion_limit 1 } }
camera { location <0, 2, -6> look_at <0, 0.8, 0> angle 45 }
background { rgb <0.2, 0.3, 0.5> }
plane { y, 0 pigment { rgb 0.8 } finish { diffuse 0.8 } }
sphere { <-1.2, 1, 0>, 0.9 pigment { rgbt 1 } hollow interior { media { emission <3, 2, 0.5> } } }
box { <0.2, 0.1, -0.1>, <2, 1.8, 0.1> pigment { rgbf <0.9, 0.4, 0.4, 0.9> } rotate 30*y }
sphere { <1.4, 0.6, 1.2>, 0.6 pigment { rgb 1 } finish { diffuse 0 emission 2 } }
