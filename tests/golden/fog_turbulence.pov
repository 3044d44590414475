// golden: +W96 +H72 -A; psnr >= 50; fog is a formula
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at <0, 0, 4> angle 50 }
light_source { <-6, 9, -6> rgb 1 }
background { rgb <0.2, 0.3, 0.7> }
box { <-4, -1, -1>, <4, -0.9, 30> pigment { checker rgb 0.8, rgb <0.3, 0.35, 0.4> } }
#for (I, 0, 5) sphere { <2 * mod(I, 2) - 1, 0, 1 + 3 * I>, 0.8 pigment { rgb <0.9, 0.5 - 0.05 * I, 0.1 * I> } finish { phong 0.6 } } #end
fog { distance 9 rgb <0.7, 0.75, 0.8> turbulence <0.4, 0.6, 0.3> turb_depth 0.8 octaves 4 omega 0.6 lambda 2.2 }
fog { fog_type 2 distance 5 rgb <0.9, 0.7, 0.5> fog_offset -0.8 fog_alt 0.3 turbulence 0.5 }
