// Language §1.5: identifiers.
#version 3.7;
global_settings { assumed_gamma 1 }

//= letters, digits and underscores
#declare _a1B = 3; #declare _A1b = 4; #declare __ = 5;
#debug concat(str(_a1B, 0, 0), "\n")
#debug concat(str(_A1b, 0, 0), "\n")
#debug concat(str(__, 0, 0), "\n")
// expect: 3
// expect: 4
// expect: 5

//= case matters
#declare Sphere = 1; #declare SPHERE = 2;
#debug concat(str(Sphere, 0, 0), "\n")
#debug concat(str(SPHERE, 0, 0), "\n")
// expect: 1
// expect: 2

//= a reserved word cannot be declared
#declare sphere = 1;
// error: D0101 at 1:10

//= a constant cannot be declared
#declare pi = 3;
// error: D0101 at 1:10

//= a vector constant cannot be declared
#declare x = 3;
// error: D0101 at 1:10

//= a reserved word is no macro name
#macro box() 1 #end
// error: D0101 at 1:8

//= a reserved word is no macro parameter
#macro M(red) 1 #end
// error: D0101 at 1:10

//= a reserved word is no loop variable
#for (clock, 0, 1) #end
// error: D0101 at 1:7

//= a very long name
#declare nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn = 7;
#debug concat(str(nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn, 0, 0), "\n")
// expect: 7

//= a digit does not begin a name
#declare 1a = 1;
// error: D0101 at 1:10

//= a word and a point
#declare A = <1,2,3>; #debug concat(str(A . y, 0, 0), "\n")
// expect: 2
