// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// The same three steps in different orders.
camera { orthographic location <0, 0, -5> look_at 0 right 5.4*x up 4.05*y }
light_source { <-3, 5, -9> rgb 1 }
#declare Bar = box { <0, 0, -0.2>, <1, 0.3, 0.2> }
object { Bar rotate 40*z translate <-2.7, 0.8, 0> scale <1, 0.8, 1> pigment { rgb <0.9, 0.3, 0.2> } }
object { Bar translate <-0.6, 0.9, 0> rotate -30*z scale <1, 0.8, 1> pigment { rgb <0.3, 0.8, 0.3> } }
object { Bar scale <1, 2, 1> rotate <30, 40, 50> translate <1.4, 0.3, 0> pigment { rgb <0.3, 0.4, 0.9> } }
object { Bar rotate <0, 0, 50> scale <1.5, 0.5, 1> translate <-2.6, -1.6, 0> pigment { rgb <0.8, 0.8, 0.3> } }
object { Bar scale <1.5, 0.5, 1> rotate <0, 0, 50> translate <0, -1.6, 0> pigment { rgb <0.3, 0.8, 0.8> } }
object { Bar rotate x*45 rotate y*45 rotate z*45 translate <1.6, -1.5, 0> pigment { rgb <0.8, 0.4, 0.8> } }
background { rgb 0.2 }
