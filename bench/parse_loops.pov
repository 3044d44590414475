// bench: +W8 +H6 -A; (a) the language: 300,000 turns of arithmetic, array access and macro calls
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 50 }
light_source { <-4, 6, -6> rgb 1 }
#macro Step(A, B) #local C = A*1.5 + B*B - floor(A + B); mod(abs(C), 1) #end
#macro Mix(V, W, T) (V*(1 - T) + W*T) #end
#macro Note(Seen, At, P) #declare Seen[At] = Seen[At] + P; #end
#declare Total = 0;
#declare Seen = array[64]
#for (I, 0, 63) #declare Seen[I] = 0; #end
#declare V = <0.1, 0.2, 0.3>;
#declare I = 0;
#while (I < 300)
  #for (K, 0, 999)
    #local P = Step(Total, K*0.001);
    #if (P > 0.5) #declare Total = Total + P; #else #declare Total = Total - P/2; #end
    Note(Seen, mod(K, 64), P)
    #declare V = Mix(V, <P, sin(P), cos(P)>, 0.3);
  #end
  #declare I = I + 1;
#end
sphere { vnormalize(V)*0.3, 0.5 + mod(Seen[5], 1)*0.5 pigment { rgb <mod(Seen[7], 1), 0.5, V.z> } }
