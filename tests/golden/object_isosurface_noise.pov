// golden: +W96 +H72 -A; psnr >= 42; steep small detail, and roots up to one accuracy apart
#version 3.7;
#declare f_ridged_mf = function { internal(59) }
#declare f_sphere = function { internal(61) }
#declare f_torus = function { internal(70) }
#declare f_noise3d = function { internal(76) }
#declare f_snoise3d = function { 2*f_noise3d(x, y, z) - 1 }
global_settings { assumed_gamma 1 }
// Noise, sums of noise and other built-in shapes.
camera { location <0, 2.8, -6> look_at <0, -0.1, 0> angle 46 }
light_source { <-4, 6, -6> rgb 1 }
isosurface {
  function { f_sphere(x, y, z, 0.75) - 0.25*f_noise3d(5*x, 5*y, 5*z) }
  max_gradient 3 accuracy 0.0005 translate <-1.9, 0, 0> pigment { rgb <0.9, 0.5, 0.2> }
}
isosurface {
  function { y - 0.25*f_ridged_mf(x*2, y*2, z*2, 0.6, 2, 4, 0.8, 0.9, 1) }
  max_gradient 6 accuracy 0.0005 translate <0, -0.4, 0> pigment { rgb <0.3, 0.8, 0.4> }
}
isosurface {
  function { f_torus(x, z, y, 0.6, 0.2) - 0.1*f_snoise3d(6*x, 6*y, 6*z) }
  max_gradient 3 accuracy 0.0005 rotate 30*x translate <2, 0, 0> pigment { rgb <0.4, 0.5, 0.9> }
}
plane { y, -1 pigment { rgb 0.75 } }
