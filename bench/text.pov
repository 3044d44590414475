// bench: +W640 +H480 -A; twenty lines of text
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <-8, 12, -10> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
camera { location <4, 0, -14> look_at <4, 0, 0> angle 50 }
#for (I, 0, 19)
  text { ttf "timrom.ttf" "Sphinx of black quartz, 3.7!" 0.3, 0 pigment { rgb <0.9, 0.6, 0.3> } translate <-1, 5 - I*0.6, 0> }
#end
plane { z, 1 pigment { rgb 0.7 } }
