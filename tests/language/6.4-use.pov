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
