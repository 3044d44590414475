// Language §5.2: splines.
#version 3.7;
global_settings { assumed_gamma 1 }

//= linear_spline
#declare S = spline { linear_spline 0, <0,0,0> 1, <1,2,0> 2, <4,1,0> 3, <9,5,0> }
#debug concat(vstr(3, S(-1), ",", 0, 9), "\n")
#debug concat(vstr(3, S(0), ",", 0, 9), "\n")
#debug concat(vstr(3, S(0.5), ",", 0, 9), "\n")
#debug concat(vstr(3, S(1), ",", 0, 9), "\n")
#debug concat(vstr(3, S(1.5), ",", 0, 9), "\n")
#debug concat(vstr(3, S(2.25), ",", 0, 9), "\n")
#debug concat(vstr(3, S(3), ",", 0, 9), "\n")
#debug concat(vstr(3, S(4), ",", 0, 9), "\n")
// expect: 0.000000000,0.000000000,0.000000000
// expect: 0.000000000,0.000000000,0.000000000
// expect: 0.500000000,1.000000000,0.000000000
// expect: 1.000000000,2.000000000,0.000000000
// expect: 2.500000000,1.500000000,0.000000000
// expect: 5.250000000,2.000000000,0.000000000
// expect: 9.000000000,5.000000000,0.000000000
// expect: 9.000000000,5.000000000,0.000000000

//= quadratic_spline
#declare S = spline { quadratic_spline 0, <0,0,0> 1, <1,2,0> 2, <4,1,0> 3, <9,5,0> }
#debug concat(vstr(3, S(-1), ",", 0, 9), "\n")
#debug concat(vstr(3, S(0), ",", 0, 9), "\n")
#debug concat(vstr(3, S(0.5), ",", 0, 9), "\n")
#debug concat(vstr(3, S(1), ",", 0, 9), "\n")
#debug concat(vstr(3, S(1.5), ",", 0, 9), "\n")
#debug concat(vstr(3, S(2.25), ",", 0, 9), "\n")
#debug concat(vstr(3, S(3), ",", 0, 9), "\n")
#debug concat(vstr(3, S(4), ",", 0, 9), "\n")
// expect: 0.000000000,0.000000000,0.000000000
// expect: 0.000000000,0.000000000,0.000000000
// expect: 0.250000000,1.375000000,0.000000000
// expect: 1.000000000,2.000000000,0.000000000
// expect: 2.250000000,1.875000000,0.000000000
// expect: 5.062500000,1.531250000,0.000000000
// expect: 9.000000000,5.000000000,0.000000000
// expect: 9.000000000,5.000000000,0.000000000

//= cubic_spline
#declare S = spline { cubic_spline 0, <0,0,0> 1, <1,2,0> 2, <4,1,0> 3, <9,5,0> }
#debug concat(vstr(3, S(-1), ",", 0, 9), "\n")
#debug concat(vstr(3, S(0), ",", 0, 9), "\n")
#debug concat(vstr(3, S(0.5), ",", 0, 9), "\n")
#debug concat(vstr(3, S(1), ",", 0, 9), "\n")
#debug concat(vstr(3, S(1.5), ",", 0, 9), "\n")
#debug concat(vstr(3, S(2.25), ",", 0, 9), "\n")
#debug concat(vstr(3, S(3), ",", 0, 9), "\n")
#debug concat(vstr(3, S(4), ",", 0, 9), "\n")
// expect: 1.000000000,2.000000000,0.000000000
// expect: 1.000000000,2.000000000,0.000000000
// expect: 1.000000000,2.000000000,0.000000000
// expect: 1.000000000,2.000000000,0.000000000
// expect: 2.250000000,1.375000000,0.000000000
// expect: 4.000000000,1.000000000,0.000000000
// expect: 4.000000000,1.000000000,0.000000000
// expect: 4.000000000,1.000000000,0.000000000

//= natural_spline
#declare S = spline { natural_spline 0, <0,0,0> 1, <1,2,0> 2, <4,1,0> 3, <9,5,0> }
#debug concat(vstr(3, S(-1), ",", 0, 9), "\n")
#debug concat(vstr(3, S(0), ",", 0, 9), "\n")
#debug concat(vstr(3, S(0.5), ",", 0, 9), "\n")
#debug concat(vstr(3, S(1), ",", 0, 9), "\n")
#debug concat(vstr(3, S(1.5), ",", 0, 9), "\n")
#debug concat(vstr(3, S(2.25), ",", 0, 9), "\n")
#debug concat(vstr(3, S(3), ",", 0, 9), "\n")
#debug concat(vstr(3, S(4), ",", 0, 9), "\n")
// expect: 0.000000000,0.000000000,0.000000000
// expect: 0.000000000,0.000000000,0.000000000
// expect: 0.350000000,1.425000000,0.000000000
// expect: 1.000000000,2.000000000,0.000000000
// expect: 2.200000000,1.350000000,0.000000000
// expect: 5.118750000,1.496875000,0.000000000
// expect: 9.000000000,5.000000000,0.000000000
// expect: 9.000000000,5.000000000,0.000000000

//= linear is the default
#declare S = spline {  0, <0,0,0> 1, <1,2,0> 2, <4,1,0> 3, <9,5,0> }
#debug concat(vstr(3, S(1.5), ",", 0, 3), "\n")
// expect: 2.500,1.500,0.000

//= float values make uv-vectors
#declare S = spline { 0, 1 1, 3 2, 10 }
#debug concat(vstr(2, S(.5), ",", 0, 3), "\n")
#debug concat(str(S(.5).x, 0, 6), "\n")
// expect: 2.000,2.000
// expect: 2.000000

//= a spline is no float
#declare S = spline { 0, 1 1, 3 } #declare A = sin(S(.5));
// error: D0204 at 1:52

//= lengths
#declare S = spline { 0, <1,2> 1, <3,4,5> } #declare T = spline { 0, <1,2,3,4,5> 1, <5,4,3,2,1> } #declare C = rgb 1; #declare U = spline { 0, C 1, C*2 }
#debug concat(vstr(3, S(0), ",", 0, 3), "\n")
#debug concat(vstr(3, S(.5), ",", 0, 3), "\n")
#debug concat(vstr(5, T(.5), ",", 0, 3), "\n")
#debug concat(vstr(5, U(.5), ",", 0, 3), "\n")
// expect: 1.000,2.000,0.000
// expect: 2.000,3.000,2.500
// expect: 3.000,3.000,3.000,3.000,3.000
// expect: 1.500,1.500,1.500,0.000,0.000

//= one point
#declare S = spline { cubic_spline 0, <1,2,3> } #declare T = spline { natural_spline 5, <1,2,3> }
#debug concat(vstr(3, S(9), ",", 0, 3), "\n")
#debug concat(vstr(3, T(0), ",", 0, 3), "\n")
// expect: 1.000,2.000,3.000
// expect: 1.000,2.000,3.000

//= two points
#declare S = spline { cubic_spline 0,<0,0,0> 1,<1,2,0> } #declare T = spline { quadratic_spline 0,<0,0,0> 1,<1,2,0> } #declare U = spline { natural_spline 0,<0,0,0> 1,<1,2,0> }
#debug concat(vstr(3, S(0), ",", 0, 3), "\n")
#debug concat(vstr(3, S(0.7), ",", 0, 3), "\n")
#debug concat(vstr(3, T(0.25), ",", 0, 3), "\n")
#debug concat(vstr(3, U(0.25), ",", 0, 3), "\n")
// expect: 0.500,1.000,0.000
// expect: 0.500,1.000,0.000
// expect: 0.250,0.500,0.000
// expect: 0.250,0.500,0.000

//= keys are sorted
#declare S = spline { 2, <2,0,0> 0, <0,0,0> 1, <1,5,0> }
#debug concat(vstr(3, S(0.5), ",", 0, 3), "\n")
#debug concat(vstr(3, S(1.5), ",", 0, 3), "\n")
// expect: 0.500,2.500,0.000
// expect: 1.500,2.500,0.000

//= a key again replaces its value
#declare S = spline { 0, <0,0,0> 1, <1,0,0> 2, <2,0,0> 1, <7,7,7> }
#debug concat(vstr(3, S(1), ",", 0, 3), "\n")
// expect: 7.000,7.000,7.000

//= but not that of the largest key
#declare S = spline { 0, <0,0,0> 1, <1,0,0> 1, <7,7,7> }
#debug concat(vstr(3, S(1), ",", 0, 3), "\n")
// expect: 1.000,0.000,0.000

//= evaluated as another kind
#declare S = spline { linear_spline 0, <0,0,0> 1, <1,2,0> 2, <4,1,0> 3, <9,5,0> }
#debug concat(vstr(3, S(1.5, cubic_spline), ",", 0, 6), "\n")
#debug concat(vstr(3, S(1.5, natural_spline), ",", 0, 6), "\n")
#debug concat(vstr(3, S(1.5, quadratic_spline), ",", 0, 6), "\n")
#debug concat(vstr(3, S(1.5), ",", 0, 6), "\n")
// expect: 2.250000,1.375000,0.000000
// expect: 2.200000,1.350000,0.000000
// expect: 2.250000,1.875000,0.000000
// expect: 2.500000,1.500000,0.000000

//= a copy with more
#declare S = spline { 0, <0,0,0> 1, <1,1,1> } #declare T = spline { S 2, <5,5,5> }
#debug concat(vstr(3, T(1.5), ",", 0, 3), "\n")
#debug concat(vstr(3, S(1.5), ",", 0, 3), "\n")
// expect: 3.000,3.000,3.000
// expect: 1.000,1.000,1.000

//= a copy by name
#declare S = spline { 0, <0,0,0> 1, <1,1,1> } #declare T = S;
#debug concat(vstr(3, T(0.5), ",", 0, 3), "\n")
// expect: 0.500,0.500,0.500

//= splines as arguments and elements
#declare S = spline { 0, <0,0,0> 1, <1,1,1> } #declare A = array[1] { S } #macro M(P) #debug concat(vstr(3,P(0.25),",",0,3),"\n") #end M(S)
#debug concat(vstr(3, A[0](0.5), ",", 0, 3), "\n")
// expect: 0.250,0.250,0.250
// expect: 0.500,0.500,0.500

//= no entries
#declare S = spline { linear_spline }
// error: D0202 at 1:14

//= rgb in an entry
#declare S = spline { 0, rgb 1 }
// error: D0201 at 1:26

//= too few arguments
#declare S = spline { 0, 1 } #declare A = S();
// error: D0202 at 1:43

//= last digits
#declare L = spline { linear_spline 0, <1,2.7> 1.1, <2.3,0> 2, <4.1,1> 3.7, <0,1.3> }
#debug concat(vstr(2, L(1.795), ",", 0, 18), "\n")
#debug concat(vstr(2, L(1.795, quadratic_spline), ",", 0, 18), "\n")
#debug concat(vstr(2, L(1.795, cubic_spline), ",", 0, 18), "\n")
#debug concat(vstr(2, L(1.795, natural_spline), ",", 0, 18), "\n")
// expect: 3.689999999999999503,0.772222222222222143
// expect: 3.631714772727271612,0.518213762626261509
// expect: 3.944911450287184707,0.765064662327706868
// expect: 3.850228236288375516,0.690366956452247327

//= a negative key needs a comma before it
#declare S = spline { -1, <1,0,0>, -0.5, <2,0,0>, 0, <3,0,0> } #debug concat(vstr(3, S(-0.75), ",", 0, 3), "\n")
// expect: 1.500,0.000,0.000

//= copies take another type
#declare S = spline { linear_spline 0, <0,0,0> 1, <1,2,0> 2, <4,1,0> 3, <9,5,0> } #declare T = spline { S cubic_spline } #debug concat(vstr(3, T(1.5), ",", 0, 6), "\n")
// expect: 2.250000,1.375000,0.000000

//= @ of one entry
#declare S = spline { @ 2, <1,2,3> } #debug concat(vstr(3, S(0), ",", 0, 3), vstr(3, S(5), ",", 0, 3), "\n")
// each: linear_spline quadratic_spline cubic_spline natural_spline
// expect: 1.000,2.000,3.0001.000,2.000,3.000

//= @ outside of its keys
#declare S = spline { @ 0, <0,0,0> 1, <1,2,0> 3, <4,1,0> } #debug concat(vstr(3, S(-9), ",", 0, 3), vstr(3, S(9), ",", 0, 3), "\n")
// each: linear_spline quadratic_spline natural_spline
// expect: 0.000,0.000,0.0004.000,1.000,0.000

//= a cubic spline outside of its inner keys
#declare S = spline { cubic_spline 0, <0,0,0> 1, <1,2,0> 3, <4,1,0> 4, <0,7,0> } #debug concat(vstr(3, S(-9), ",", 0, 3), vstr(3, S(0.5), ",", 0, 3), vstr(3, S(3.5), ",", 0, 3), vstr(3, S(2), ",", 0, 6), "\n")
// expect: 1.000,2.000,0.0001.000,2.000,0.0004.000,1.000,0.0003.125000,1.000000,0.000000

//= uneven keys in natural splines
#declare S = spline { natural_spline 0, <0,0,0> 1, <1,2,0> 3, <4,1,0> 4, <0,7,0> } #debug concat(vstr(3, S(0.5), ",", 0, 6), vstr(3, S(2), ",", 0, 6), vstr(3, S(3.9), ",", 0, 6), "\n")
// expect: 0.335938,1.328125,0.0000003.437500,0.750000,0.0000000.505188,6.263875,0.000000

//= uneven keys in quadratic splines
#declare S = spline { quadratic_spline 0, <0,0,0> 1, <1,2,0> 3, <4,1,0> 4, <0,7,0> } #debug concat(vstr(3, S(0.5), ",", 0, 6), vstr(3, S(2), ",", 0, 6), vstr(3, S(3.9), ",", 0, 6), "\n")
// expect: 0.458333,1.208333,0.0000002.333333,2.333333,0.0000000.565000,6.205000,0.000000

//= a string as a value
#declare S = spline { 0, "a" }
// error: D0204 at 1:26

//= an unknown type
#declare S = spline { b_spline 0, 1 }
// error: D0201 at 1:23
