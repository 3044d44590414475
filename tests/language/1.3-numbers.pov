// Language §1.3: numbers.
#version 3.7;
global_settings { assumed_gamma 1 }

//= forms of numbers
#debug concat(str(1., 0, 6), "\n")
#debug concat(str(.5, 0, 6), "\n")
#debug concat(str(1e3, 0, 6), "\n")
#debug concat(str(1.e2, 0, 6), "\n")
#debug concat(str(00012, 0, 6), "\n")
#debug concat(str(1e, 0, 6), "\n")
#debug concat(str(1E+2, 0, 6), "\n")
#debug concat(str(2e-1, 0, 6), "\n")
#debug concat(str(1e+, 0, 6), "\n")
#debug concat(str(.5e1, 0, 6), "\n")
// expect: 1.000000
// expect: 0.500000
// expect: 1000.000000
// expect: 100.000000
// expect: 12.000000
// expect: 1.000000
// expect: 100.000000
// expect: 0.200000
// expect: 1.000000
// expect: 5.000000

//= no hexadecimal: a number and a name
#declare x10 = 1; #declare A = 0x10;
// error: D0101 at 1:28

//= a second point
#declare A = 1..2;
// error: D0101 at 1:16

//= a point after an exponent
#declare A = 1e2.5;
// error: D0101 at 1:17

//= a point and a name after a fraction
#declare A = 1.5.x;
// error: D0101 at 1:17

//= a literal with a component
#declare A = 5.x;
// error: D0101 at 1:10

//= a component of a literal in parentheses
#debug concat(str((5).x, 0, 6), "\n")
#debug concat(str(-(5).x, 0, 6), "\n")
// expect: 5.000000
// expect: -5.000000

//= minus is an operator
#debug concat(str(-5, 0, 6), "\n")
#debug concat(str(3-5, 0, 6), "\n")
#debug concat(str(3 -5, 0, 6), "\n")
#debug concat(str(3--5, 0, 6), "\n")
// expect: -5.000000
// expect: -2.000000
// expect: -2.000000
// expect: 8.000000

//= precision of conversion
#debug concat(str(0.1, 0, 15), "\n")
#debug concat(str(123456789.123456789, 0, 15), "\n")
#debug concat(str(1e-320*1e300, 0, 15), "\n")
// expect: 0.100000000000000
// expect: 123456789.123456791043282
// expect: 0.000000000000000

//= large and small
#debug concat(str(1e300,0,3), "\n")
#debug concat(str(1e-300,0,3), "\n")
#debug concat(str(1e308*10,0,3), "\n")
// expect: 1e+300
// expect: 0.000
// expect: inf
