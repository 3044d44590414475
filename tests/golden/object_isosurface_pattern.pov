// golden: +W96 +H72 -A; psnr >= 42; sampled as the oracle samples, with roots refined
#version 3.7;
global_settings { assumed_gamma 1 }
// Functions with patterns and pigments, which nothing bounds but max_gradient.
camera { location <0, 2.8, -6> look_at <0, -0.1, 0> angle 46 }
light_source { <-4, 6, -6> rgb 1 }
#declare Bumpy = function { pattern { bumps scale 0.3 } }
#declare Coloured = function { pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } scale 0.4 triangle_wave } }
isosurface {
  function { x*x + y*y + z*z - 0.5 + 0.3*Bumpy(x, y, z) }
  max_gradient 5 accuracy 0.0005 translate <-1.2, 0, 0> pigment { rgb <0.9, 0.5, 0.2> }
}
isosurface {
  function { sqrt(x*x + z*z) - 0.4 - 0.3*Coloured(x, y, z).red }
  max_gradient 3 accuracy 0.0005 translate <1.2, 0, 0> pigment { rgb <0.4, 0.5, 0.9> }
}
plane { y, -1 pigment { rgb 0.75 } }
