// bench: +W1024 +H768 -A; shading: three layers of patterns on everything, two lamps
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at <0, 0.4, 0> angle 44 }
light_source { <-8, 12, -6> rgb 0.7 }
light_source { <9, 6, -8> rgb <0.3, 0.3, 0.5> }
#declare Stack =
  texture { pigment { brick rgb 0.8, rgb <0.6, 0.3, 0.2> scale 0.06 } finish { specular 0.5 roughness 0.02 } }
  texture { pigment { gradient <1, 2, 0> color_map { [0.3 rgbt 1] [0.3 rgbt <1, 0.9, 0.3, 0.5>] [0.7 rgbt <0.2, 0.5, 0.3, 0.4>] [0.8 rgbt 1] } scale 0.5 } finish { brilliance 2 } }
  texture { pigment { hexagon rgbf <1, 1, 1, 0.9>, rgbf <0.7, 0.9, 1, 0.9>, rgbt 1 scale 0.2 } finish { diffuse 0.5 phong 0.4 reflection 0.1 } }
#for (I, -2, 2)
  sphere { <I*1.4, 0.6, 0>, 0.6 texture { Stack rotate 30*I*z } }
  torus { 0.5, 0.15 rotate 60*x translate <I*1.4, 0.4, -1.6> texture { Stack scale 0.7 } }
  box { -0.5, 0.5 rotate 35*y translate <I*1.4, 0.5, 1.8> texture { Stack } }
#end
plane { y, 0 texture { Stack scale 2 } }
