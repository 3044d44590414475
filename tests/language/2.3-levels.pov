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
