// golden: +W96 +H72 -A; psnr >= 50; the camera counts as outside of what is endless beyond the box of its surface
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.1 } }
camera { location <0, 1.2, -5> look_at 0 angle 50 }
light_source { <-4, 6, -7> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -1.1 pigment { checker rgb 0.6 rgb 0.2 } finish { reflection { 0.05, 1 fresnel on } } hollow }
#declare Dense = interior { ior 1.4 }
disc { 1.4*x, <-1, 0.7, 1>, 0.6 pigment { rgb <1, 0.4, 0.2> } interior { Dense } }
union {
  union { box { -0.4, 0.4 } sphere { 0.3*y, 0.4 } inverse }
  sphere { <0, 0.9, 0>, 0.2 }
  translate -1.2*x rotate 20*y
  pigment { rgb <0.3, 0.8, 0.4> }
  interior { Dense }
}
intersection {
  torus { 0.4, 0.15 }
  plane { -y, 0 }
  inverse
  rotate -60*x
  pigment { rgb <0.9, 0.8, 0.3> }
  interior { Dense }
}
