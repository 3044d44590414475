// golden: +W96 +H72 -A; psnr >= 45; bent and mirrored rays magnify last-bit differences at edges
#version 3.7;
global_settings { assumed_gamma 1 }
// Light fades on its way through: distance, power, colour.
camera { location <0, 1.4, -6> look_at <0, -0.1, 0> angle 50 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.5, 0.7, 0.9> }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 phong 0.5 } }
sphere { <-1.9, 0, 0>, 0.85 texture { Clear } interior { ior 1.3 fade_distance 0.6 fade_power 1 } }
sphere { <0, 0, 0>, 0.85 texture { Clear } interior { ior 1.3 fade_distance 0.5 fade_power 2 fade_color <0.9, 0.4, 0.1> } }
box { <1.2, -0.85, -0.6>, <2.6, 0.6, 0.6> texture { Clear } interior { fade_distance 0.4 fade_power 1001 fade_color <0.2, 0.7, 0.4> } }
box { <-4, -1.2, -4>, <4, -0.9, 3> pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.7> scale 0.6 } }
