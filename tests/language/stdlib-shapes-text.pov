// The standard includes: text in shapes.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
// needs: timrom.ttf
#include "shapes.inc"
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

//= Text_Width
#debug concat(str(Text_Width("timrom.ttf", "Hello", 1, 0), 0, 9), "\n")
#debug concat(str(Text_Width("timrom.ttf", "ab", 2, 0.1), 0, 9), "\n")
// expect: 2.221029747
// expect: 1.970059606

//= Text_Space
#debug concat(str(Text_Space("timrom.ttf", "Hello", 1, 0), 0, 9), "\n")
#debug concat(str(Text_Space("timrom.ttf", "A b", 2, 0.1), 0, 9), "\n")
// expect: 2.273000400
// expect: 3.620000504

//= Bevelled_Text
#declare O = object { Bevelled_Text("cyrvetic.ttf", "aB", 4, 35, 0.1, 0.5, 0, false) }
Probe(O, <0.013,0.012,0.017>, <1.104,0.718,0.486>, 4)
#declare O = object { Bevelled_Text("cyrvetic.ttf", "H", 8, 30, 0.05, 0.3, 0.1*x, true) }
Probe(O, <0.013,0.022,0.017>, <0.544,0.718,0.286>, 4)
// expect: . 0.009 0.070 0.112 . 0.047 0.053 0.588
// expect: 0.047 -0.008 0.070 0.074 . 0.030 . 0.571
// expect: 0.065 -0.008 . 0.074 . 0.030 0.035 0.571
// expect: . -0.008 . 0.074 . 0.030 0.018 0.571
// expect: -0.001 -0.013 . -0.013 . -0.013 0.006 -0.013
// expect: -0.001 -0.013 . -0.013 . -0.013 0.006 -0.013
// expect: -0.001 -0.013 . -0.013 . -0.013 0.006 -0.013
// expect: -0.001 -0.013 . -0.013 . -0.013 0.006 -0.013

//= Circle_Text, Align_Left
#declare O = object { Circle_Text("timrom.ttf", "ABc", 1, 0.1, 0.3, 3, false, Align_Left, 70) } Box(O)
// expect: 1.0355 1.5472 -0.0000 | 2.9592 3.4596 0.3000

//= Circle_Text, Align_Right
#declare O = object { Circle_Text("timrom.ttf", "ABc", 1, 0.1, 0.3, 3, false, Align_Right, 70) } Box(O)
// expect: -1.1208 2.8155 -0.0000 | 1.1595 3.6926 0.3000

//= Circle_Text, Align_Center
#declare O = object { Circle_Text("timrom.ttf", "ABc", 1, 0.1, 0.3, 3, false, Align_Center, 70) } Box(O)
// expect: 0.0307 2.3134 -0.0000 | 2.1840 3.7123 0.3000

//= Circle_Text, Align_Left, inverted
#declare O = object { Circle_Text("timrom.ttf", "ABc", 1, 0.1, 0.3, 3, true, Align_Left, 70) } Box(O)
// expect: -1.1587 2.8409 -0.0000 | 1.1883 3.7050 0.3000

//= Circle_Text, Align_Right, inverted
#declare O = object { Circle_Text("timrom.ttf", "ABc", 1, 0.1, 0.3, 3, true, Align_Right, 70) } Box(O)
// expect: 1.1198 1.5626 -0.0000 | 3.1348 3.4713 0.3000

//= Circle_Text, Align_Center, inverted
#declare O = object { Circle_Text("timrom.ttf", "ABc", 1, 0.1, 0.3, 3, true, Align_Center, 70) } Box(O)
// expect: 0.0459 2.3350 -0.0000 | 2.2924 3.7102 0.3000

//= Circle_Text_Valigned
#declare O = object { Circle_Text_Valigned("timrom.ttf", "ABc", 1, 0, 0.3, 3, false, Align_Center, 90, 30) } Box(O)
// expect: -1.0193 2.7125 -0.0050 | 1.0029 3.6094 0.6078
