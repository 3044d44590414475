// Language §4.3: #declare, #local, #undef.
#version 3.7;
global_settings { assumed_gamma 1 }

//= declare overwrites the innermost visible name
#declare A = 1; #macro M() #local A = 2; #declare A = 3; #debug concat(str(A,0,1)," ") #end M() #debug concat(str(A,0,1)," ")
#debug "\n"
// expect: 3.0 1.0

//= declare inside a macro overwrites the caller's local
#macro In() #declare L = 9; #end #macro Out() #local L = 1; In() #debug concat(str(L,0,1)," ") #end Out()
#debug concat(str(defined(L),0,0),"\n")
// expect: 9.0 0

//= local shadows
#declare A = 1; #macro M() #local A = 2; #debug concat(str(A,0,1)," ") #end M() #debug concat(str(A,0,1)," ")
#debug "\n"
// expect: 2.0 1.0

//= a name may change its type
#declare A = 1; #declare A = "s"; #debug concat(A, "\n") #declare A = <1,2,3>;
#debug concat(vstr(3, A, ",", 0, 3), "\n")
// expect: s
// expect: 1.000,2.000,3.000

//= the old value stands on the right side
#declare A = 2; #declare A = <A,A+1,A*2>;
#debug concat(vstr(3, A, ",", 0, 3), "\n")
// expect: 2.000,3.000,4.000

//= an undeclared name on the right side
#declare A = Nothing;
// error: D0203 at 1:14

//= assignment copies arrays
#declare A = array[2] { 1, 2 } #declare B = A; #declare B[0] = 9;
#debug concat(str(A[0], 0, 0), "\n")
#debug concat(str(B[0], 0, 0), "\n")
// expect: 1
// expect: 9

//= local does not reach the elements of a global array
#declare A = array[2] { 1, 2 } #macro M() #local A[0] = 5; #end M()
#debug concat(str(A[0], 0, 0), "\n")
// expect: 1

//= declare does
#declare A = array[2] { 1, 2 } #macro M() #declare A[0] = 5; #end M()
#debug concat(str(A[0], 0, 0), "\n")
// expect: 5

//= components are no targets
#declare V = <1,2,3>; #declare V.x = 5;
// error: D0204 at 1:32

//= a function cannot be declared again
#declare F = function(A) { A } #declare F = function(A) { A*2 }
// error: D0204 at 1:41

//= a function can be removed and declared again
#declare F = function(A) { A } #undef F #declare F = function(A) { A*2 }
#debug concat(str(F(2), 0, 0), "\n")
// expect: 4

//= a macro name is no variable
#macro M() 1 #end #declare M = 1;
// error: D0204 at 1:28

//= a variable is no macro name
#declare A = 1; #macro A() 1 #end
// error: D0204 at 1:24

//= undef removes the innermost
#declare A = 1; #macro M() #local A = 2; #undef A #debug concat(str(A,0,1)," ") #end M() #debug concat(str(A,0,1)," ")
#debug "\n"
// expect: 1.0 1.0

//= undef from inside a macro
#declare A = 1; #macro M() #undef A #end M()
#debug concat(str(defined(A), 0, 0), "\n")
// expect: 0

//= undef of an unknown name
#undef Nothing
#debug concat("fine", "\n")
// expect: fine

//= undef of an element
#declare A = array[2] { 1, 2 } #undef A[0]
#debug concat(str(defined(A[0]), 0, 0), "\n")
#debug concat(str(defined(A[1]), 0, 0), "\n")
// expect: 0
// expect: 1

//= undef of a reserved word
#undef sphere
// error: D0201 at 1:1

//= copies of objects are independent
#declare A = sphere { 0, 1 } #declare B = object { A translate 5*x } #declare C = A
#debug concat(vstr(3, max_extent(A), ",", 0, 3), "\n")
#debug concat(vstr(3, max_extent(B), ",", 0, 3), "\n")
#debug concat(vstr(3, max_extent(C), ",", 0, 3), "\n")
// expect: 1.000,1.000,1.000
// expect: 6.000,1.000,1.000
// expect: 1.000,1.000,1.000

//= deprecated names work
#declare deprecated A = 1; #declare deprecated once "use B" B = 2;
#debug concat(str(A, 0, 0), "\n")
#debug concat(str(B, 0, 0), "\n")
#debug concat(str(B, 0, 0), "\n")
// expect: 1
// expect: 2
// expect: 2

//= an element that is out of range
#declare A = array[2] #declare A[2] = 1;
// error: D0302 at 1:34

//= an element of what is no array
#declare A = 1; #declare A[0] = 1;
// error: D0204 at 1:26

//= nothing on the right side
#declare A = ;
// error: D0201 at 1:14

//= no equals sign
#declare A 1;
// error: D0101 at 1:12

//= without #, also of an element
#declare A = array[2] { 1, 2 }
declare A[1] = 7;
declare B = 8;
#debug concat(str(A[1], 0, 0), str(B, 0, 0), "\n")
// expect: 78

//= without #, and one too late
declare# A = 1;
// error: D0201 at 1:8

//= @ may stand on the right
#declare A = @ #debug concat(str(defined(A), 0, 0), "\n")
// each: '1;' '<1,2>;' '<1,2,3>;' '<1,2,3,4>;' '<1,2,3,4,5>;' 'rgb 1;' '"s"' 'sphere { 0, 1 }' 'texture { pigment { rgb 1 } } texture { pigment { rgbt 1 } }'
// each: 'pigment { rgb 1 }' 'normal { bumps }' 'finish { phong 1 }' 'color_map { [0 rgb 0] [1 rgb 1] }' 'pigment_map { [0 rgb 0] [1 rgb 1] }' 'normal_map { [0 bumps] [1 dents] }'
// each: 'texture_map { [0 pigment { rgb 1 }] [1 pigment { rgb 0 }] }' 'slope_map { [0 <0,1>] [1 <1,0>] }' 'density_map { [0 rgb 0] [1 rgb 1] }' 'density { bozo }' 'media { emission 1 }'
// each: 'interior { ior 1.5 }' 'material { texture { pigment { rgb 1 } } }' 'camera { location 0 }' 'transform { scale 2 }' 'spline { 0, 1 }' 'array[2] { 1, 2 }' 'function { x }'
// each: 'fog { distance 1 }' 'rainbow { direction z width 1 angle 1 distance 1 }' 'sky_sphere { pigment { rgb 1 } }' 'light_source { 0, rgb 1 }' 'union { sphere { 0, 1 } box { 0, 1 } }' 'colour_map { [0 rgb 0] [1 rgb 1] }'
// expect: 1

//= @ is copied by name
#declare A = @ #declare B = A; #debug concat(str(defined(B), 0, 0), "\n")
// each: '"s"' 'sphere { 0, 1 }' 'texture { pigment { rgb 1 } }' 'pigment { rgb 1 }' 'normal { bumps }' 'finish { phong 1 }' 'color_map { [0 rgb 0] [1 rgb 1] }' 'pigment_map { [0 rgb 0] [1 rgb 1] }' 'normal_map { [0 bumps] [1 dents] }'
// each: 'texture_map { [0 pigment { rgb 1 }] [1 pigment { rgb 0 }] }' 'slope_map { [0 <0,1>] [1 <1,0>] }' 'interior { ior 1.5 }' 'material { texture { pigment { rgb 1 } } }' 'camera { location 0 }' 'transform { scale 2 }' 'spline { 0, 1 }' 'array[2] { 1, 2 }' 'function { x }' 'fog { distance 1 }' 'sky_sphere { pigment { rgb 1 } }' 'light_source { 0, rgb 1 }'
// expect: 1

//= a file handle cannot be declared
#fopen F "t30.txt" write #declare F = 5;
// error: D0204 at 1:35

//= an open file cannot be copied
#fopen F "data.txt" read #declare A = F;
// error: D0204 at 1:39

//= a macro cannot be copied
#macro M() #end #declare A = M;
// error: D0204 at 1:30

//= a macro is no variable, not even a local one
#macro M() #end #local M = 1;
// error: D0204 at 1:24

//= an array element keeps the type of its array
#declare A = array[2] { 1, 2 } #declare A[0] = @
// each: '"s"' 'sphere { 0, 1 }' '<1,2,3>;' 'array[1] { 1 }'
// error: D0204 at 1:41

//= directives of the oldest scenes have no sign
declare A = 5
#debug concat(str(A, 0, 0), "\n")
// expect: 5
// error: D0101 at 1:9

//= deprecated with its own words
#declare deprecated "do not" A = 1; #local deprecated once "do not" B = A; #debug concat(str(A + B, 0, 0), "\n")
// expect: 2

//= a pigment starts from the default
#default { pigment { rgb 0.5 } } #declare P = pigment { scale 2 } #declare F = function { pigment { P } } #debug concat(str(F(0,0,0).red, 0, 3), "\n")
// expect: 0.500

//= #local of an element of an outer array is lost, but of its kind
#declare A = array[2] { 1, 2 }
#macro M() #local A[0] = "text"; #end M()
// error: D0204 at 2:19
