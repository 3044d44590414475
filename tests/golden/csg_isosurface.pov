// golden: +W96 +H72 -A; psnr >= 42; the oracle's roots lie up to one accuracy behind ours
#version 3.7;
global_settings { assumed_gamma 1 }
// As operand and as cutter, inverted, clipped; with all crossings asked for, as the oracle needs it.
camera { location <0, 2.8, -6> look_at 0 angle 46 }
light_source { <-4, 6, -6> rgb 1 }
#declare Ball = isosurface {
  function { sqrt(x*x + y*y + z*z) - 0.8 - 0.08*sin(12*y) }
  contained_by { box { -1, 1 } } max_gradient 2 accuracy 0.0005 all_intersections
}
difference {
  object { Ball }
  sphere { <0.4, 0.4, -0.6>, 0.6 pigment { rgb <0.9, 0.8, 0.3> } }
  rotate 20*y translate <-1.9, 0, 0> pigment { rgb <0.9, 0.5, 0.2> }
}
difference {
  box { -0.8, 0.8 }
  object { Ball scale 0.9 translate <0.5, 0.6, -0.6> pigment { rgb <0.9, 0.3, 0.6> } }
  rotate 20*y translate <0, -0.1, 0.4> pigment { rgb <0.3, 0.8, 0.4> }
}
intersection {
  object { Ball }
  plane { z, 0.1 rotate 30*y }
  plane { y, 0.5 }
  translate <1.9, 0, 0> pigment { rgb <0.4, 0.5, 0.9> }
}
object { Ball clipped_by { plane { -z, 0.2 } } scale 0.5 translate <0.9, -0.6, -1.4>
  pigment { rgb <0.7, 0.7, 0.8> } }
plane { y, -1 pigment { rgb 0.75 } }
