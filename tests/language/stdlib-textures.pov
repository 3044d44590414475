// The standard includes: pattern macros of textures.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "textures.inc"

//= Irregular_Bricks_Ptrn
#declare F = function { pattern { Irregular_Bricks_Ptrn(0.1, 1, 0.5, 0.5) } }
#for (I, 0, 7) #local P = <I*0.37, I*0.61, I*0.43>; #debug concat(str(F(P.x, P.y, P.z), 0, 6), " ") #end #debug "\n"
#declare F = function { pattern { Irregular_Bricks_Ptrn(0.05, 2, 0.8, 1.2) } }
#for (I, 0, 7) #local P = <I*0.37, I*0.61, I*0.43>; #debug concat(str(F(P.x, P.y, P.z), 0, 6), " ") #end #debug "\n"
// expect: 0.000000 0.324558 0.782303 0.000000 0.686012 0.406586 0.929462 0.874466
// expect:
// error: D0204 at 3:10

//= Tiles_Ptrn
#declare F = function { pattern { Tiles_Ptrn() } }
#for (I, 0, 7) #local P = <I*0.37, I*0.61, I*0.43>; #debug concat(str(F(P.x, P.y, P.z), 0, 6), " ") #end #debug "\n"
// expect: 0.000000 0.740000 0.440000 0.220000 0.880000 0.100000 0.440000 0.540000

//= Hex_Tiles_Ptrn
#declare F = function { pattern { Hex_Tiles_Ptrn() } }
#for (I, 0, 7) #local P = <I*0.37, I*0.61, I*0.43>; #debug concat(str(F(P.x, P.y, P.z), 0, 6), " ") #end #debug "\n"
// expect: 1.000000 0.382452 0.237402 0.365950 0.015052 0.392005 0.270406 0.328600

//= Star_Ptrn
#declare F = function { pattern { Star_Ptrn(0.5, 5, 1) scale 3 translate <2,2,0> } }
#for (I, 0, 7) #local P = <I*0.37, I*0.61, I*0.43>; #debug concat(str(F(P.x, P.y, P.z), 0, 6), " ") #end #debug "\n"
#declare F = function { pattern { Star_Ptrn(0.7, 7, 1.5) scale 4 translate <2,3,0> } }
#for (I, 0, 7) #local P = <I*0.37, I*0.61, I*0.43>; #debug concat(str(F(P.x, P.y, P.z), 0, 6), " ") #end #debug "\n"
// expect: 0.000000 0.000000 0.000000 1.000000 1.000000 1.000000 0.000000 0.000000
// expect:
// error: D0204 at 3:10
