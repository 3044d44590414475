// Language §3.1: float functions.
#version 3.7;
global_settings { assumed_gamma 1 }

//= abs
#debug concat(str(abs(-3), 0, 6), "\n")
#debug concat(str(abs(2.5), 0, 6), "\n")
#debug concat(str(abs(-0), 0, 6), "\n")
// expect: 3.000000
// expect: 2.500000
// expect: 0.000000

//= acos and asin clamp
#debug concat(str(acos(0), 0, 6), "\n")
#debug concat(str(acos(-1), 0, 6), "\n")
#debug concat(str(asin(1), 0, 6), "\n")
#debug concat(str(acos(1.5), 0, 6), "\n")
#debug concat(str(asin(-2), 0, 6), "\n")
#debug concat(str(asin(0.5), 0, 6), "\n")
// expect: 1.570796
// expect: 3.141593
// expect: 1.570796
// expect: 0.000000
// expect: -1.570796
// expect: 0.523599

//= hyperbolic functions
#debug concat(str(acosh(2), 0, 6), "\n")
#debug concat(str(asinh(1), 0, 6), "\n")
#debug concat(str(atanh(0.5), 0, 6), "\n")
#debug concat(str(cosh(1), 0, 6), "\n")
#debug concat(str(sinh(1), 0, 6), "\n")
#debug concat(str(tanh(1), 0, 6), "\n")
#debug concat(str(tanh(1<2), 0, 6), "\n")
// expect: 1.316958
// expect: 0.881374
// expect: 0.549306
// expect: 1.543081
// expect: 1.175201
// expect: 0.761594
// expect: 0.761594

//= outside their domain they give NaN
#debug concat(str((acosh(0.5)=7), 0, 0), "\n")
#debug concat(str((atanh(2)=7), 0, 0), "\n")
// expect: 1
// expect: 1

//= asc
#debug concat(str(asc("A"), 0, 0), "\n")
#debug concat(str(asc(""), 0, 0), "\n")
#debug concat(str(asc("Abc"), 0, 0), "\n")
// expect: 65
// expect: 0
// expect: 65

//= atan and atan2
#debug concat(str(atan(1), 0, 6), "\n")
#debug concat(str(atan2(1,2), 0, 6), "\n")
#debug concat(str(atan2(-1,-2), 0, 6), "\n")
#debug concat(str(atan2(1,0), 0, 6), "\n")
#debug concat(str(atan2(0,-1), 0, 6), "\n")
// expect: 0.785398
// expect: 0.463648
// expect: -2.677945
// expect: 1.570796
// expect: 3.141593

//= atan2 of nothing
#declare A = atan2(0,1e-11);
// error: D0301 at 1:14

//= bitwise functions
#debug concat(str(bitwise_and(12,10), 0, 0), "\n")
#debug concat(str(bitwise_or(12,10), 0, 0), "\n")
#debug concat(str(bitwise_xor(12,10), 0, 0), "\n")
#debug concat(str(bitwise_and(7,6,5), 0, 0), "\n")
#debug concat(str(bitwise_or(1), 0, 0), "\n")
#debug concat(str(bitwise_xor(-1,1), 0, 0), "\n")
#debug concat(str(bitwise_and(-1,255), 0, 0), "\n")
#debug concat(str(bitwise_and(5.9,4.9), 0, 0), "\n")
#debug concat(str(bitwise_or(4294967295,0), 0, 0), "\n")
// expect: 8
// expect: 14
// expect: 6
// expect: 4
// expect: 1
// expect: -2
// expect: 255
// expect: 4
// expect: -2147483648

//= ceil and floor
#debug concat(str(ceil(1.2), 0, 0), "\n")
#debug concat(str(ceil(-1.2), 0, 0), "\n")
#debug concat(str(floor(1.8), 0, 0), "\n")
#debug concat(str(floor(-1.2), 0, 0), "\n")
#debug concat(str(floor(1-1e-12), 0, 0), "\n")
#debug concat(str(ceil(1+1e-12), 0, 0), "\n")
// expect: 2
// expect: -1
// expect: 1
// expect: -2
// expect: 0
// expect: 2

//= cos, sin, tan
#debug concat(str(cos(1), 0, 9), "\n")
#debug concat(str(sin(1), 0, 9), "\n")
#debug concat(str(tan(1), 0, 9), "\n")
#debug concat(str(sin(pi), 0, 9), "\n")
// expect: 0.540302306
// expect: 0.841470985
// expect: 1.557407725
// expect: 0.000000000

//= defined
#declare A = 1; #declare B = "b"; #macro M() 1 #end #declare C = array[2]
#debug concat(str(defined(A), 0, 0), "\n")
#debug concat(str(defined(B), 0, 0), "\n")
#debug concat(str(defined(M), 0, 0), "\n")
#debug concat(str(defined(C), 0, 0), "\n")
#debug concat(str(defined(Nothing), 0, 0), "\n")
#debug concat(str(defined(sphere), 0, 0), "\n")
#debug concat(str(defined(sin), 0, 0), "\n")
#debug concat(str(defined(C[0]), 0, 0), "\n")
// expect: 1
// expect: 1
// expect: 1
// expect: 1
// expect: 0
// expect: 0
// expect: 0
// expect: 0

//= degrees and radians
#debug concat(str(degrees(pi), 0, 12), "\n")
#debug concat(str(degrees(1), 0, 12), "\n")
#debug concat(str(radians(180), 0, 12), "\n")
#debug concat(str(radians(1), 0, 12), "\n")
// expect: 180.000000000000
// expect: 57.295779513082
// expect: 3.141592653590
// expect: 0.017453292520

//= dimensions
#declare A = array[2][3][4] #declare B = array[5]
#debug concat(str(dimensions(A), 0, 0), "\n")
#debug concat(str(dimensions(B), 0, 0), "\n")
#debug concat(str(dimension_size(A,1), 0, 0), "\n")
#debug concat(str(dimension_size(A,2), 0, 0), "\n")
#debug concat(str(dimension_size(A,3), 0, 0), "\n")
#debug concat(str(dimension_size(B,1), 0, 0), "\n")
// expect: 3
// expect: 1
// expect: 2
// expect: 3
// expect: 4
// expect: 5

//= a dimension out of range
#declare A = array[2];
#debug concat(str(dimension_size(A,0), 0, 0), "\n")
#debug concat(str(dimension_size(A,2), 0, 0), "\n")
#debug concat(str(dimension_size(A,-1), 0, 0), "\n")
// expect: 0
// expect: 0
// expect: 0

//= dimensions of no array
#declare V = 1; #declare A = dimensions(V);
// error: D0204 at 1:41

//= div
#debug concat(str(div(7,2), 0, 0), "\n")
#debug concat(str(div(-7,2), 0, 0), "\n")
#debug concat(str(div(7,-2), 0, 0), "\n")
#debug concat(str(div(5,0), 0, 0), "\n")
#debug concat(str(div(1e12,1), 0, 0), "\n")
#debug concat(str(div(7.9,2), 0, 0), "\n")
#debug concat(str(div(0.9,1), 0, 0), "\n")
// expect: 3
// expect: -3
// expect: -3
// expect: -2147483648
// expect: -2147483648
// expect: 3
// expect: 0

//= exp
#debug concat(str(exp(1), 0, 6), "\n")
#debug concat(str(exp(0), 0, 6), "\n")
#debug concat(str(exp(-1), 0, 6), "\n")
#debug concat(str(exp(1000),0,0), "\n")
// expect: 2.718282
// expect: 1.000000
// expect: 0.367879
// expect: inf

//= file_exists
#debug concat(str(file_exists("data.txt"), 0, 0), "\n")
#debug concat(str(file_exists("nothing.txt"), 0, 0), "\n")
#debug concat(str(file_exists("declares"), 0, 0), "\n")
// expect: 1
// expect: 0
// expect: 0

//= inside
#declare O = sphere { 0, 1 } #declare P = plane { y, 0 }
#debug concat(str(inside(O,0), 0, 0), "\n")
#debug concat(str(inside(O,<2,0,0>), 0, 0), "\n")
#debug concat(str(inside(P,-y), 0, 0), "\n")
#debug concat(str(inside(P,y), 0, 0), "\n")
#debug concat(str(inside(O,0.5), 0, 0), "\n")
// expect: 1
// expect: 0
// expect: 1
// expect: 0
// expect: 1

//= inside wants a declared object
#declare A = inside(sphere { 0, 1 }, 0);
// error: D0201 at 1:21

//= inside of a patch
#declare O = triangle { 0, x, y } #declare A = inside(O, 0);
// error: D0204 at 1:55

//= int
#debug concat(str(int(1.7), 0, 0), "\n")
#debug concat(str(int(-1.7), 0, 0), "\n")
#debug concat(str(int(0.99999999999), 0, 0), "\n")
#debug concat(str(int(2147483647.5), 0, 0), "\n")
#debug concat(str(int(1e12), 0, 0), "\n")
#debug concat(str(int(-1e12), 0, 0), "\n")
// expect: 1
// expect: -1
// expect: 0
// expect: 2147483647
// expect: -2147483648
// expect: -2147483648

//= ln and log
#debug concat(str(ln(2), 0, 6), "\n")
#debug concat(str(log(2), 0, 6), "\n")
#debug concat(str(ln(exp(1)), 0, 6), "\n")
#debug concat(str(log(1000), 0, 6), "\n")
// expect: 0.693147
// expect: 0.301030
// expect: 1.000000
// expect: 3.000000

//= the logarithm of zero: ln(0)
#declare A = ln(0);
// error: D0301 at 1:14

//= the logarithm of a negative number: log(-1)
#declare A = log(-1);
// error: D0301 at 1:14

//= max and min
#debug concat(str(max(1,2), 0, 0), "\n")
#debug concat(str(max(3,2,1), 0, 0), "\n")
#debug concat(str(min(1,2), 0, 0), "\n")
#debug concat(str(min(3,2,1,-5), 0, 0), "\n")
#debug concat(str(max(7), 0, 0), "\n")
#debug concat(str(min(7), 0, 0), "\n")
// expect: 2
// expect: 3
// expect: 1
// expect: -5
// expect: 7
// expect: 7

//= mod
#debug concat(str(mod(7,3), 0, 6), "\n")
#debug concat(str(mod(-7,3), 0, 6), "\n")
#debug concat(str(mod(5,-3), 0, 6), "\n")
#debug concat(str(mod(5.5,2), 0, 6), "\n")
#debug concat(str((mod(1,0)=7), 0, 6), "\n")
// expect: 1.000000
// expect: -1.000000
// expect: 2.000000
// expect: 1.500000
// expect: 1.000000

//= pow
#debug concat(str(pow(2,10), 0, 6), "\n")
#debug concat(str(pow(2,-1), 0, 6), "\n")
#debug concat(str(pow(2,0.5), 0, 6), "\n")
#debug concat(str(pow(-2,3), 0, 6), "\n")
#debug concat(str(pow(0,2), 0, 6), "\n")
#debug concat(str(pow(5,0), 0, 6), "\n")
#debug concat(str((pow(-2,0.5)=7), 0, 6), "\n")
// expect: 1024.000000
// expect: 0.500000
// expect: 1.414214
// expect: -8.000000
// expect: 0.000000
// expect: 1.000000
// expect: 1.000000

//= nothing to the power of nothing: pow(0,0)
#declare A = pow(0,0);
// error: D0301 at 1:14

//= select with three arguments
#debug concat(str(select(-1,2,3), 0, 0), "\n")
#debug concat(str(select(0,2,3), 0, 0), "\n")
#debug concat(str(select(1,2,3), 0, 0), "\n")
#debug concat(str(select(-1e-12,2,3), 0, 0), "\n")
// expect: 2
// expect: 3
// expect: 3
// expect: 2

//= select with four
#debug concat(str(select(-1,2,3,4), 0, 0), "\n")
#debug concat(str(select(0,2,3,4), 0, 0), "\n")
#debug concat(str(select(1,2,3,4), 0, 0), "\n")
#debug concat(str(select(1e-12,2,3,4), 0, 0), "\n")
// expect: 2
// expect: 3
// expect: 4
// expect: 4

//= select evaluates all its arguments
#declare S = seed(1); #declare A = select(1, rand(S), rand(S), 5); #declare T = seed(1); #declare B = rand(T)+rand(T);
#debug concat(str((rand(S)=rand(T)), 0, 0), "\n")
// expect: 1

//= sqrt
#debug concat(str(sqrt(2), 0, 6), "\n")
#debug concat(str(sqrt(0), 0, 6), "\n")
// expect: 1.414214
// expect: 0.000000

//= the root of a negative number: sqrt(-1)
#declare A = sqrt(-1);
// error: D0301 at 1:14

//= strcmp
#debug concat(str(strcmp("a","b"), 0, 0), "\n")
#debug concat(str(strcmp("a","a"), 0, 0), "\n")
#debug concat(str(strcmp("b","a"), 0, 0), "\n")
#debug concat(str(strcmp("a","ab"), 0, 0), "\n")
#debug concat(str(strcmp("ab","a"), 0, 0), "\n")
#debug concat(str(strcmp("",""), 0, 0), "\n")
#debug concat(str(strcmp("A","a"), 0, 0), "\n")
// expect: -1
// expect: 0
// expect: 1
// expect: -98
// expect: 98
// expect: 0
// expect: -32

//= strlen
#debug concat(str(strlen(""), 0, 0), "\n")
#debug concat(str(strlen("abc"), 0, 0), "\n")
#debug concat(str(strlen("a\tb"), 0, 0), "\n")
// expect: 0
// expect: 3
// expect: 3

//= val
#debug concat(str(val("12.5e1xyz"), 0, 6), "\n")
#debug concat(str(val("-3"), 0, 6), "\n")
#debug concat(str(val("abc"), 0, 6), "\n")
#debug concat(str(val(""), 0, 6), "\n")
#debug concat(str(val("  7"), 0, 6), "\n")
#debug concat(str(val("1e2"), 0, 6), "\n")
#debug concat(str(val(".5"), 0, 6), "\n")
#debug concat(str(val("0x10"), 0, 6), "\n")
// expect: 125.000000
// expect: -3.000000
// expect: 0.000000
// expect: 0.000000
// expect: 7.000000
// expect: 100.000000
// expect: 0.500000
// expect: 16.000000

//= vdot and vlength
#debug concat(str(vdot(<1,2,3>,<4,5,6>), 0, 6), "\n")
#debug concat(str(vdot(x,y), 0, 6), "\n")
#debug concat(str(vlength(<3,4,0>), 0, 6), "\n")
#debug concat(str(vlength(<3,4>), 0, 6), "\n")
#debug concat(str(vdot(2,<1,2,3>), 0, 6), "\n")
// expect: 32.000000
// expect: 0.000000
// expect: 5.000000
// expect: 5.000000
// expect: 12.000000

//= sums and products exist only in functions
#declare A = sum(I, 1, 2, I);
// error: D0201 at 1:14

//= too few arguments: mod(7)
#declare A = mod(7);
// error: D0202 at 1:14

//= too many arguments: sin(1,2)
#declare A = sin(1,2);
// error: D0201 at 1:14

//= too many arguments: mod(1,2,3)
#declare A = mod(1,2,3);
// error: D0201 at 1:14

//= none: max()
#declare A = max();
// error: D0202 at 1:14

//= a missing parenthesis
#declare A = sin 1;
// error: D0201 at 1:14

//= @ of a string
#declare A = @(
"a");
// each: abs acos asin atan ceil cos cosh degrees exp floor int ln log radians sin sinh sqrt tan tanh asinh acosh atanh seed
// error: D0204 at 2:1

//= @ of a number
#declare A = @(
1);
// each: strlen val asc file_exists
// error: D0204 at 2:1

//= @ without arguments
#declare A = @();
// each: abs acos asin atan ceil cos cosh degrees exp floor int ln log radians sin sinh sqrt tan tanh asinh acosh atanh seed rand strlen val asc file_exists vlength min bitwise_and
// error: D0202 at 1:14

//= @ with one argument
#declare A = @(1);
// each: atan2 div mod pow select vdot
// error: D0202 at 1:14

//= @ with three arguments
#declare A = @(1, 2, 3);
// each: atan2 div pow
// error: D0201 at 1:14

//= @ is an ordinary reserved word
#declare A = @(3);
// each: sum prod sqr cube reciprocal pwr
// error: D0201 at 1:14

//= acos and asin in their domain, and beyond
#debug concat(str(asin(1.0000001), 0, 6), str(acos(-1.0000001), 0, 6), "\n")
// expect: 1.5707963.141593

//= seed and rand
#declare S = seed(1); #debug concat(str(S, 0, 0), str((rand(S) < 1), 0, 0), "\n")
// expect: 01

//= val takes the longest number
#debug concat(str(val("1e"), 0, 2), str(val("1.5.5"), 0, 2), str(val("+7"), 0, 2), str(val("inf"), 0, 2), "\n")
// expect: 1.001.507.00inf

//= file_exists with and without a suffix
#debug concat(str(file_exists("declares.inc"), 0, 0), str(file_exists("declares"), 0, 0), "\n")
// expect: 10

//= defined of a parameter and of a function
#macro M(P) #debug str(defined(P), 0, 0) #end #declare F = function { x } M(1) #debug concat(str(defined(F), 0, 0), "\n")
// expect: 11

//= inside with CSG and transformations
#declare O = difference { box { -1, 1 } sphere { 0, 1 } scale 2 } #debug concat(str(inside(O, 0), 0, 0), str(inside(O, 1.9), 0, 0), str(inside(O, 2.1), 0, 0), "\n")
// expect: 010

//= inside of no object
#declare P = 5; #declare A = inside(P, 0);
// error: D0204 at 1:37

//= inside of an inverse
#declare O = sphere { 0, 1 inverse } #debug concat(str(inside(O, 0), 0, 0), str(inside(O, 2), 0, 0), "\n")
// expect: 01
