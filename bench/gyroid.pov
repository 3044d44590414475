// bench: +W2400 +H1800 -A; a gyroid of six cells a side, cut by its box
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <3, 3.5, -7> look_at 0 angle 32 }
light_source { <6, 10, -8> rgb 1 }
background { rgb <0.6, 0.7, 0.8> }
isosurface {
  function { sin(12*x)*cos(12*y) + sin(12*y)*cos(12*z) + sin(12*z)*cos(12*x) }
  contained_by { box { -1.5, 1.5 } }
  max_gradient 24
  pigment { rgb <0.9, 0.5, 0.2> }
  finish { phong 0.4 }
}
