// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// filter colours the shadow, transmit lightens it, two panes multiply; no_shadow casts none.
camera { location <0, 4, -5> look_at <0, 0, 0> angle 46 }
light_source { <-3, 6, -3> rgb 1 }
plane { y, -0.5 pigment { rgb 0.9 } }
#declare Pane = box { <-0.6, 0, -0.6>, <0.6, 0.02, 0.6> }
object { Pane translate <-1.5, 0.6, 0.6> pigment { rgbf <0.9, 0.3, 0.2, 0.9> } }
object { Pane translate <0.2, 0.6, 0.6> pigment { rgbt <0.9, 0.3, 0.2, 0.6> } }
object { Pane translate <0.6, 0.9, 0.4> pigment { rgbf <0.2, 0.5, 0.9, 0.9> } }
object { Pane translate <1.7, 0.6, -0.3> pigment { checker rgbf <0.2, 0.9, 0.3, 1>, rgb 0.2 scale 0.3 } }
sphere { <-0.8, 0.2, -1>, 0.4 pigment { rgb <0.9, 0.8, 0.3> } no_shadow }
