// bench: +W320 +H240 -A; a tangle of cubic, B-spline and straight sweeps
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <-8, 12, -10> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
camera { location <0, 2, -9> look_at 0 angle 45 }
#declare R = seed(3);
#for (K, 0, 5)
  sphere_sweep { #switch (mod(K, 3)) #case (0) cubic_spline #break #case (1) b_spline #break #else linear_spline #end 20
    #for (I, 0, 19) , <rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>*<7, 4, 4>, 0.1 + 0.1*rand(R) #end
    pigment { rgb <0.9, 0.5 + K*0.08, 0.3> } finish { phong 0.5 } }
#end
