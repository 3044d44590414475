// Language §2.3: which level is read where.
#version 3.7;
global_settings { assumed_gamma 1 }

//= parentheses, conditions, one-argument functions take relations
#if (1<2) #debug "if\n" #end #while (1<2) #debug "while\n" #break #end #switch (1<2) #case (3>2) #debug "case\n" #end
#debug concat(str(sin(0<1), 0, 6), "\n")
#debug concat(str(abs(1>2), 0, 6), "\n")
#debug concat(str(floor(2=2), 0, 6), "\n")
// expect: if
// expect: while
// expect: case
// expect: 0.841471
// expect: 0.000000
// expect: 1.000000

//= a declare does not
#declare A = 1<2;
// error: D0101 at 1:17

//= parentheses help
#declare A = (1<2);
#debug concat(str(A, 0, 0), "\n")
// expect: 1

//= a macro argument does not
#macro M(P) #debug "called" #end M(1<2)
// beyond
// expect: called

//= a macro argument in parentheses
#macro M(P) #debug concat(str(P,0,0),"\n") #end M((1<2))
// expect: 1

//= a switch word does not
sphere { 0, 1 hollow 1=1 }
// error: D0201 at 1:23

//= a switch word with parentheses
sphere { 0, 1 hollow (1=1) }
#debug concat("fine", "\n")
// expect: fine

//= two-argument functions do not
#declare A = mod(1<2, 1);
// beyond

//= variadic functions do not
#declare A = max(1<2, 1);
// beyond

//= vector functions do not
#declare A = vlength(x<y);
// beyond

//= components do not
#declare A = <1<2, 0>;
// error: D0101 at 1:22

//= subscripts do not
#declare R = array[2] { 1, 2 } #declare A = R[1<2];
// error: D0101 at 1:50

//= juxtaposed vectors need no comma
#declare V = <0,1,2>; box { 0 <1,1,1> } sphere { V <2,2,2>.x }
#debug concat("fine", "\n")
// expect: fine

//= a vector after a keyword parameter
camera { location <0,0,-5> look_at <0,0,0> }
#debug concat("fine", "\n")
// expect: fine

//= loop bounds do not
#for (I, 0<1, 2) #end
// error: D0101 at 1:16

//= colours are read at the full level
#declare A = rgb 2>1; #declare B = rgb (1<2); #declare C = color 2>1; #declare D = rgbf 2=2; #declare E = rgbt 1 ? 0.5 : 2; #declare G = srgb 1>0; #declare H = color 1 ? 0.5 : 2;
#debug concat(vstr(5, A, ",", 0, 1), "\n")
#debug concat(vstr(5, B, ",", 0, 1), "\n")
#debug concat(vstr(5, C, ",", 0, 1), "\n")
#debug concat(vstr(5, D, ",", 0, 1), "\n")
#debug concat(vstr(5, E, ",", 0, 1), "\n")
#debug concat(vstr(5, G, ",", 0, 1), "\n")
#debug concat(vstr(5, H, ",", 0, 1), "\n")
// expect: 1.0,1.0,1.0,0.0,0.0
// expect: 1.0,1.0,1.0,0.0,0.0
// expect: 1.0,1.0,1.0,1.0,1.0
// expect: 1.0,1.0,1.0,1.0,0.0
// expect: 0.5,0.5,0.5,0.0,0.5
// expect: 1.0,1.0,1.0,0.0,0.0
// expect: 0.5,0.5,0.5,0.5,0.5

//= full level after color words and in a bare colour
#declare A = rgb 1<=2; #debug concat(vstr(3, A, ",", 0, 0), "\n")
#declare B = rgb 0 ? 1 : 0.5; #debug concat(vstr(3, B, ",", 0, 1), "\n")
light_source { 0, rgb 1 = 1 } background { rgb 1 > 0 }
// expect: 1,1,1
// expect: 0.5,0.5,0.5

//= functions of one argument take a relation
#debug concat("abs ", str(abs(0<1), 0, 3), "\n")
#debug concat("acos ", str(acos(0<1), 0, 3), "\n")
#debug concat("asin ", str(asin(0<1), 0, 3), "\n")
#debug concat("atan ", str(atan(0<1), 0, 3), "\n")
#debug concat("ceil ", str(ceil(0<1), 0, 3), "\n")
#debug concat("cos ", str(cos(0<1), 0, 3), "\n")
#debug concat("cosh ", str(cosh(0<1), 0, 3), "\n")
#debug concat("degrees ", str(degrees(0<1), 0, 3), "\n")
#debug concat("exp ", str(exp(0<1), 0, 3), "\n")
#debug concat("floor ", str(floor(0<1), 0, 3), "\n")
#debug concat("int ", str(int(0<1), 0, 3), "\n")
#debug concat("ln ", str(ln(0<1), 0, 3), "\n")
#debug concat("radians ", str(radians(0<1), 0, 3), "\n")
#debug concat("sin ", str(sin(0<1), 0, 3), "\n")
#debug concat("sinh ", str(sinh(0<1), 0, 3), "\n")
#debug concat("sqrt ", str(sqrt(0<1), 0, 3), "\n")
#debug concat("tan ", str(tan(0<1), 0, 3), "\n")
#debug concat("tanh ", str(tanh(0<1), 0, 3), "\n")
#debug concat("asinh ", str(asinh(0<1), 0, 3), "\n")
#debug concat("acosh ", str(acosh(0<1), 0, 3), "\n")
#debug concat("log ", str(log(0<1), 0, 3), "\n")
// expect: abs 1.000
// expect: acos 0.000
// expect: asin 1.571
// expect: atan 0.785
// expect: ceil 1.000
// expect: cos 0.540
// expect: cosh 1.543
// expect: degrees 57.296
// expect: exp 2.718
// expect: floor 1.000
// expect: int 1.000
// expect: ln 0.000
// expect: radians 0.017
// expect: sin 0.841
// expect: sinh 1.175
// expect: sqrt 1.000
// expect: tan 1.557
// expect: tanh 0.762
// expect: asinh 0.881
// expect: acosh 0.000
// expect: log 0.000

//= atanh takes a relation
#debug concat(str(atanh(1<0), 0, 3), "\n")
// expect: 0.000

//= the value of a spline entry takes a relation
#declare S = spline { 0, (2>1) 1, 2 } #debug concat(str(S(0).x, 0, 0), "\n")
// expect: 1

//= the key of a spline entry does not
#declare S = spline { 0<1, 1 }
// error: D0101 at 1:30

//= elseif and case take relations
#if (0) #elseif (1 < 2) #debug "elseif\n" #end #switch (1) #case (1 < 2) #debug "case\n" #end
// expect: elseif
// expect: case

//= range does not
#switch (1) #range (0 < 1, 2) #debug "no" #end
// error: D0101 at 1:29

//= #write does not
#fopen F "w1.txt" write #write (F, 1 < 2)
// beyond

//= a transformation does not
sphere { 0, 1 translate x < y }
// error: D0101 at 1:31

//= @ does not
#declare A = @(1 < 2, 1);
// each: atan2 div mod pow min bitwise_and bitwise_or bitwise_xor
// beyond

//= select does not
#declare A = select(1 < 2, 1, 2);
// beyond

//= vdot does not
#declare A = vdot(x < y, y);
// beyond

//= vcross and vrotate do not
#declare A = @(x < y, y);
// each: vcross vrotate
// beyond

//= a keyword parameter does not
camera { angle 30 < 40 }
// error: D0101 at 1:24

//= an array size does not
#declare A = array[1 < 2]
// error: D0101 at 1:25

//= #version does not
#version 3 < 4;
// error: D0201 at 1:12

//= a function argument does not
#declare F = function(A) { A } #declare B = F(1 < 2);
// beyond

//= below version 1.5 one factor is read
#version 1.0; sphere { 0, 1 scale 2 *3 }
// error: D0201 at 1:35

//= from version 1.5 on an expression
#version 1.5; #declare S = sphere { 0, 1 scale 2 *3 } #debug concat(str(max_extent(S).x, 0, 0), "\n")
// expect: 6

//= below version 1.5 vectors take factors
#version 1.0; #debug concat(vstr(3, <1 -1 2>, ",", 0, 0), vstr(3, <1 +2 3>, " ", 0, 0), vstr(3, <(1+2) 3 4>, " ", 0, 0), "\n")
// expect: 1,-1,21 2 33 3 4

//= below version 1.5 operands are factors
#version 1.0; box { -1 -2 } sphere { <0 0 0> 1 rotate -30*x }
// error: D0201 at 1:55

//= below version 1.5 parentheses and conditions are full
#version 1.49; #declare A = (1 + 2) #if (1 + 2 > 2) #debug concat(str(A, 0, 0), "\n") #end
// expect: 3
