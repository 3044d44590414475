// golden: +W96 +H72 -A; psnr >= 40; deep mirror images are made of edges
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
// Two mirrors face to face: the image ends after max_trace_level bounces.
camera { location <0.5, 1, -1.6> look_at <-0.3, 0.35, 0.2> angle 95 }
light_source { <0, 3, -1> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
#declare Mirror = texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 0.9 } }
box { <-0.9, 0, -1.5>, <-0.85, 1.2, 1.5> texture { Mirror } }
box { <0.85, 0, -1.5>, <0.9, 1.2, 1.5> texture { Mirror } }
sphere { <0, 0.3, 0.2>, 0.3 pigment { rgb <0.9, 0.6, 0.2> } }
box { <-0.6, 0, 0.8>, <0.6, 0.5, 0.9> pigment { rgb <0.8, 0.3, 0.3> } }
box { <-0.9, -0.1, -1.5>, <0.9, 0, 1.5> pigment { checker rgb 0.8, rgb 0.3 scale 0.3 } }
