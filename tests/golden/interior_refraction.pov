// golden: +W96 +H72 -A; psnr >= 45; bent and mirrored rays magnify last-bit differences at edges
#version 3.7;
global_settings { assumed_gamma 1 }
// Glass ball, water in a bowl's shape, a prism: what stands behind is bent.
camera { location <0, 1.6, -6> look_at <0, -0.1, 0> angle 56 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.5, 0.7, 0.9> }
#declare Clear = texture { pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 phong 0.6 } }
sphere { 0, 0.9 texture { Clear } interior { ior 1.5 } translate -1.5*x }
intersection { sphere { 0, 0.9 } plane { y, 0.1 } texture { Clear } interior { ior 1.33 } translate 0.5*x }
box { -0.5, 0.5 rotate <0, 35, 0> texture { Clear } interior { ior 1.8 } translate <1.9, -0.3, -0.3> }
box { <-4, -1.2, -4>, <4, -0.9, 3> pigment { checker rgb 0.9, rgb <0.7, 0.3, 0.2> scale 0.6 } }
cylinder { <-3, 0.5, 2>, <3, 0.5, 2>, 0.2 pigment { rgb <0.3, 0.6, 0.3> } }
