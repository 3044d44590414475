// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// A common ring, a thin one edge on, a fat one and a spindle that cuts itself.
camera { location <0, 2.8, -6> look_at 0 angle 46 }
light_source { <-4, 6, -6> rgb 1 }
torus { 0.9, 0.3 rotate -35*x translate <-1.5, 0, 0> pigment { rgb <0.9, 0.5, 0.2> } }
torus { 0.8, 0.08 rotate <90, 25, 0> translate <0.2, 0.4, 1> pigment { rgb <0.3, 0.8, 0.4> } }
torus { 0.5, 0.48 translate <0.7, -0.5, -0.8> pigment { rgb <0.4, 0.5, 0.9> } }
torus { 0.3, 0.55 rotate 80*x scale <1, 1.2, 1> translate <2.1, 0, 0.4> pigment { rgb <0.8, 0.7, 0.3> } }
plane { y, -1 pigment { rgb 0.75 } }
