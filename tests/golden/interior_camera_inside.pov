// golden: +W96 +H72 -A; psnr >= 45; bent and mirrored rays magnify last-bit differences at edges
#version 3.7;
global_settings { assumed_gamma 1 }
// The camera itself is in the glass.
camera { location <0, 0.6, -2.5> look_at <0, 0.1, 0> angle 70 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.5, 0.7, 0.9> }
box { <-3, -0.2, -4>, <3, 2, -1.5> pigment { rgbt <0.9, 1, 0.95, 1> } finish { ambient 0 diffuse 0 } interior { ior 1.4 } }
sphere { <-0.7, 0.2, 0>, 0.6 pigment { rgb <0.9, 0.4, 0.2> } }
box { <0.2, -0.4, -0.3>, <1, 0.4, 0.5> pigment { rgb <0.3, 0.6, 0.3> } }
plane { y, -0.5 pigment { checker rgb 0.9, rgb 0.4 scale 0.5 } }
