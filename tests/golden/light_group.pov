// golden: +W96 +H72 -A; psnr >= 50; the samples of the grid are where the oracle has them
#version 3.7;
global_settings { assumed_gamma 1 }
// Lamps for some things alone.
light_source { <-3, 4, -3> rgb 0.4 }
light_group {
  light_source { <3, 4, -3> rgb <0.2, 0.9, 0.3> }
  sphere { <-0.3, 0.4, -1.2>, 0.4 pigment { rgb 0.9 } }
  union { box { <-2.2, 0, -0.4>, <-1.7, 0.8, 0> } sphere { <-1.95, 1, -0.2>, 0.2 } pigment { rgb 0.9 } }
  light_group {
    light_source { <0, 4, -4> rgb <0.8, 0.2, 0.3> }
    sphere { <0.3, 0.3, -1.8>, 0.3 pigment { rgb 0.9 } finish { specular 0.6 } }
  }
}
light_group {
  light_source { <0, 3, -4> rgb <0.2, 0.3, 0.9> }
  sphere { <1.2, 0.3, -1>, 0.3 pigment { rgb 0.9 } }
  global_lights on
  translate <0.1, 0.1, 0>
}
camera { location <0, 3, -5> look_at <0, 0.3, 0.4> angle 50 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <-0.9, 0.5, 0.2>, 0.5 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.7 } }
box { <0.4, 0, -0.4>, <0.9, 1, 0.3> pigment { rgb <0.4, 0.6, 0.9> } rotate y * 20 }
cylinder { <1.6, 0, 1>, <1.6, 1.6, 1>, 0.1 pigment { rgb 0.7 } }
light_group {
  light_source { <4, 5, -2> rgb <0.3, 0.2, 0> }
  light_group { sphere { <-1.3, 0.15, -1.6>, 0.15 pigment { rgb 0.9 } } }
  light_group { light_source { <-4, 5, -2> rgb <0, 0.2, 0.3> } sphere { <-0.9, 0.15, -1.9>, 0.15 pigment { rgb 0.9 } } }
  global_lights on
}
