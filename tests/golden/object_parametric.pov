// golden: +W96 +H72 -A; psnr >= 38; the oracle's surface lies up to two accuracies nearer
#version 3.7;
global_settings { assumed_gamma 1 }
// A saddle, a ring with a texture on its surface, a ball cut by its container.
camera { location <0, 2.8, -6> look_at 0 angle 46 }
light_source { <-4, 6, -6> rgb 1 }
parametric {
  function { u } function { u*v } function { v }
  <-0.8, -0.8>, <0.8, 0.8>
  contained_by { box { -1, 1 } } max_gradient 2 accuracy 0.0005 precompute 12 x,y,z
  rotate 30*y translate <-1.9, 0, 0> pigment { rgb <0.9, 0.5, 0.2> }
}
parametric {
  function { cos(u)*(0.7 + 0.25*cos(v)) } function { 0.25*sin(v) }
  function { sin(u)*(0.7 + 0.25*cos(v)) }
  <0, 0>, <2*pi, 2*pi>
  contained_by { sphere { 0, 1.1 } } max_gradient 1.3 accuracy 0.0005 precompute 14 x,y,z
  uv_mapping pigment { checker rgb <0.3, 0.8, 0.4> rgb <0.2, 0.3, 0.6> scale 0.5 }
  rotate -30*x
}
parametric {
  function { 0.8*sin(u)*cos(v) } function { 0.8*sin(v) } function { 0.8*cos(u)*cos(v) }
  <0, -pi/2>, <2*pi, pi/2>
  contained_by { box { -1, <1, 0.5, 1> } } max_gradient 1 accuracy 0.0005 precompute 14 x,y,z
  translate <1.9, 0, 0> pigment { rgb <0.4, 0.5, 0.9> }
}
plane { y, -1 pigment { rgb 0.75 } }
