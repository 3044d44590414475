// The standard includes: logo.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "logo.inc"
#macro Through(O)
  #for (J, 0, 4) #for (I, 0, 4)
    #local N = <0, 0, 0>; #local P = trace(O, <-0.51 + I * 0.25, -0.52 + J * 0.25, -5>, z, N);
    #if (vlength(N) = 0) #debug ". " #else #debug concat(str(P.z, 0, 3), " ") #end
  #end #debug "\n" #end
#end

//= Povray_Logo
Through(Povray_Logo)
// expect: . -0.069 . . .
// expect: . -0.121 . . .
// expect: . -0.072 -0.169 -0.167 -0.078
// expect: . . -0.187 -0.143 .
// expect: . . -0.200 -0.161 .

//= Povray_Logo_Prism
Through(Povray_Logo_Prism)
// expect: . -0.125 . . .
// expect: . -0.125 . . .
// expect: . -0.125 -0.125 -0.125 -0.125
// expect: . . -0.125 -0.125 .
// expect: . . -0.125 -0.125 .

//= Povray_Logo_Bevel
Through(Povray_Logo_Bevel)
// expect: . -0.031 . . .
// expect: . -0.083 . . .
// expect: . -0.016 -0.057 -0.005 -0.029
// expect: . . -0.084 -0.045 .
// expect: . . -0.100 -0.058 .
