// golden: +W96 +H72 -A; psnr >= 45; bent and mirrored rays magnify last-bit differences at edges
#version 3.7;
global_settings { assumed_gamma 1 }
// Inside a 45-degree prism light turns the corner; beyond the critical angle nothing leaves.
camera { location <0.5, 1.2, -5> look_at <0, 0, 0> angle 56 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.6, 0.7, 0.9> }
intersection {
  plane { -z, 0.8 } plane { <1, 0, 1>, 0.6 } plane { <-1, 0, 1>, 0.6 } plane { y, 0.7 } plane { -y, 0.7 }
  pigment { rgbt <0.95, 1, 0.97, 0.97> } finish { ambient 0 diffuse 0 reflection 0.05 } interior { ior 1.6 }
}
sphere { <-1.6, -0.2, -0.6>, 0.5 pigment { rgb <0.9, 0.3, 0.2> } }
sphere { <1.6, -0.2, -0.6>, 0.5 pigment { rgb <0.2, 0.7, 0.3> } }
box { <-4, -1.2, -4>, <4, -0.7, 3> pigment { checker rgb 0.9, rgb 0.4 scale 0.5 } }
