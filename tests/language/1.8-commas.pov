// Language §1.8: commas.
#version 3.7;
global_settings { assumed_gamma 1 }

//= between components
#debug concat(vstr(3, <1 2 3>, ",", 0, 3), "\n")
#debug concat(vstr(3, <1,2 3>, ",", 0, 3), "\n")
#debug concat(vstr(3, <1,2,3,>, ",", 0, 3), "\n")
#debug concat(vstr(4, <1,2,3,4,>, ",", 0, 3), "\n")
#debug concat(vstr(2, <1,2,>, ",", 0, 3), "\n")
// expect: 1.000,2.000,3.000
// expect: 1.000,2.000,3.000
// expect: 1.000,2.000,3.000
// expect: 1.000,2.000,3.000,4.000
// expect: 1.000,2.000

//= not after the fifth component
#declare A = <1,2,3,4,5,>;
// error: D0101 at 1:25

//= a sign continues
#debug concat(vstr(2, <1,2 -3>, ",", 0, 3), "\n")
// expect: 1.000,-1.000

//= operands of primitives
sphere { 0 1 } box { <0,0,0><1,1,1> } cone { 0 1 x 0 }
#debug concat("fine", "\n")
// expect: fine

//= a minus swallows an operand
box { -1 -2 }
// error: D0202 at 1:13

//= after the last operand
sphere { 0, 1, }
// error: D0201 at 1:14

//= arguments of built-in functions
#debug concat(str(mod(7 4), 0, 3), "\n")
#debug concat(str(atan2(1 2), 0, 3), "\n")
#debug concat(str(pow(2 3), 0, 3), "\n")
#debug concat(str(select(1 2 3), 0, 3), "\n")
#debug concat(str(vdot(x x), 0, 3), "\n")
#debug concat(str(strcmp("a" "b"), 0, 3), "\n")
// expect: 3.000
// expect: 0.464
// expect: 8.000
// expect: 3.000
// expect: 1.000
// expect: -1.000

//= arguments and parameters of macros
#macro M(a b) (a - b) #end
#debug concat(str(M(5 2), 0, 0), "\n")
#debug concat(str(M(5, 2,), 0, 0), "\n")
// expect: 3
// expect: 3

//= array initialisers
#declare A = array[2] { rgb 1 rgb 0 }
#debug concat(str(A[0].x, 0, 0), "\n")
#declare B = array[2] { 1 -1 }
// expect: 1
// error: D0202 at 3:30

//= required in max
#declare A = max(1 2);
// beyond

//= required for the fourth argument of select
#declare A = select(1, 2, 3 4);
// beyond

//= required in calls inside functions
#declare F = function { max(x y) }
// beyond

//= between entries of colour maps
#declare M = color_map { [0 rgb 1], [1 rgb 0] }
// error: D0201 at 1:35

//= after the last argument of a built-in function
#declare A = pow(2, 3,);
// error: D0202 at 1:22

//= after the last argument of a function
#declare F = function(X) { X } #declare A = F(1,);
// error: D0202 at 1:48

//= after the last argument inside functions
#declare F = function(X) { max(X, 2,) }
// error: D0202 at 1:36

//= after the last argument of a macro
#macro M(A, B) A + B #end
#debug concat(str(M(1, 2,), 0, 0), "\n")
// expect: 3

//= arguments of functions and splines
#declare F = function(A, B) { A - B } #declare S = spline { 0 <0,0,0> 1 <1,1,1> }
#debug concat(str(F(5 2), 0, 0), vstr(3, S(0.5, linear_spline), ",", 0, 1), "\n")
// expect: 30.5,0.5,0.5

//= arguments of vector and string functions
#debug concat(vstr(3 vrotate(x 90*z) "," 0 0), substr("abc" 2 1), vstr(3, vcross(x y), ",", 0, 0), vstr(3, vaxis_rotate(x y 0), ",", 0, 0), "\n")
// expect: 0,1,0b0,0,11,0,0

//= concat
#debug concat("a" "b", "\n")
// expect: ab

//= required in @
#declare A = @(1 2);
// each: max min bitwise_and bitwise_or bitwise_xor
// beyond

//= loop heads
#for (I 1 2 1) #debug str(I,0,0) #end #switch (2) #range (1 3) #debug "in\n" #end
// expect: 12in

//= subscripts need none
#declare A = array[2][2] { { 1 2 } { 3 4 } } #debug concat(str(A[1][0], 0, 0), "\n")
// expect: 3

//= forbidden between entries of slopes
#declare M = slope_map { [0 <0,1>], [1 <1,0>] }
// error: D0201 at 1:35
// error: D0201 at 1:31

//= forbidden between objects
sphere { 0, 1 }, sphere { 0, 1 }
// error: D0201 at 1:16

//= forbidden after an operand of a box
box { 0, 1, }
// error: D0201 at 1:11

//= a sign joins operands of a plane
plane { y -1 }
// error: D0202 at 1:14

//= a comma after the radius of a cylinder
cylinder { 0, y, 1, open }
// error: D0201 at 1:19

//= two commas between components
#declare A = <1,,2>;
// error: D0101 at 1:19
