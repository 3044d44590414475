// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// A material carries texture and interior together.
camera { location <0, 1.4, -6> look_at <0, -0.1, 0> angle 46 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.5, 0.7, 0.9> }
#declare Gem = material { texture { pigment { rgbf <0.9, 0.5, 0.4, 0.9> } finish { phong 0.7 } } interior { ior 1.6 } }
sphere { <-1.2, 0, 0>, 0.85 material { Gem } }
sphere { <1.2, 0, 0>, 0.85 material { Gem texture { pigment { rgbf <0.4, 0.9, 0.6, 0.9> } } } }
box { <-4, -1.2, -4>, <4, -0.9, 3> pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.7> scale 0.6 } }
