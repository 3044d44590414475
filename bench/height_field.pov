// bench: +W640 +H480 -A; a height field of 1024 by 1024 points
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <-8, 12, -10> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
camera { location <0.5, 0.5, -0.6> look_at <0.5, 0, 0.4> angle 60 }
height_field { function 1024, 1024 { 0.4 + 0.2*sin(25*x + 3*sin(13*y))*cos(21*y) + 0.05*sin(160*x)*sin(140*y) }
  smooth pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.5 } scale <1, 0.3, 1> }
