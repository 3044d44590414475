// golden: +W96 +H72 -A; psnr >= 50; a hierarchy must find what a list of objects finds
#version 3.7;
global_settings { assumed_gamma 1 }
// A few hundred objects of several kinds: the hierarchy must not lose any.
camera { location <0, 7, -9> look_at <0, -0.2, 0> angle 44 }
light_source { <-6, 9, -6> rgb 1 }
#for (I, -7, 7)
  #for (K, -7, 7)
    #local C = pigment { rgb <0.5 + I/16, 0.5 + K/16, 0.6> }
    #switch (mod(I + 2*K + 28, 4))
      #case (0) sphere { <I, 0, K>*0.5, 0.22 pigment { C } } #break
      #case (1) box { -0.17, 0.17 rotate 40*I*y translate <I, 0, K>*0.5 pigment { C } } #break
      #case (2) cone { <I, -0.4, K>*0.5, 0.2, <I, 0.6, K>*0.5, 0 pigment { C } } #break
      #else torus { 0.16, 0.06 rotate 30*K*x translate <I, 0, K>*0.5 pigment { C } }
    #end
  #end
#end
plane { y, -0.3 pigment { rgb 0.8 } }
