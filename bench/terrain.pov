// bench: +W800 +H600 -A; an isosurface of four octaves of noise, at a low angle
#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -6> look_at <0, 0.2, 0> angle 45 }
light_source { <-6, 6, -3> rgb 1 }
background { rgb <0.6, 0.7, 0.8> }
isosurface {
  function {
    y - 0.8*f_noise3d(x, 0, z) - 0.4*f_noise3d(2*x, 3, 2*z)
      - 0.2*f_noise3d(4*x, 7, 4*z) - 0.1*f_noise3d(8*x, 9, 8*z)
  }
  contained_by { box { <-4, -0.1, -4>, <4, 1.6, 4> } }
  max_gradient 4
  pigment { rgb <0.5, 0.6, 0.3> }
}
