// Language §6.2: the grammar of functions.
#version 3.7;
global_settings { assumed_gamma 1 }

//= and binds tighter than or
#declare F = function(X) { X=1 | X=2 & X>5 }
#debug concat(str(F(1), 0, 0), "\n")
#debug concat(str(F(2), 0, 0), "\n")
#debug concat(str(F(6), 0, 0), "\n")
// expect: 1
// expect: 0
// expect: 0

//= no tolerance
#declare F = function(X) { X=1 }
#debug concat(str(F(1), 0, 0), "\n")
#debug concat(str(F(1+1e-11), 0, 0), "\n")
// expect: 1
// expect: 0

//= truth is not zero
#declare F = function(X) { X & 1 }
#debug concat(str(F(1e-11), 0, 0), "\n")
#debug concat(str(F(0), 0, 0), "\n")
#debug concat(str(F(-5), 0, 0), "\n")
// expect: 1
// expect: 0
// expect: 1

//= comparisons
#declare F = function(A,B) { (A<B) + 10*(A<=B) + 100*(A=B) + 1000*(A!=B) + 10000*(A>=B) + 100000*(A>B) }
#debug concat(str(F(1,2), 0, 0), "\n")
#debug concat(str(F(2,2), 0, 0), "\n")
#debug concat(str(F(3,2), 0, 0), "\n")
// expect: 1011
// expect: 10110
// expect: 111000

//= precedence
#declare F = function(X) { 2+3*X-4/X*2 }
#debug concat(str(F(2), 0, 9), "\n")
#debug concat(str(F(8), 0, 9), "\n")
// expect: 4.000000000
// expect: 25.000000000

//= unary signs
#declare F = function(X) { -X + 2--X + +X }
#debug concat(str(F(3), 0, 9), "\n")
// expect: 5.000000000

//= two signs in a row
#declare F = function(X) { --X }
// error: D0101 at 1:28

//= no not
#declare F = function(X) { !X }
// error: D0201 at 1:28

//= no conditional
#declare F = function(X) { X ? 1 : 2 }
// error: D0201 at 1:28

//= no power operator
#declare F = function(X) { X^2 }
// error: D0101 at 1:29

//= no semicolon
#declare F = function(X) { X; }
// error: D0201 at 1:29

//= no vectors
#declare F = function(X) { <X,1,2>.x }
// error: D0204 at 1:28

//= variables are taken by value
#declare A = 5; #declare F = function(X) { X + A } #declare A = 7;
#debug concat(str(F(1), 0, 0), "\n")
// expect: 6

//= elements
#declare A = array[2] { 5, 6 } #declare F = function(X) { X + A[1] }
#debug concat(str(F(1), 0, 0), "\n")
// expect: 7

//= no vector variables
#declare W = <1,2,3>; #declare F = function(X) { X + W.x }
// error: D0204 at 1:54

//= the size of the picture is a variable
#declare F = function(X) { X + image_width*0 }
#debug concat(str(F(1), 0, 0), "\n")
// expect: 1

//= true is not allowed
#declare F = function(X) { X + true }
// error: D0201 at 1:32

//= pi and clock
#declare F = function(X) { X*pi + clock }
#debug concat(str(F(1), 0, 6), "\n")
// expect: 3.141593

//= an unknown name
#declare F = function(X) { X + Nothing }
// error: D0203 at 1:32

//= members of vector functions
#declare P = function { pigment { rgbft <.1,.2,.3,.4,.5> } } #declare F = function(A) { P(A,0,0).red + 10*P(A,0,0).green + 100*P(A,0,0).blue } #declare G = function { P(x,y,z).filter*100 + P(x,y,z).transmit } #declare H = function { P(x,y,z).gray } #declare I = function { P(x,y,z).grey } #declare K = function { P(x,y,z).hf } #declare L = function { P(x,y,z).t }
#debug concat(str(F(0), 0, 5), "\n")
#debug concat(str(G(0,0,0), 0, 5), "\n")
#debug concat(str(H(0,0,0), 0, 5), "\n")
#debug concat(str(I(0,0,0), 0, 5), "\n")
#debug concat(str(K(0,0,0), 0, 5), "\n")
#debug concat(str(L(0,0,0), 0, 5), "\n")
// expect: 32.10000
// expect: 40.50000
// expect: 0.18170
// expect: 0.18170
// expect: 0.10039
// expect: 0.40000

//= a vector function needs a member
#declare P = function { transform { scale 2 } } #declare F = function { P(x,y,z) }
// error: D0202 at 1:73

//= an unknown member
#declare P = function { transform { scale 2 } } #declare F = function { P(x,y,z).w }
// error: D0203 at 1:73

//= abs
#declare F = function(X) { abs(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 0.500000000
// expect: 0.700000000

//= acos
#declare F = function(X) { acos(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 1.047197551
// expect: 2.346193823

//= asin
#declare F = function(X) { asin(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 0.523598776
// expect: -0.775397497

//= asinh
#declare F = function(X) { asinh(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 0.481211825
// expect: -0.652666566

//= atan
#declare F = function(X) { atan(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 0.463647609
// expect: -0.610725964

//= atanh
#declare F = function(X) { atanh(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 0.549306144
// expect: -0.867300528

//= ceil
#declare F = function(X) { ceil(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 1.000000000
// expect: -0.000000000

//= cos
#declare F = function(X) { cos(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 0.877582562
// expect: 0.764842187

//= cosh
#declare F = function(X) { cosh(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 1.127625965
// expect: 1.255169006

//= degrees
#declare F = function(X) { degrees(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 28.647889757
// expect: -40.107045659

//= exp
#declare F = function(X) { exp(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 1.648721271
// expect: 0.496585304

//= floor
#declare F = function(X) { floor(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 0.000000000
// expect: -1.000000000

//= int
#declare F = function(X) { int(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 0.000000000
// expect: 0.000000000

//= radians
#declare F = function(X) { radians(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 0.008726646
// expect: -0.012217305

//= sin
#declare F = function(X) { sin(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 0.479425539
// expect: -0.644217687

//= sinh
#declare F = function(X) { sinh(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 0.521095305
// expect: -0.758583702

//= sqrt
#declare F = function(X) { sqrt(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(2), 0, 9), "\n")
// expect: 0.707106781
// expect: 1.414213562

//= tan
#declare F = function(X) { tan(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 0.546302490
// expect: -0.842288380

//= tanh
#declare F = function(X) { tanh(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(-0.7), 0, 9), "\n")
// expect: 0.462117157
// expect: -0.604367777

//= ln
#declare F = function(X) { ln(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(2), 0, 9), "\n")
// expect: -0.693147181
// expect: 0.693147181

//= log
#declare F = function(X) { log(X) }
#debug concat(str(F(0.5), 0, 9), "\n")
#debug concat(str(F(2), 0, 9), "\n")
// expect: -0.301029996
// expect: 0.301029996

//= two arguments
#declare F = function(X,Y) { atan2(X,Y) + 10*mod(X,Y) + 100*div(X,Y) + 1000*pow(X,Y) }
#debug concat(str(F(7,2), 0, 9), "\n")
#debug concat(str(F(3,0.5), 0, 9), "\n")
// expect: 49311.292496668
// expect: 2333.456455218

//= max and min
#declare F = function(X,Y) { max(X,Y) + 10*min(X,Y) + 100*max(X,Y,5) }
#debug concat(str(F(1,2), 0, 9), "\n")
#debug concat(str(F(9,3), 0, 9), "\n")
// expect: 512.000000000
// expect: 939.000000000

//= max of one
#declare F = function(X) { max(X) }
// error: D0202 at 1:28

//= select
#declare F = function(X) { select(X,1,2) + 10*select(X,1,2,3) }
#debug concat(str(F(-1), 0, 0), "\n")
#debug concat(str(F(0), 0, 0), "\n")
#debug concat(str(F(1), 0, 0), "\n")
// expect: 11
// expect: 22
// expect: 32

//= sum and prod
#declare F = function(N) { sum(i,1,N,i*i) + 1000*prod(k,1,N,k) }
#debug concat(str(F(4), 0, 0), "\n")
#debug concat(str(F(0), 0, 0), "\n")
#debug concat(str(F(2.5), 0, 0), "\n")
// expect: 24030
// expect: 1000
// expect: 2005

//= sums of sums
#declare F = function(N) { sum(i,1,N,sum(k,1,i,k)) }
#debug concat(str(F(3), 0, 0), "\n")
// expect: 10

//= a declared name as index
#declare I = 1; #declare F = function(N) { sum(I,1,N,I) }
// beyond

//= rand is not allowed
#declare F = function(X) { rand(X) }
// error: D0201 at 1:28

//= sqr is not allowed
#declare F = function(X) { sqr(X) }
// error: D0201 at 1:28

//= vlength is not allowed
#declare F = function(X) { vlength(X) }
// error: D0201 at 1:28

//= bitwise_and is not allowed
#declare F = function(X) { bitwise_and(X,1) }
// error: D0201 at 1:28

//= strlen is not allowed
#declare F = function(X) { strlen("a") }
// error: D0201 at 1:28

//= an undeclared function is not allowed
#declare F = function(X) { Nothing(X) }
// error: D0203 at 1:28

//= functions call functions
#declare F = function(X) { X*2 } #declare G = function(X,Y) { F(X) + F(F(Y)) }
#debug concat(str(G(1,2), 0, 0), "\n")
// expect: 10

//= too few arguments
#declare F = function(X,Y) { X } #declare G = function(X) { F(X) }
// error: D0202 at 1:61

//= too many arguments
#declare F = function(X) { X } #declare G = function(X) { F(X,1) }
// error: D0202 at 1:59

//= x and u are one, y and v are one
#declare F = function(x,v) { x + u + y + v }
#debug concat(str(F(1,10), 0, 0), "\n")
// expect: 22

//= z is zero when it is no parameter
#declare F = function(x) { x + z }
#debug concat(str(F(3), 0, 0), "\n")
// expect: 3

//= @ is not allowed in functions
#declare F = function(X) { @(X) }
// each: sqr cube seed rand vlength bitwise_or bitwise_xor strlen asc val vdot file_exists inside dimension_size vnormalize vrotate str concat chr defined
// error: D0201 at 1:28

//= @ is no operand of functions
#declare F = function(X) { X + @ }
// each: true false on off yes no version clock_on now t
// error: D0201 at 1:32

//= @ with too many arguments
#declare F = function(X) { @(X, X) }
// each: abs acos acosh asin asinh atan atanh ceil cos cosh degrees exp floor int ln log radians sin sinh sqrt tan tanh
// error: D0202 at 1:28

//= @ with too few arguments
#declare F = function(X) { @(X) }
// each: atan2 div mod min select
// error: D0202 at 1:28

//= sum and prod with too few arguments
#declare F = function(X) { @(i, 1, X) }
// each: sum prod
// before
// error: D0202 at 1:28

//= member .@
#declare P = function { pigment { rgbft <.1,.2,.3,.4,.5> } } #declare F = function { P(x,y,z).@ } #debug concat(str(F(0,0,0), 0, 6), "\n")
// each: x u red
// expect: 0.100000

//= every member
#declare P = function { pigment { rgbft <.1,.2,.3,.4,.5> } }
#declare Fy = function { P(x,y,z).y } #declare Fv = function { P(x,y,z).v } #declare Fg = function { P(x,y,z).green } #declare Fz = function { P(x,y,z).z } #declare Fb = function { P(x,y,z).blue } #declare Ft = function { P(x,y,z).t } #declare Ff = function { P(x,y,z).filter } #declare Fm = function { P(x,y,z).transmit } #declare Fa = function { P(x,y,z).gray } #declare Fe = function { P(x,y,z).grey } #declare Fh = function { P(x,y,z).hf }
#debug concat(str(Fy(0,0,0), 0, 6), str(Fv(0,0,0), 0, 6), str(Fg(0,0,0), 0, 6), str(Fz(0,0,0), 0, 6), str(Fb(0,0,0), 0, 6), str(Ft(0,0,0), 0, 6), "\n")
#debug concat(str(Ff(0,0,0), 0, 6), str(Fm(0,0,0), 0, 6), str(Fa(0,0,0), 0, 6), str(Fe(0,0,0), 0, 6), str(Fh(0,0,0), 0, 9), "\n")
// expect: 0.2000000.2000000.2000000.3000000.3000000.400000
// expect: 0.4000000.5000000.1817000.1817000.100390551

//= hf and grey only inside of bodies
#declare P = function { pigment { rgb 0.5 } } #declare A = P(0,0,0).@;
// each: hf grey
// error: D0203 at 1:60

//= a member of a float function
#declare P = function(X) { X } #declare F = function(X) { P(X).x }
// error: D0204 at 1:59

//= a float function needs no member
#declare F = function { pattern { gradient x } } #declare G = function { F(x,y,z)*2 } #debug concat(str(G(0.25,0,0), 0, 3), "\n")
// expect: 0.500

//= recursion
#declare F = function(X) { F(X) } #debug concat(str(F(1), 0, 0), "\n")
// before
// error: D0203 at 1:28

//= select evaluates what it chooses
#declare F = function(X) { select(X, 1, 1/X) } #debug concat(str(F(-1), 0, 2), str(F(0), 0, 2), str(F(4), 0, 2), "\n")
// expect: 1.00inf0.25

//= a name in another scope
#macro M() #local L = 5; #declare F = function(X) { X + L } #end M() #debug concat(str(F(1), 0, 0), "\n")
// expect: 6
