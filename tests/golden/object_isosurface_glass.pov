// golden: +W96 +H72 -A; psnr >= 40; refraction magnifies that the oracle's roots lie behind ours
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
// Seen through, and from inside out to the container.
camera { location <0, 2, -5> look_at 0 angle 40 }
light_source { <-4, 6, -6> rgb 1 }
isosurface {
  function { y + 0.1*sin(6*x) + 0.1*cos(5*z) }
  contained_by { box { -0.9, <0.9, 0.6, 0.9> } } max_gradient 1.5 accuracy 0.0002 max_trace 3
  rotate 25*y translate <-1, 0.1, 0>
  pigment { rgbt <0.8, 0.9, 1, 0.85> } interior { ior 1.2 }
}
isosurface {
  function { x*x + y*y + z*z - 0.6 + 0.1*cos(8*y) } max_gradient 4 accuracy 0.0002
  translate <1, 0, 0>
  pigment { rgb <0.5, 0.3, 0.3> } finish { reflection 0.5 }
}
plane { y, -1 pigment { checker rgb 0.9 rgb <0.3, 0.3, 0.5> scale 0.5 } }
