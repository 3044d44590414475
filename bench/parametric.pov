// bench: +W120 +H90 -A; a ring that three functions draw
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -3.6> look_at <0, -0.1, 0> angle 40 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.6, 0.7, 0.8> }
parametric {
  function { cos(u)*(0.8 + 0.3*cos(v)) } function { 0.3*sin(v) + 0.1*sin(5*u) }
  function { sin(u)*(0.8 + 0.3*cos(v)) }
  <0, 0>, <2*pi, 2*pi>
  contained_by { box { <-1.2, -0.5, -1.2>, <1.2, 0.5, 1.2> } }
  max_gradient 1.5 accuracy 0.002 precompute 12 x,y,z
  pigment { rgb <0.4, 0.5, 0.9> }
}
