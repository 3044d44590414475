// golden: +W96 +H72 -A; psnr >= 45; a ray's weight may fall on the other side of the limit
#version 3.7;
global_settings { assumed_gamma 1 }
// Rays that count for less than the limit are not followed.
global_settings { adc_bailout 0.12 max_trace_level 20 }
camera { location <0, 1, -3> look_at <0, 0.2, 0> angle 56 }
light_source { <-2, 4, -3> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
#for (I, 0, 3) sphere { <I - 1.5, 0.3, 0.2*I>, 0.45 pigment { rgb <0.9, 0.8, 0.7>*0.4 } finish { reflection 0.3 + 0.2*I } } #end
#for (I, 0, 3) box { <-0.9, -0.2, -0.9 - 0.1*I>, <0.9, 0.1, -0.88 - 0.1*I> pigment { rgbt <0.9, 0.4, 0.4, 0.35> } } #end
plane { y, -0.2 pigment { checker rgb 0.9, rgb 0.4 scale 0.5 } }
