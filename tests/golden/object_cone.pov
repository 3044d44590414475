// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// A frustum, a pointed cone, an open one looked into, and one whose first radius is the smaller.
camera { location <0, 2.7, -6> look_at -0.1*y angle 52 }
light_source { <-4, 6, -6> rgb 1 }
cone { <-1.8, -1, 0>, 0.7, <-1.8, 0.6, 0>, 0.3 pigment { rgb <0.9, 0.5, 0.3> } }
cone { <-0.3, -1, 0.6>, 0.6, <-0.5, 1.2, 0.4>, 0 pigment { rgb <0.3, 0.7, 0.4> } }
cone { <1, -0.9, -0.6>, 0.3, <1.1, 0.4, -0.5>, 0.75 open pigment { rgb <0.3, 0.5, 0.9> } }
cone { <2, -0.9, 1>, 0.1, <2.3, 0.6, 0.8>, 0.5 pigment { rgb <0.8, 0.8, 0.3> } }
plane { y, -1 pigment { rgb 0.75 } }
