// bench: +W640 +H480 -A; a blob of 400 balls
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <-8, 12, -10> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
camera { location <0, 1, -9> look_at 0 angle 40 }
#declare R = seed(7);
blob { threshold 0.5
  #for (I, 1, 400)
    sphere { <rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>*<6, 4, 4>, 0.3 + 0.3*rand(R), 1 }
  #end
  pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.5 }
}
plane { y, -2.5 pigment { rgb 0.7 } }
