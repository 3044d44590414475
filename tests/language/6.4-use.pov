// Language §6.4: using functions.
#version 3.7;
global_settings { assumed_gamma 1 }

//= a float function fills
#declare F = function(X) { X*2 }
#debug concat(vstr(3, vrotate(F(1),0), ",", 0, 3), "\n")
#debug concat(vstr(3, <F(1),F(2),F(3)>, ",", 0, 3), "\n")
#debug concat(vstr(3, F(1)*<1,2,3>, ",", 0, 3), "\n")
// expect: 2.000,2.000,2.000
// expect: 2.000,4.000,6.000
// expect: 2.000,4.000,6.000

//= lengths of vector functions
#declare P = function { pigment { rgb 0.5 } } #declare T = function { transform { scale 2 } }
#debug concat(vstr(5, P(0,0,0), ",", 0, 3), "\n")
#debug concat(vstr(3, T(1,2,3), ",", 0, 3), "\n")
// expect: 0.500,0.500,0.500,0.000,0.000
// expect: 2.000,4.000,6.000

//= too few arguments
#declare F = function(X,Y) { X } #declare A = F(1);
// error: D0202 at 1:47

//= too many arguments
#declare F = function(X) { X } #declare A = F(1,2);
// error: D0202 at 1:45

//= a vector argument
#declare F = function(X) { X } #declare A = F(<1,2,3>);
// error: D0204 at 1:47

//= single precision of pigments
#declare P = function { pigment { rgb 0.325 } }
#debug concat(str(P(0,0,0).red, 0, 12), "\n")
// expect: 0.324999988079

//= a copy
#declare F = function(X) { X*2 } #declare G = F;
#debug concat(str(G(3), 0, 0), "\n")
// expect: 6

//= a function without arguments
#declare F = function(X) { X } #declare A = F + 1;
// error: D0204 at 1:45

//= a string argument
#declare F = function(X) { X } #declare A = F("a");
// error: D0204 at 1:47

//= a transform function is forward
#declare F = function { transform { translate <1,2,3> scale 2 } } #debug concat(vstr(3, F(1,1,1), ",", 0, 3), "\n")
// expect: 4.000,6.000,8.000

//= a spline function with one argument
#declare F = function { spline { 0, <0,0,0> 1, <1,2,3> } } #declare A = F(1,2);
// error: D0202 at 1:73

//= functions in arrays and arguments
#declare A = array[1] { function(X) { X*5 } } #macro M(P) #debug concat(str(P(2), 0, 0), "\n") #end M(A[0])
// expect: 10

//= pattern functions keep their waves
#declare F = function { pattern { gradient x sine_wave } } #declare G = function { pattern { gradient x frequency 2 phase 0.25 } } #debug concat(str(F(0.1,0,0), 0, 6), str(G(0.1,0,0), 0, 6), "\n")
// expect: 0.7938930.450000

//= pigment functions are turned and warped
#declare F = function { pigment { gradient x turbulence 0.5 color_map { [0 rgb 0] [1 rgb 1] } rotate 90*z } } #debug concat(str(F(0.1,0.4,0.2).red, 0, 6), "\n")
// expect: 0.255691
