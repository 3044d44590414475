// Language §7.4: unbalanced bodies of directives.
#version 3.7;
global_settings { assumed_gamma 1 }

//= alternative heads of blocks
#macro M(A) #if (A) merge { #else union { #end sphere { 0, 1 } box { 0, 1 } } #end M(0) M(1)
#debug concat("fine", "\n")
// expect: fine

//= an optional wrapper
#declare C = 1; #declare O = #if (C) union { #end sphere { 0, 1 } #if (C) sphere { x, 1 } } #end
#debug concat(vstr(3, max_extent(O), ",", 0, 3), "\n")
// expect: 2.000,1.000,1.000

//= two levels of heads
#declare A = 1; #declare B = 0; #declare O = #if (A) #if (B) merge { #else union { #end #end sphere { 0, 1 } #if (A) sphere { 2*y, 1 } } #end
#debug concat(vstr(3, max_extent(O), ",", 0, 3), "\n")
// expect: 1.000,3.000,1.000

//= writing or building
#declare W = 0; #if (W) #fopen F "u.txt" write #write (F, "mesh {\n") #else union { #end #for (I, 0, 2) #if (W) #write (F, "x") #else sphere { I*x, 1 } #end #end #if (W) #write (F, "}") #fclose F #else translate x } #end
#debug concat("fine", "\n")
// expect: fine

//= arguments of #write over other directives
#declare W = 1; #fopen F "v.txt" write #if (W) #write (F, "\"a", 1, #else union { #end #for (I, 1, 3) #if (W) "b", #else sphere { 0, I } #end #end #if (W) "c\",") #else } #end #fclose F #fopen F "v.txt" read #read (F, A)
#debug concat(A, "\n")
// expect: a1bbbc

//= an include in a block, a declare in an object
union { #include "spheres.inc" #declare R = 2; sphere { 0, R } }
#debug concat(str(R, 0, 0), "\n")
// expect: 2

//= conditions in vectors, maps and arguments
#declare C = 1; sphere { <1, #if (C) 2 #else 3 #end, 4>, 1 pigment { gradient x color_map { [0 rgb 0] #if (C) [0.5 rgb x] #end #for (I,6,9) [I/10 rgb I/10] #end [1 rgb 1] } } }
#debug concat(str(max(1, #if (C) 5 #else 3 #end), 0, 0), "\n")
// expect: 5
