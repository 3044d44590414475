// bench: +W1024 +H768 +A0.3; 200 spotlights over a row of columns
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -11> look_at <0, 0.8, 0> angle 46 }
light_source { <0, 20, -20> rgb 0.15 }
#for (I, -4, 3)
  #for (K, 0, 24)
    light_source {
      <I + 0.5, 3.5, 0.3*K - 2.8> rgb <0.4 + 0.1*I, 0.5, 0.9 - 0.03*K> / 2
      spotlight radius 4 falloff 9 + mod(K, 5) point_at <I + 0.3, 0, 0.3*K - 3>
    }
  #end
  cylinder { <I + 0.5, 0, 0>, <I + 0.5, 2, 0>, 0.18 pigment { rgb 0.9 } }
  torus { 0.22, 0.08 translate <I + 0.5, 0.08, 0> pigment { rgb <0.8, 0.7, 0.5> } }
  sphere { <I + 0.5, 2.2, 0>, 0.28 pigment { rgb <0.8, 0.7, 0.5> } finish { specular 0.6 } }
#end
plane { y, 0 pigment { rgb 0.9 } }
