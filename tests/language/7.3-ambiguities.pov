// Language §7.3: ambiguities.
#version 3.7;
global_settings { assumed_gamma 1 }

//= 1: < after an operand is a vector in additive places
box { 0 <1,1,1> } sphere { <0,0,0> 1 }
#debug concat("fine", "\n")
// expect: fine

//= 2: > closes
#debug concat(vstr(3, <(2>1),0,0>, ",", 0, 3), "\n")
#debug concat(vstr(3, <1,2,(3>4)>, ",", 0, 3), "\n")
// expect: 1.000,0.000,0.000
// expect: 1.000,2.000,0.000

//= 3: a sign continues
#debug concat(vstr(2, <1,2 -3>, ",", 0, 3), "\n")
// expect: 1.000,-1.000

//= 4: a parenthesis after a keyword parameter
camera { angle (30) } sphere { 0, 1 hollow (1=1) }
#debug concat("fine", "\n")
// expect: fine

//= 5: names of functions and splines alone
#declare F = function(X) { X } #declare G = F; #declare S = spline { 0, 1 } #declare T = S;
#debug concat(str(G(3), 0, 0), "\n")
#debug concat(str(T(0).x, 0, 0), "\n")
// expect: 3
// expect: 1

//= 6, 7: brackets after names in maps
#declare A = rgb 1; #declare B = rgb 0; sphere { 0, 1 pigment { gradient x color_map { [0 A][0.5 B][1 A] } } }
#debug concat("fine", "\n")
// expect: fine

//= 8: textures in a row are layers
#declare T = texture { pigment { rgb 1 } } texture { pigment { rgbt 1 } } sphere { 0, 1 texture { T } texture { pigment { rgbt 1 } } }
#debug concat("fine", "\n")
// expect: fine

//= 9: a second rgb begins another colour
#declare A = array[2] { rgb 1 rgb 0 }
#debug concat(vstr(3, A[0], ",", 0, 3), "\n")
#debug concat(vstr(3, A[1], ",", 0, 3), "\n")
// expect: 1.000,1.000,1.000
// expect: 0.000,0.000,0.000

//= 10: colour words continue the colour
#declare C = rgb 1 red 0.5;
#debug concat(vstr(3, C, ",", 0, 3), "\n")
// expect: 0.500,1.000,1.000

//= 13: default without its sign
default { pigment { rgb 1 } }
#debug concat("fine", "\n")
// expect: fine

//= 15: a double entry of a map
sphere { 0, 1 pigment { gradient x color_map { [0 0.5 color rgb 1 color rgb 0] [0.5 1 color rgb 0 color rgb 1] } } }
#debug concat("fine", "\n")
// expect: fine

//= 17: a digit after the point makes a number
#declare A = 5; #declare W = array[2] { A .5 }
#debug concat(str(W[0], 0, 1), "\n")
#debug concat(str(W[1], 0, 1), "\n")
// expect: 5.0
// expect: 0.5

//= 21: a macro as operand of a keyword
#macro M() 2 #end #declare O = sphere { 0, 1 scale M() translate M()*x }
#debug concat(vstr(3, max_extent(O), ",", 0, 3), "\n")
// expect: 4.000,2.000,2.000

//= 22: names first in finish
#declare I = finish { phong 1 } sphere { 0, 1 finish { I ambient 0.2 } }
#debug concat("fine", "\n")
// expect: fine

//= 11: filter of a colour
#declare C = rgb 1 filter 0.5; #debug concat(str(C.filter, 0, 2), "\n")
// expect: 0.50

//= 12: words that are many things
sphere { 0, 1 interior { ior 1 } normal { bumps } pigment { gradient x } finish { reflection { 0.5 falloff 1 } } } light_source { 0, rgb 1 spotlight falloff 30 point_at x } #debug "fine\n"
// expect: fine

//= 14: a sign after a key subtracts
#declare X = 0.2; sphere { 0, 1 pigment { gradient x color_map { [0.5 -X rgb 1] [1 rgb 0] } } } #debug "fine\n"
// expect: fine

//= 16: types of splines as arguments
#declare S = spline { 0, 1 1, 2 2, 9 } #debug concat(vstr(2, S(0.5, cubic_spline), ",", 0, 3), "\n")
// expect: 2.000,2.000

//= 19: everything is an object
#declare L = light_source { 0, rgb 1 } #declare U = union { sphere { 0, 1 } light_source { 0, rgb 1 } } object { L } object { U } #debug "fine\n"
// expect: fine

//= 21: macros as operands of keywords
#macro M() 2 #end #declare O = sphere { 0, 1 scale M() translate M() } #debug concat(vstr(3, max_extent(O), ",", 0, 0), "\n")
// expect: 4,4,4

//= 22: names before keywords in finishes
#declare F = finish { phong 1 } sphere { 0, 1 finish { F } } #debug "fine\n"
// expect: fine

//= 22: but not after them
#declare F = finish { phong 1 } sphere { 0, 1 finish { ambient 1 F } }
// beyond

//= 18: case in an if in a switch
#switch (1) #case (1) #if (1) #debug "in " #end #break #case (2) #debug "no" #end #debug "out\n"
// expect: in out
