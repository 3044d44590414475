// golden: +W96 +H72 -A; psnr >= 45; the oracle's roots lie up to one accuracy behind ours
#version 3.7;
global_settings { assumed_gamma 1 }
// Smooth, with kinks, with a threshold, moved and stretched.
camera { location <0, 2.8, -6> look_at 0 angle 46 }
light_source { <-4, 6, -6> rgb 1 }
isosurface {
  function { x*x + y*y + z*z + 0.15*sin(9*x)*sin(9*y) }
  threshold 0.6 max_gradient 6 accuracy 0.0005
  rotate 30*y translate <-1.7, 0, 0>
  pigment { rgb <0.9, 0.5, 0.2> } finish { phong 0.5 }
}
isosurface {
  function { max(abs(x) - 0.6, abs(y) - 0.3, min(abs(z) - 0.5, sqrt(x*x + z*z) - 0.3)) }
  max_gradient 1.5 accuracy 0.0005
  rotate <-20, 40, 0> translate <0.3, 0, 0.4>
  pigment { rgb <0.3, 0.8, 0.4> }
}
isosurface {
  function { pow(abs(x), 3) + pow(abs(y), 3) + pow(abs(z), 3) - 0.4 }
  contained_by { sphere { 0, 1 } } max_gradient 5 accuracy 0.0005
  scale <0.8, 1.2, 0.8> rotate 25*z translate <2, 0, 0>
  pigment { rgb <0.4, 0.5, 0.9> }
}
plane { y, -1 pigment { rgb 0.75 } }
