// Language §6.3: numerics of functions.
#version 3.7;
global_settings { assumed_gamma 1 }

//= no domain errors
#declare G1 = function(X) { 1/X } #declare G2 = function(X) { ln(X) } #declare G5 = function(X,Y) { atan2(X,Y) } #declare G6 = function(X,Y) { pow(X,Y) }
#debug concat(str(G1(0),0,3), "\n")
#debug concat(str(G2(0),0,3), "\n")
#debug concat(str(G5(0,0),0,3), "\n")
#debug concat(str(G6(0,0),0,3), "\n")
// expect: inf
// expect: -inf
// expect: 0.000
// expect: 1.000

//= NaN
#declare G = function(X) { sqrt(X) } #declare H = function(X,Y) { mod(X,Y) } #declare I = function(X) { acos(X) }
#debug concat(str((G(-1)=7), 0, 0), "\n")
#debug concat(str((H(1,0)=7), 0, 0), "\n")
#debug concat(str((I(2)=7), 0, 0), "\n")
// expect: 1
// expect: 1
// expect: 1

//= a constant zero as divisor
#declare F = function(X) { X/0 }
// error: D0301 at 1:28

//= the logarithm of a constant
#declare F = function(X) { X*ln(-1) }
#debug concat(str((F(1)=7), 0, 0), "\n")
// expect: 1

//= a quotient by a constant is a product
#declare F = function(X) { X/3 }
#debug concat(str(F(5), 0, 18), "\n")
#debug concat(str(F(0.1), 0, 18), "\n")
#debug concat(str(F(7), 0, 18), "\n")
// expect: 1.666666666666666519
// expect: 0.033333333333333333
// expect: 2.333333333333333037

//= constants in a chain are not merged
#declare F = function(X) { X/3/7 }
#debug concat(str(F(5), 0, 18), "\n")
#debug concat(str(F(0.1), 0, 18), "\n")
// expect: 0.238095238095238054
// expect: 0.004761904761904761

//= power 0
#declare F = function(X) { pow(X,0) }
#debug concat(str(F(1.1), 0, 18), "\n")
#debug concat(str(F(-0.7), 0, 18), "\n")
// expect: 1.000000000000000000
// expect: 1.000000000000000000

//= power 1
#declare F = function(X) { pow(X,1) }
#debug concat(str(F(1.1), 0, 18), "\n")
#debug concat(str(F(-0.7), 0, 18), "\n")
// expect: 1.100000000000000089
// expect: -0.699999999999999956

//= power 2
#declare F = function(X) { pow(X,2) }
#debug concat(str(F(1.1), 0, 18), "\n")
#debug concat(str(F(-0.7), 0, 18), "\n")
// expect: 1.210000000000000187
// expect: 0.489999999999999936

//= power 3
#declare F = function(X) { pow(X,3) }
#debug concat(str(F(1.1), 0, 18), "\n")
#debug concat(str(F(-0.7), 0, 18), "\n")
// expect: 1.331000000000000405
// expect: -0.342999999999999916

//= power 4
#declare F = function(X) { pow(X,4) }
#debug concat(str(F(1.1), 0, 18), "\n")
#debug concat(str(F(-0.7), 0, 18), "\n")
// expect: 1.464100000000000401
// expect: 0.240099999999999925

//= power 5
#declare F = function(X) { pow(X,5) }
#debug concat(str(F(1.1), 0, 18), "\n")
#debug concat(str(F(-0.7), 0, 18), "\n")
// expect: 1.610510000000000552
// expect: -0.168069999999999942

//= power 6
#declare F = function(X) { pow(X,6) }
#debug concat(str(F(1.1), 0, 18), "\n")
#debug concat(str(F(-0.7), 0, 18), "\n")
// expect: 1.771561000000000830
// expect: 0.117648999999999948

//= power 7
#declare F = function(X) { pow(X,7) }
#debug concat(str(F(1.1), 0, 18), "\n")
#debug concat(str(F(-0.7), 0, 18), "\n")
// expect: 1.948717100000000979
// expect: -0.082354299999999964

//= power 8
#declare F = function(X) { pow(X,8) }
#debug concat(str(F(1.1), 0, 18), "\n")
#debug concat(str(F(-0.7), 0, 18), "\n")
// expect: 2.143588810000001121
// expect: 0.057648009999999965

//= power 9
#declare F = function(X) { pow(X,9) }
#debug concat(str(F(1.1), 0, 18), "\n")
#debug concat(str(F(-0.7), 0, 18), "\n")
// expect: 2.357947691000001900
// expect: -0.040353606999999979

//= power -1
#declare F = function(X) { pow(X,-1) }
#debug concat(str(F(1.1), 0, 18), "\n")
#debug concat(str(F(-0.7), 0, 18), "\n")
// expect: 0.909090909090909061
// expect: -1.428571428571428603

//= power 0.5
#declare F = function(X) { pow(X,0.5) }
#debug concat(str(F(1.1), 0, 18), "\n")
#debug concat(str(F(-0.7), 0, 18), "\n")
// expect: 1.048808848170151631
// expect: -nan

//= degrees and radians
#declare F = function(X) { degrees(X) + radians(X) }
#debug concat(str(F(1.1), 0, 15), "\n")
// expect: 63.044556086162494

//= int and div
#declare F = function(X) { int(X) + 100*div(X,2) }
#debug concat(str(F(7.9), 0, 0), "\n")
#debug concat(str(F(-7.9), 0, 0), "\n")
// expect: 307
// expect: -307

//= folded constants
#declare F = function(X) { X + sin(1) + 2*3/7 - pi }
#debug concat(str(F(1), 0, 15), "\n")
// expect: -0.442978811639039

//= minimum and maximum of zeros and of what is no number
#declare Lo = function(X, Y) { min(X, Y) } #declare Hi = function(X, Y) { max(X, Y) } #declare N = acosh(0);
#debug concat(str(Lo(0, -0), 0, 0), " ", str(Lo(-0, 0), 0, 0), " ", str(Hi(0, -0), 0, 0), " ", str(Hi(-0, 0), 0, 0), "\n")
#debug concat(str(Lo(N, 1), 0, 0), " ", str(Lo(1, N), 0, 0), " ", str(Hi(N, 1), 0, 0), " ", str(Hi(1, N), 0, 0), "\n")
// expect: 0 -0 0 -0
// expect: 1 -nan -nan 1

//= constants in later arguments
#declare F = function(X) { max(-1, (5)/49) + max(-1, -5/-49)/1e3 }
#debug concat(str(F(1), 0, 18), "\n")
#declare G = function(X) { pow(atan(3), 7) + pow((3.7), 7) }
#debug concat(str(G(1), 0, 15), "\n")
// expect: 0.102142857142857132
// expect: 9497.930662536242380

//= a division by the constant zero in a later argument
#declare F = function(X) { select(X, 3/0, 1) }
// error: D0301 at 1:38

//= constants have no negative zero, arguments have
#declare V = -0;
#declare F = function(X) { X*V }
#declare G = function(X) { X*(-0) }
#declare H = function(X, Y) { X*Y }
#declare C = function(X) { V }
#debug concat(str(F(0.5), 0, 3), " ", str(F(-0.5), 0, 3), " ", str(G(0.5), 0, 3), "\n")
#debug concat(str(H(0.5, V), 0, 3), " ", str(C(0.5), 0, 3), " ", str(V, 0, 3), "\n")
// expect: 0.000 -0.000 0.000
// expect: -0.000 0.000 -0.000
