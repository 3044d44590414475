// bench: +W320 +H240 +A0.3; two area lights over mixed primitives
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, 0.6, 0> angle 45 }
light_source { <-6, 8, -5> rgb 0.7 area_light <2.5, 0, 0>, <0, 0, 2.5>, 9, 9 adaptive 1 jitter }
light_source { <7, 6, -3> rgb <0.5, 0.45, 0.4> area_light <1, 1, 0>, <0, 0.5, 2>, 5, 5 }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.5, 0.55, 0.6> } }
#declare R = seed(7);
#for (I, 0, 219)
  #declare P = <8 * rand(R) - 4, 0, 7 * rand(R) - 3>;
  #declare S = 0.12 + 0.2 * rand(R);
  #switch (mod(I, 6))
    #case (0) sphere { P + y * S, S #break
    #case (1) box { -S, S rotate y * 360 * rand(R) translate P + y * S #break
    #case (2) cylinder { P, P + y * 5 * S, S / 3 #break
    #case (3) cone { P, S, P + y * 3 * S, 0 #break
    #case (4) torus { S, S / 3 rotate x * 90 * rand(R) translate P + y * S * 1.4 #break
    #else difference { box { -S, S } sphere { 0, S * 1.25 } translate P + y * S
  #end
    pigment { rgb <0.4 + 0.5 * rand(R), 0.4 + 0.5 * rand(R), 0.5> } finish { phong 0.5 } }
#end
