// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// Mirroring by a negative factor, and a factor of 0, which counts as 1 (with a warning).
camera { location <0, 2, -6> look_at 0 angle 52 }
light_source { <-4, 6, -6> rgb 1 }
#declare Horn = union { cone { 0, 0.5, <0.3, 1, 0.2>, 0.1 } sphere { <0.4, 1.1, 0.3>, 0.25 } }
object { Horn translate -1.8*x pigment { rgb <0.9, 0.5, 0.3> } }
object { Horn scale <-1, 1, 1> translate -0.3*x pigment { rgb <0.3, 0.6, 0.9> } }
object { Horn scale <1, -0.7, 1> translate <0.9, 0.6, 0> pigment { rgb <0.4, 0.8, 0.4> } }
object { Horn scale <0.6, 0, 0.6> translate 2*x pigment { rgb <0.8, 0.8, 0.3> } }
plane { y, -0.4 pigment { rgb 0.7 } }
