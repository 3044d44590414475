// Language §5.1: arrays.
#version 3.7;
global_settings { assumed_gamma 1 }

//= elements of every kind
#declare A = array[2] { 1, 2 } #declare B = array[1] { <1,2,3> } #declare C = array[1] { rgb 1 } #declare D = array[1] { "s" } #declare E = array[1] { <1,2> } #declare G = array[1] { <1,2,3,4> }
#debug concat(str(A[1], 0, 0), "\n")
#debug concat(vstr(3, B[0], ",", 0, 3), "\n")
#debug concat(vstr(5, C[0], ",", 0, 3), "\n")
#debug concat(D[0], "\n")
#debug concat(vstr(2, E[0], ",", 0, 3), "\n")
#debug concat(vstr(4, G[0], ",", 0, 3), "\n")
// expect: 2
// expect: 1.000,2.000,3.000
// expect: 1.000,1.000,1.000,0.000,0.000
// expect: s
// expect: 1.000,2.000
// expect: 1.000,2.000,3.000,4.000

//= elements that are blocks
#declare O = array[2] { sphere { 0, 1 }, box { 0, 2 } } #declare P = array[1] { pigment { rgb 1 } } #declare T = array[1] { texture { pigment { rgb 1 } } }
object { O[0] } sphere { 0, 1 pigment { P[0] } } sphere { 0, 1 texture { T[0] } }
#debug concat("fine", "\n")
// expect: fine

//= functions as elements
#declare A = array[2] { function(X) { X*2 }, function(X) { X*3 } }
#debug concat(str(A[0](2), 0, 0), "\n")
#debug concat(str(A[1](2), 0, 0), "\n")
// expect: 4
// expect: 6

//= one to five dimensions
#declare A = array[2][2] { { 1, 2 }, { 3, 4 } } #declare B = array[1][1][1][1][1] { { { { { 7 } } } } }
#debug concat(str(A[0][1], 0, 0), "\n")
#debug concat(str(A[1][0], 0, 0), "\n")
#debug concat(str(B[0][0][0][0][0], 0, 0), "\n")
#debug concat(str(dimensions(B), 0, 0), "\n")
// expect: 2
// expect: 3
// expect: 7
// expect: 5

//= six dimensions
#declare A = array[1][1][1][1][1][1]
// error: D0302 at 1:14

//= sizes are truncated with a tolerance
#declare A = array[2.9] #declare B = array[2.99999999999]
#debug concat(str(dimension_size(A,1), 0, 0), "\n")
#debug concat(str(dimension_size(B,1), 0, 0), "\n")
// expect: 2
// expect: 3

//= a size of zero
#declare A = array[0]
// error: D0302 at 1:14

//= a negative size
#declare A = array[-1]
// error: D0302 at 1:14

//= no size
#declare A = array { 1, 2 }
// error: D0202 at 1:14

//= too few initialisers
#declare A = array[3] { 1, 2 }
// error: D0202 at 1:30

//= too many initialisers
#declare A = array[1] { 1, 2 }
// error: D0201 at 1:28

//= too few on a level
#declare A = array[2][2] { { 1, 2 }, { 3 } }
// error: D0202 at 1:42

//= a comma at the end
#declare A = array[2] { 1, 2, }
#debug concat(str(A[1], 0, 0), "\n")
// expect: 2

//= subscripts are truncated with a tolerance
#declare A = array[3] { 10, 20, 30 }
#debug concat(str(A[0.9999999999999], 0, 0), "\n")
#debug concat(str(A[1.5], 0, 0), "\n")
#debug concat(str(A[2.9], 0, 0), "\n")
#debug concat(str(A[true], 0, 0), "\n")
// expect: 20
// expect: 20
// expect: 30
// expect: 20

//= a subscript that is too large
#declare R = array[3] { 10, 20, 30 } #declare A = R[3];
// error: D0302 at 1:53

//= a negative subscript
#declare R = array[3] { 10, 20, 30 } #declare A = R[-1];
// error: D0302 at 1:53

//= too few subscripts
#declare R = array[2][2] { { 1, 2 }, { 3, 4 } } #declare A = R[0] + 1;
// error: D0202 at 1:62

//= too many subscripts
#declare R = array[2] { 1, 2 } #declare A = R[0][0];
// error: D0204 at 1:45

//= another type
#declare R = array[2] { 1, "a" }
// error: D0204 at 1:28

//= another type later
#declare R = array[2] #declare R[0] = 1; #declare R[1] = <1,2,3>;
// error: D0204 at 1:51

//= all objects are one type
#declare R = array[2] #declare R[0] = sphere { 0, 1 } #declare R[1] = union { box { 0, 1 } box { 1, 2 } }
#debug concat("fine", "\n")
// expect: fine

//= an element that is not set
#declare R = array[2] #declare A = R[0];
// error: D0301 at 1:36

//= arrays of arrays
#declare R = array[2] { array[2] { 1, 2 }, array[3] { 3, 4, 5 } }
#debug concat(str(R[0][1], 0, 0), "\n")
#debug concat(str(R[1][2], 0, 0), "\n")
#debug concat(str(dimension_size(R[1],1), 0, 0), "\n")
#debug concat(str(dimensions(R), 0, 0), "\n")
// expect: 2
// expect: 5
// expect: 3
// expect: 1

//= rows are copied
#declare Row = array[2] { 1, 2 } #declare R = array[1] { Row } #declare Row[0] = 9;
#debug concat(str(R[0][0], 0, 0), "\n")
#debug concat(str(Row[0], 0, 0), "\n")
// expect: 1
// expect: 9

//= white space before a subscript
#declare R = array [2] { 1, 2 }
#debug concat(str(R [1], 0, 0), "\n")
// expect: 2

//= elements in expressions
#declare R = array[3] { 1, 2, 3 }
#debug concat(str(R[0]+R[1]*R[2], 0, 0), "\n")
#debug concat(str(-R[1], 0, 0), "\n")
#debug concat(str(R[R[0]], 0, 0), "\n")
#debug concat(str(max(R[0],R[2]), 0, 0), "\n")
#debug concat(vstr(3, <R[0],R[1],R[2]>*R[1], ",", 0, 3), "\n")
// expect: 7
// expect: -2
// expect: 2
// expect: 3
// expect: 2.000,4.000,6.000

//= emptied elements keep the type
#declare R = array[2] { 1, 2 } #undef R[0] #declare R[0] = "a";
// error: D0204 at 1:53

//= an array is no number
#declare R = array[2] { 1, 2 } #declare A = R + 1;
// error: D0204 at 1:45

//= elements of @
#declare A = array[2] { @, @ } #debug concat(str(defined(A[1]), 0, 0), "\n")
// each: 1 '<1,2>' '<1,2,3>' '<1,2,3,4>' 'rgb 1' '"s"' 'sphere { 0, 1 }' 'texture { pigment { rgb 1 } }' 'pigment { rgb 1 }' 'normal { bumps }' 'finish { phong 1 }' 'color_map { [0 rgb 0] [1 rgb 1] }' 'array[1] { 1 }' 'function { x }' 'spline { 0, 1 }' 'transform { scale 2 }' 'camera { location 0 }' 'interior { ior 1.5 }' 'material { texture { pigment { rgb 1 } } }' 'fog { distance 1 }' 'sky_sphere { pigment { rgb 1 } }' 'light_source { 0, rgb 1 }'
// expect: 1

//= @ later
#declare A = array[2] #declare A[1] = @ #debug concat(str(defined(A[0]), 0, 0), str(defined(A[1]), 0, 0), "\n")
// each: '1;' '<1,2,3>;' 'rgb 1;' '"s"' 'sphere { 0, 1 }' 'texture { pigment { rgb 1 } }' 'pigment { rgb 1 }' 'array[1] { 1 }' 'function { x }' 'spline { 0, 1 }' 'transform { scale 2 }'
// expect: 01

//= three and four dimensions
#declare A = array[2][1][2] { { { 1, 2 } }, { { 3, 4 } } } #declare B = array[1][1][1][2] { { { { 5, 6 } } } } #debug concat(str(A[1][0][1], 0, 0), str(B[0][0][0][1], 0, 0), "\n")
// expect: 46

//= a size that is a vector
#declare A = array[x]
// error: D0204 at 1:20

//= a size that is a string
#declare A = array["a"]
// error: D0204 at 1:20

//= a subscript that is a vector
#declare A = array[2] { 1, 2 } #declare B = A[x];
// error: D0204 at 1:47

//= an array of arrays of functions
#declare A = array[1] { array[1] { function(X) { X*7 } } } #debug concat(str(A[0][0](2), 0, 0), "\n")
// expect: 14

//= the whole array as an argument and a copy
#declare A = array[2] { 1, 2 } #macro M(P) #debug concat(str(dimension_size(P, 1), 0, 0), "\n") #end M(A) #declare B = A; #debug concat(str(B[1], 0, 0), "\n")
// expect: 2
// expect: 2

//= colours in arrays are single precision
#declare A = array[1] { rgb 0.1 } #debug concat(str(A[0].red, 0, 12), "\n")
// expect: 0.100000001490

//= too few rows
#declare A = array[2][2] { { 1, 2 } }
// error: D0202 at 1:37

//= too many rows
#declare A = array[1][2] { { 1, 2 }, { 3, 4 } }
// error: D0201 at 1:38

//= elements that are not set in a copy
#declare A = array[2] #declare A[0] = 1; #declare B = A; #debug concat(str(defined(B[0]), 0, 0), str(defined(B[1]), 0, 0), "\n")
// expect: 10

//= subscripts are what they are before the value, which a macro may make
#macro M(P) spline { linear_spline #for (I, 2, 4) I, I*P #end } #end
#declare C = array[7]
#for (I, 0, 2) #declare C[I] = M(x*I) #end
#for (I, 0, 6) #ifdef (C[I]) #debug "yes " #else #debug "no " #end #end
#debug "\n"
// expect: yes yes yes no no no no
