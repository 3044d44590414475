// bench: +W800 +H600 +A0.3; anti-aliasing: 1,600 little columns, most pixels hold an edge
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <4, 7, -10> look_at <0, 0, 0> angle 44 }
light_source { <-8, 12, -6> rgb 1 }
background { rgb <0.6, 0.7, 0.9> }
#for (I, -20, 19)
  #for (K, -20, 19)
    cone { <I, 0, K>*0.25, 0.1, <I, 2 + 2*sin(I*0.5)*cos(K*0.4), K>*0.25, 0.05 pigment { rgb <0.5 + I/50, 0.6, 0.5 + K/50> } finish { phong 0.5 } }
  #end
#end
plane { y, 0 pigment { checker rgb 0.9, rgb 0.5 scale 0.25 } }
