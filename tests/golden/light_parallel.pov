// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// Parallel rays: equal shadows; the part behind the lamp's plane is lit without shadow.
camera { location <0, 4, -6> look_at <0, 0.2, 0> angle 44 }
light_source { <-4, 5, -2> rgb 0.8 parallel point_at 0 }
light_source { <1.2, 0.8, -0.5> rgb <0.3, 0.2, 0.1> parallel point_at <1.2, -1, -0.7> }
#for (I, -2, 2) cylinder { <I, 0, 0.5>, <I, 1.1, 0.5>, 0.15 pigment { rgb <0.9, 0.7, 0.4> } } #end
sphere { <0.5, 0.4, -0.9>, 0.4 pigment { rgb <0.4, 0.6, 0.9> } }
plane { y, 0 pigment { rgb 0.8 } }
