// The standard includes: makegrass.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "makegrass.inc"
// Distances at which rays along z and x meet an object, on a grid over a box: `.` where they miss it.
#macro Probe(O, L, H, N)
  #for (J, 0, N - 1) #for (I, 0, N - 1)
    #local U = (I + 0.5) / N; #local V = (J + 0.5) / N;
    #local M = <0,0,0>; #local P = trace(O, <L.x + (H.x - L.x) * U, L.y + (H.y - L.y) * V, L.z - 1>, z, M);
    #if (vlength(M) = 0) #debug ". " #else #debug concat(str(P.z - L.z, 0, 3), " ") #end
    #local M = <0,0,0>; #local P = trace(O, <L.x - 1, L.y + (H.y - L.y) * U, L.z + (H.z - L.z) * V>, x, M);
    #if (vlength(M) = 0) #debug ". " #else #debug concat(str(P.x - L.x, 0, 3), " ") #end
  #end #debug "\n" #end
#end
// Which points of a grid are inside an object, in a given box.
#macro Fill(O, L, H, N)
  #for (J, 0, N - 1) #for (K, 0, N - 1) #for (I, 0, N - 1)
    #debug #if (inside(O, L + (H - L) * <I + 0.51, J + 0.52, K + 0.53> / N)) "#" #else "." #end
  #end #end #debug "\n" #end
#end
#macro Box(O) #debug concat(vstr(3,min_extent(O)," ",0,4)," | ",vstr(3,max_extent(O)," ",0,4),"\n") #end

//= MakeBlade
#declare O = mesh { MakeBlade(true, <0,0,0>, 20, 5, 10, 1, 0.1, 0.5, <0,1,0.3>, <0,-1,2>, 1, true, false) }
Probe(O, <-0.927,0.022,-0.323>, <3.414,4.208,9.186>, 5)
#declare N = <0,0,0>; #declare P = trace(O, <0.2,1,-50>, z, N); #debug concat(vstr(3, P, " ", 0, 5), "\n") #debug concat(vstr(3, N, " ", 0, 5), "\n")
#declare O = mesh { MakeBlade(false, <1,2,3>, 90, 2, 10, 1, .1, .5, <0,1,.3>, <0,0,1>, 1, false, false) }
Probe(O, <1.013,2.022,2.017>, <9.884,13.218,3.986>, 5)
Box(O)
// expect: 0.929 0.626 0.886 1.795 . . . . . .
// expect: 1.334 . 1.432 . . . . . . .
// expect: . . 1.836 . . . . . . .
// expect: . . 2.241 . 1.727 . . . . .
// expect: . . 3.385 . 3.357 . . . . .
// expect: 0.20000 1.00000 0.95510
// expect: -0.23807 0.52300 -0.81841
// expect: . 0.596 . 1.789 . . . . . .
// expect: . 0.596 . 1.789 . 2.983 . 4.176 . .
// expect: . 0.596 . 1.789 . 2.983 . 4.176 . 7.009
// expect: . 0.596 . 1.789 . 2.983 . 4.176 . .
// expect: . 0.596 . 1.789 . . . . . .
// expect: 1.0000 2.0000 2.0000 | 9.8990 13.2246 4.0000

//= MakeGrassPatch
#declare O = object { MakeGrassPatch(10, 3, 60, 4, 15, 1, 0.3, true, <0,1,0.3>, <0,-1,2>, 3, 18264, 1, 360, 3, 0.1, true, false, "") }
Probe(O, <-15.227,0.022,-31.293>, <12.294,30.888,12.356>, 5)
Box(O)
// expect: . . . . 29.243 . 28.757 . . .
// expect: . . . . 31.159 . 23.318 . . .
// expect: . . . 21.108 . 17.948 20.756 20.548 . .
// expect: . . . 14.848 . . 21.332 . . .
// expect: . . . . . . . . . .
// expect: -15.2345 0.0000 -31.3061 | 12.3076 30.8959 12.3736

//= MakeGrassPatch into a file
MakeGrassPatch(10, 3, 60, 4, 15, 1, 0.3, true, <0,1,0.3>, <0,-1,2>, 3, 18264, 1, 360, 3, 0.1, true, true, "g.inc")
#declare O = #include "g.inc"
Box(O)
// expect: -15.2345 0.0000 -31.3061 | 12.3076 30.8959 12.3736

//= MakePrairie
#declare G = box { <-20,0,-20>, <20,10,20> }
#declare O = object { MakePrairie(50, 3, 1, 2, G, 779, 1, 1, false) } Box(O)
// expect: -118.0083 0.0000 -54.9614 | 105.9149 19.5651 102.9745
