// golden: +W96 +H72 -A; psnr >= 45; the oracle's roots lie up to one accuracy behind ours
#version 3.7;
global_settings { assumed_gamma 1 }
// Where the container cuts: closed and open, box and sphere.
camera { location <0, 3.2, -6> look_at <0, -0.1, 0> angle 46 }
light_source { <-4, 6, -6> rgb 1 }
#declare Wave = function(x, y, z) { y + 0.3*sin(4*x) + 0.3*cos(4*z) }
isosurface {
  function { Wave(x, y, z) } max_gradient 2 accuracy 0.0005
  contained_by { box { -0.8, 0.8 } }
  rotate 20*y translate <-1.8, 0, 0> pigment { rgb <0.9, 0.5, 0.2> }
}
isosurface {
  function { Wave(x, y, z) } max_gradient 2 accuracy 0.0005 open
  contained_by { sphere { 0, 0.9 } }
  translate <0.1, 0, 0> pigment { rgb <0.3, 0.8, 0.4> }
}
isosurface {
  function { abs(Wave(x, y, z)) - 0.1 } max_gradient 2 accuracy 0.0005 open
  contained_by { box { <-0.8, -0.9, -0.8>, 0.8 } }
  rotate -25*y translate <2, 0, 0> pigment { rgb <0.4, 0.5, 0.9> }
}
plane { y, -1 pigment { rgb 0.75 } }
