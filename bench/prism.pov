// bench: +W640 +H480 -A; prisms of 60 to 300 points
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <-8, 12, -10> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
camera { location <0, 9, -12> look_at 0 angle 40 }
#for (K, 0, 11)
  #local N = 60 + 20*K;
  prism { #if (mod(K, 2)) cubic_spline #else linear_spline #end 0, 0.7, N + 1 + 2*mod(K, 2),
    #for (I, -mod(K, 2), N + mod(K, 2))
      #local A = I*2*pi/N;
      #local S = 0.8 + 0.15*sin(12*A);
      #if (I = N) #local A = 0; #local S = 0.8; #end
      <S*cos(A), S*sin(A)>
    #end
    pigment { rgb <0.9, 0.6, 0.3> } translate <mod(K, 4)*2 - 3, 0, floor(K/4)*2 - 2> }
#end
plane { y, 0 pigment { rgb 0.7 } }
