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
#macro Box(O) #debug concat(vstr(3,min_extent(O)," ",0,3)," | ",vstr(3,max_extent(O)," ",0,3),"\n") #end

//= Text_Width
#debug concat(str(Text_Width("timrom.ttf", "Hello", 1, 0), 0, 4), "\n")
#debug concat(str(Text_Width("timrom.ttf", "HIL", 2, 0.1), 0, 4), "\n")
// expect: 2.2210
// expect: 3.7661

//= Text_Space
#debug concat(str(Text_Space("timrom.ttf", "Hello", 1, 0), 0, 4), "\n")
#debug concat(str(Text_Space("timrom.ttf", "A H", 2, 0.1), 0, 4), "\n")
// expect: 2.2730
// expect: 4.1100

//= Bevelled_Text
#declare O = object { Bevelled_Text("cyrvetic.ttf", "HT", 4, 35, 0.1, 0.5, 0, false) }
Probe(O, <0.013,0.022,0.017>, <1.194,0.718,0.486>, 5)
#declare O = object { Bevelled_Text("cyrvetic.ttf", "H", 8, 30, 0.05, 0.3, 0.1*x, true) }
Probe(O, <0.013,0.022,0.017>, <0.544,0.718,0.286>, 5)
// expect: . 0.012 . 0.012 . 0.012 . 0.012 . 0.012
// expect: . -0.013 . -0.013 . -0.013 . -0.013 . -0.013
// expect: 0.046 -0.013 0.046 -0.013 . -0.013 . -0.013 . -0.013
// expect: . -0.013 . -0.013 . -0.013 . -0.013 . -0.013
// expect: . -0.013 . -0.013 . -0.013 0.068 -0.013 0.068 -0.013
// expect: -0.017 -0.009 . -0.009 . -0.009 . -0.009 -0.017 -0.009
// expect: -0.017 -0.013 . -0.013 . -0.013 . -0.013 -0.017 -0.013
// expect: -0.017 -0.013 -0.012 -0.013 -0.012 -0.013 -0.012 -0.013 -0.017 -0.013
// expect: -0.017 -0.013 . -0.013 . -0.013 . -0.013 -0.017 -0.013
// expect: -0.017 -0.013 . -0.013 . -0.013 . -0.013 -0.017 -0.013

//= Circle_Text, Align_Left
#declare O = object { Circle_Text("timrom.ttf", "HIL", 1, 0.1, 0.3, 3, false, Align_Left, 70) } Box(O)
// expect: 1.035 1.688 -0.000 | 3.021 3.445 0.300

//= Circle_Text, Align_Right
#declare O = object { Circle_Text("timrom.ttf", "HIL", 1, 0.1, 0.3, 3, false, Align_Right, 70) } Box(O)
// expect: -0.938 2.833 -0.000 | 1.199 3.690 0.300

//= Circle_Text, Align_Center
#declare O = object { Circle_Text("timrom.ttf", "HIL", 1, 0.1, 0.3, 3, false, Align_Center, 70) } Box(O)
// expect: 0.108 2.377 -0.000 | 2.218 3.691 0.300

//= Circle_Text, Align_Left, inverted
#declare O = object { Circle_Text("timrom.ttf", "HIL", 1, 0.1, 0.3, 3, true, Align_Left, 70) } Box(O)
// expect: -0.950 2.839 -0.000 | 1.187 3.682 0.300

//= Circle_Text, Align_Right, inverted
#declare O = object { Circle_Text("timrom.ttf", "HIL", 1, 0.1, 0.3, 3, true, Align_Right, 70) } Box(O)
// expect: 1.032 1.692 -0.000 | 3.017 3.445 0.300

//= Circle_Text, Align_Center, inverted
#declare O = object { Circle_Text("timrom.ttf", "HIL", 1, 0.1, 0.3, 3, true, Align_Center, 70) } Box(O)
// expect: 0.107 2.382 -0.000 | 2.210 3.687 0.300

//= Circle_Text_Valigned
#declare O = object { Circle_Text_Valigned("timrom.ttf", "HIL", 1, 0, 0.3, 3, false, Align_Center, 90, 30) } Box(O)
// expect: -0.930 2.749 -0.000 | 0.940 3.599 0.600
