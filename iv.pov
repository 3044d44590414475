#version 3.7; global_settings{assumed_gamma 1}
camera{orthographic location -5*z look_at 0 right .001*x up .001*y}
background{rgb 1}
light_source{<0,1000,0> 1 spotlight point_at <0,0,0> radius 0.05 falloff degrees(atan2(1,1000))}

plane{z,5 inverse pigment{rgb 1} finish{ambient 1 diffuse 0} hollow}
media{absorption .5 intervals 13 ratio 0.2 density{function{select((z-1.0001)*(4.9999-z),0,(z-1.0001)/3.9998)}}}
