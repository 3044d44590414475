// Language §6.1: declaration of functions.
#version 3.7;
global_settings { assumed_gamma 1 }

//= parameters
#declare F = function(A,B) { A*10 + B }
#debug concat(str(F(1,2), 0, 9), "\n")
#debug concat(str(F(2,1), 0, 9), "\n")
// expect: 12.000000000
// expect: 21.000000000

//= x, y and z without a list
#declare F = function { x + 10*y + 100*z }
#debug concat(str(F(1,2,3), 0, 9), "\n")
// expect: 321.000000000

//= any order
#declare F = function(y,z,x) { x+10*y+100*z }
#debug concat(str(F(1,2,3), 0, 9), "\n")
// expect: 213.000000000

//= u and v
#declare F = function(u,v) { u - v }
#debug concat(str(F(5,3), 0, 9), "\n")
// expect: 2.000000000

//= no commas between parameters
#declare F = function(A B) { A - B }
#debug concat(str(F(5,3), 0, 9), "\n")
// expect: 2.000000000

//= an empty list
#declare F = function() { 1 }
// error: D0202 at 1:22

//= a declared name as parameter
#declare A = 1; #declare F = function(A) { A }
// beyond

//= a reserved word as parameter
#declare F = function(pi) { 1 }
// error: D0201 at 1:23

//= internal functions
#declare F = function { internal(57) } #declare G = function { internal(61) }
#debug concat(str(F(1,2,2), 0, 6), "\n")
#debug concat(str(G(1,2,2,1), 0, 6), "\n")
// expect: 3.000000
// expect: 2.000000

//= an internal function that is not there
#declare F = function { internal(79) }
// error: D0302 at 1:33

//= transform functions
#declare F = function { transform { scale 2 translate <1,2,3> rotate 90*z } }
#debug concat(vstr(3, F(1,2,3), ",", 0, 6), "\n")
#debug concat(str(F(1,2,3).y, 0, 6), "\n")
// expect: -6.000000,3.000000,9.000000
// expect: 3.000000

//= spline functions
#declare F = function { spline { 0, <0,0,0> 1, <1,2,3> } }
#debug concat(vstr(3, F(0.5), ",", 0, 3), "\n")
#debug concat(str(F(0.5).z, 0, 6), "\n")
// expect: 0.500,1.000,1.500
// expect: 1.500000

//= pigment functions
#declare F = function { pigment { gradient x color_map { [0 rgb 0] [1 rgbft <1,.5,.25,.5,.125>] } } }
#debug concat(vstr(5, F(0.5,0,0), ",", 0, 6), "\n")
#debug concat(str(F(0.5,0,0).red, 0, 6), "\n")
#debug concat(str(F(0.5,0,0).transmit, 0, 6), "\n")
// expect: 0.500000,0.250000,0.125000,0.250000,0.062500
// expect: 0.500000
// expect: 0.062500

//= pattern functions
#declare F = function { pattern { gradient x } } #declare G = function { pattern { checker scale 0.5 } }
#debug concat(str(F(0.25,0,0), 0, 6), "\n")
#debug concat(str(F(1.75,5,6), 0, 6), "\n")
#debug concat(str(G(0.1,0.1,0.1), 0, 6), "\n")
#debug concat(str(G(0.6,0.1,0.1), 0, 6), "\n")
// expect: 0.250000
// expect: 0.750000
// expect: 0.000000
// expect: 1.000000

//= a list on a transform function
#declare F = function(A) { transform { scale 2 } }
// error: D0201 at 1:22

//= directives and macros in a body
#macro Twice(A) (A*2) #end #declare N = 3; #declare F = function { x #for (I,1,3) + I #end #if (N > 2) *10 #end }
#debug concat(str(F(1,0,0), 0, 0), "\n")
// expect: 34

//= a list on a @ function
#declare F = function(A) { @ }
// each: 'pigment { rgb 1 }' 'pattern { bozo }' 'spline { 0, 1 }'
// error: D0201 at 1:22

//= a list on an internal function counts for nothing
#declare F = function(A) { internal(57) } #debug concat(str(F(1,2,2), 0, 3), "\n")
// expect: 3.000

//= an internal function without a number
#declare F = function { internal() }
// error: D0201 at 1:33

//= an internal function of a fraction
#declare F = function { internal(57.9) } #debug concat(str(F(1,2,2), 0, 3), "\n")
// expect: 3.000

//= a negative internal function
#declare F = function { internal(-1) }
// error: D0302 at 1:33

//= @ as parameter
#declare F = function(A, @) { A + @ } #debug concat(str(F(1, 2), 0, 0), "\n")
// each: x y z u v B
// expect: 3

//= t is no parameter
#declare F = function(t) { 1 }
// error: D0201 at 1:23

//= a parameter named twice
#declare F = function(A, A) { A } #debug concat(str(F(1, 2), 0, 0), "\n")
// expect: 1

//= a function of nothing
#declare F = function { }
// error: D0201 at 1:25
