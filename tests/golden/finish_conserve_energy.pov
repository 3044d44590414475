// golden: +W96 +H72 -A; psnr >= 45; bent and mirrored rays magnify last-bit differences at edges
#version 3.7;
global_settings { assumed_gamma 1 }
// What a surface mirrors it does not let through.
camera { location <0, 1.4, -7> look_at <0, -0.1, 0> angle 40 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
#declare Pane = box { <-1, -0.8, 0>, <1, 1, 0.05> pigment { rgbt <1, 1, 1, 0.8> } }
object { Pane finish { reflection 0.6 } rotate 35*y translate -1.2*x }
object { Pane finish { reflection 0.6 conserve_energy } rotate -35*y translate 1.2*x }
sphere { <-1.2, -0.3, 1.6>, 0.5 pigment { rgb <0.9, 0.4, 0.2> } }
sphere { <1.4, -0.3, 1.6>, 0.5 pigment { rgb <0.9, 0.4, 0.2> } }
sphere { <0, -0.5, -1.6>, 0.4 pigment { rgb <0.3, 0.8, 0.4> } }
box { <-3.5, -1, -3.5>, <3.5, -0.9, 2.5> pigment { checker rgb 0.8, rgb <0.35, 0.45, 0.4> } }
