// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// Declared transforms, one within the other, inverse, and as an object's modifier.
camera { location <0, 2, -6> look_at 0 angle 52 }
light_source { <-4, 6, -6> rgb 1 }
#declare Lean = transform { rotate 35*z translate 0.3*y }
#declare Away = transform { Lean scale <1, 1, 2> translate 1.4*x }
box { -0.5, 0.5 transform Lean translate -1.7*x pigment { rgb <0.9, 0.5, 0.3> } }
box { -0.5, 0.5 transform { Away } pigment { rgb <0.3, 0.6, 0.9> } }
box { -0.5, 0.5 transform { Away } transform { Away inverse } scale 0.8 pigment { rgb <0.4, 0.8, 0.4> } }
box { -0.5, 0.5 transform { Lean inverse } translate <2.6, 0, 1> pigment { rgb <0.8, 0.8, 0.3> } }
plane { y, -0.9 pigment { rgb 0.7 } }
