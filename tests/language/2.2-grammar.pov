// Language §2.2: operators and their grammar.
#version 3.7;
global_settings { assumed_gamma 1 }

//= and and or have one precedence
#debug concat(str((1|0&0), 0, 0), "\n")
#debug concat(str((0&0|1), 0, 0), "\n")
#debug concat(str((1|1&0), 0, 0), "\n")
// expect: 0
// expect: 1
// expect: 0

//= relations chain to the left
#debug concat(str((1<2<3), 0, 0), "\n")
#debug concat(str((3>2>1), 0, 0), "\n")
#debug concat(str((1=1=1), 0, 0), "\n")
#debug concat(str((5>4=1), 0, 0), "\n")
// expect: 1
// expect: 0
// expect: 1
// expect: 1

//= products before sums before relations before logic
#debug concat(str(2+3*4, 0, 6), "\n")
#debug concat(str((2+3*4=14), 0, 6), "\n")
#debug concat(str((1<2&3<2), 0, 6), "\n")
#debug concat(str(8/2/2, 0, 6), "\n")
#debug concat(str(8-3-2, 0, 6), "\n")
#debug concat(str(2*3/4*2, 0, 6), "\n")
// expect: 14.000000
// expect: 1.000000
// expect: 0.000000
// expect: 2.000000
// expect: 3.000000
// expect: 3.000000

//= unary minus and not bind tighter than all binary
#debug concat(str(-2*3, 0, 0), "\n")
#debug concat(str(--2, 0, 0), "\n")
#debug concat(str(!5, 0, 0), "\n")
#debug concat(str(-!0, 0, 0), "\n")
#debug concat(str(!-0, 0, 0), "\n")
#debug concat(str((!1=0), 0, 0), "\n")
#debug concat(str(-2+3, 0, 0), "\n")
#debug concat(str(+3, 0, 0), "\n")
#debug concat(str(+-3, 0, 0), "\n")
#debug concat(str(2*-3, 0, 0), "\n")
#debug concat(str(2--3, 0, 0), "\n")
#debug concat(str(2+!0, 0, 0), "\n")
// expect: -6
// expect: 2
// expect: 0
// expect: -1
// expect: 1
// expect: 1
// expect: 1
// expect: 3
// expect: -3
// expect: -6
// expect: 5
// expect: 3

//= unary minus binds looser than a component
#declare A = <1,2,3>;
#debug concat(str(-A.y, 0, 0), "\n")
#debug concat(str(!A.x, 0, 0), "\n")
#debug concat(str(-A.z*2, 0, 0), "\n")
// expect: -2
// expect: 0
// expect: -6

//= both branches of ?: are evaluated
#declare S = seed(1); #declare A = (1 ? 2 : rand(S)); #declare T = seed(1); #declare U = rand(T);
#debug concat(str((rand(S) = rand(T)), 0, 0), "\n")
// expect: 1

//= an undefined name in the branch not taken
#declare A = (1 ? 2 : Nothing);
// error: D0203 at 1:23

//= both sides of & are evaluated
#declare A = (0 & Nothing);
// error: D0203 at 1:19

//= ?: nests to the right
#debug concat(str((1 ? 2 : 0 ? 3 : 4), 0, 0), "\n")
#debug concat(str((0 ? 2 : 0 ? 3 : 4), 0, 0), "\n")
#debug concat(str((0 ? 2 : 1 ? 3 : 4), 0, 0), "\n")
#debug concat(str((1 ? 0 ? 5 : 6 : 7), 0, 0), "\n")
// expect: 2
// expect: 4
// expect: 3
// expect: 6

//= components of all primaries
#macro M() <7,8,9> #end #declare A = <1,2,3>; #declare R = array[1] { <4,5,6> }
#debug concat(str((A+A).z, 0, 0), "\n")
#debug concat(str(M().y, 0, 0), "\n")
#debug concat(str(<1,2,3>.x, 0, 0), "\n")
#debug concat(str(vcross(x,y).z, 0, 0), "\n")
#debug concat(str(R[0].y, 0, 0), "\n")
#debug concat(str((A).z, 0, 0), "\n")
// expect: 6
// expect: 8
// expect: 1
// expect: 1
// expect: 5
// expect: 3

//= a component is not repeated
#declare A = <1,2,3>; #declare B = A.x.x;
// error: D0101 at 1:39

//= strings have only relations
#debug concat(str(("a"<"b"), 0, 0), "\n")
#debug concat(str(("a"="a"), 0, 0), "\n")
#debug concat(str(("a"!="a"), 0, 0), "\n")
#debug concat(str(("b">="a"), 0, 0), "\n")
#debug concat(str(("a"<="a"), 0, 0), "\n")
#debug concat(str(("a">"b"), 0, 0), "\n")
#debug concat(str(("a"="a"?5:6), 0, 0), "\n")
#debug concat(str(("A"<"a"), 0, 0), "\n")
#debug concat(str(("ab"<"b"), 0, 0), "\n")
#debug concat(str((""<"a"), 0, 0), "\n")
// expect: 1
// expect: 1
// expect: 0
// expect: 1
// expect: 1
// expect: 0
// expect: 5
// expect: 1
// expect: 1
// expect: 1

//= strings do not add
#declare A = "a" + "b";
// error: D0201 at 1:18

//= a string with a number
#declare A = ("a" = 1);
// error: D0204 at 1:21

//= a number with a string
#declare A = (1 = "a");
// error: D0204 at 1:19

//= a string where a number is wanted
#declare A = sin("a");
// error: D0204 at 1:18

//= an operand is missing
#declare A = 1 + ;
// error: D0101 at 1:18

//= an operand is missing in parentheses
#declare A = (1 * );
// error: D0101 at 1:19

//= a parenthesis is missing
#declare A = (1 + 2;
// before
// error: D0102 at 3:1

//= a conditional chooses between numbers only
#declare S = (1 ? "a" : "b");
// error: D0204 at 1:19

//= relations in a row, as arguments
#declare A = 1; #declare B = 3; #declare V = <1, 2, 3>;
#debug concat(str(int(A < B > 2), 0, 0), str(int(A < B > 0), 0, 0), str(int(!A < (V).u > B*2), 0, 0), "\n")
// expect: 010

//= more signs
#debug concat(str(- - 2, 0, 0), str(!!5, 0, 0), str(-+-2, 0, 0), str(2*-+3, 0, 0), "\n")
// expect: 212-6

//= = compares
#declare A = 3; #debug concat(str((A = 3), 0, 0), str((A = 4), 0, 0), "\n")
// expect: 10

//= a ?: without its second half
#declare A = (1 ? 2);
// error: D0101 at 1:19

//= ?: at the additive level
#declare A = 1 ? 2 : 3;
// error: D0101 at 1:18

//= the component of a function, a spline, a clock
#declare F = function { pigment { rgb <0.5,0.25,1> } } #declare S = spline { 0,<1,2,3> }
#debug concat(str(F(0,0,0).green, 0, 2), str(S(0).z, 0, 2), str(clock.x, 0, 2), "\n")
// expect: 0.253.000.00

//= division by zero in the branch not taken
#debug concat(str((1 ? 2 : 1/0), 0, 0), "\n")
// expect: 2

//= an index error in the branch not taken
#declare R = array[1] { 1 } #declare A = (1 ? 2 : R[1]);
// error: D0302 at 1:53

//= both sides of a string relation
#declare A = ("a" = 5);
// error: D0204 at 1:21

//= an array element and a string function in a relation
#declare R = array[1] { "b" } #debug concat(str((R[0] = "b"), 0, 0), str((strlwr("B") = R[0]), 0, 0), str((chr(65) < "B"), 0, 0), "\n")
// expect: 111
