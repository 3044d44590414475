// bench: +W640 +H480 -A; twelve surfaces of revolution
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <-8, 12, -10> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
camera { location <0, 5, -12> look_at <0, 0.8, 0> angle 40 }
#for (I, 0, 11)
  sor { 9, <0.6, -0.2>, <0.7, 0>, <0.9, 0.2>, <0.4, 0.6>, <0.8, 1>, <0.3, 1.4>, <0.5, 1.8>, <0.2, 2>, <0.1, 2.2>
    pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.5 } translate <mod(I, 4)*2 - 3, 0, floor(I/4)*2 - 2> }
#end
plane { y, 0 pigment { rgb 0.7 } }
