// Language §1.7: the semicolon.
#version 3.7;
global_settings { assumed_gamma 1 }

//= required after a float
#declare A = 1
#declare B = 2;
// error: D0101 at 1:10

//= required after a vector
#declare A = <1,2,3>
#declare B = 2;
// error: D0101 at 1:10

//= required after a colour
#declare A = rgb 1
#declare B = 2;
// error: D0101 at 1:10

//= only warned about below 3.5
#version 3.1;
#declare A = 1
#declare B = A + 1;
#debug concat(str(B, 0, 0), "\n")
// expect: 2

//= optional after a string
#declare A = "a" #declare B = "b";
#debug concat(A, "\n")
#debug concat(B, "\n")
// expect: a
// expect: b

//= optional after an object, a texture, an array
#declare A = sphere { 0, 1 } #declare B = sphere { 0, 1 };
#declare T = texture { pigment { rgb 1 } } #declare T = texture { pigment { rgb 1 } };
#declare C = array[1] { 1 } #declare C = array[1] { 2 };
#debug concat(str(C[0], 0, 0), "\n")
// expect: 2

//= two are accepted
#declare A = 1;; #declare B = <1,2,3>;;
#debug concat(str(A, 0, 0), "\n")
// expect: 1

//= three
#declare A = 1;;;
#debug concat(str(A, 0, 0), "\n")
// beyond
// expect: 1

//= after #undef
#declare A = 1; #undef A;
#debug concat(str(defined(A), 0, 0), "\n")
// beyond
// expect: 0

//= after #debug
#debug "a\n";
#debug concat("b", "\n")
// beyond
// expect: a
// expect: b

//= after #end
#if (1) #end;
#debug concat("b", "\n")
// beyond
// expect: b

//= after an object
sphere { 0, 1 };
#debug concat("b", "\n")
// beyond
// expect: b

//= after #version
#version 3.7; #version 3.6 #debug concat("b", "\n")
// expect: b

//= after an include that ends in a declare
#include "declares.inc";
#debug concat(str(From_include, 0, 0), "\n")
// expect: 42

//= @ is read with and without one
#declare A = @ #declare B = @; #debug concat("fine", "\n")
// each: '"text"' 'sphere { 0, 1 }' 'pigment { rgb 1 }' 'normal { bumps 1 }' 'finish { phong 1 }' 'texture { pigment { rgb 1 } }' 'transform { scale 2 }'
// each: 'spline { 0, 1 }' 'array[2] { 1, 2 }' 'color_map { [0 rgb 0] [1 rgb 1] }' 'camera { location 0 }' 'light_source { 0, rgb 1 }' 'fog { distance 1 }'
// each: 'material { }' 'interior { ior 1.5 }' 'sky_sphere { pigment { rgb 1 } }' 'media { }' 'rainbow { direction z width 1 angle 1 distance 1 }' 'pigment_map { [0 rgb 1] [1 rgb 0] }'
// each: 'normal_map { [0 bumps] [1 dents] }' 'texture_map { [0 pigment { rgb 1 }] [1 pigment { rgb 0 }] }' 'slope_map { [0 <0, 1>] [1 <1, 0>] }' 'density { bozo }' 'density_map { [0 bozo] [1 bozo] }'
// expect: fine

//= required after a local too
#local A = 1
#local B = 2;
// error: D0101 at 1:8

//= required after an element too
#declare A = array[2] #declare A[0] = 1
#declare B = 2;
// error: D0101 at 1:32

//= required at the end of the text too
#declare A = 1
// error: D0101 at 1:10

//= required between 3.1 and 3.5, else a warning: @
#version @; #declare A = <1,2,3>
#debug concat(vstr(3, A, ",", 0, 0), "\n")
// each: 3.1 3.2 3.49
// expect: 1,2,3

//= not wanted below 3.1: @
#version @; #declare A = 1 #declare B = 2
#debug concat(str(A, 0, 0), str(B, 0, 0), "\n")
// each: 1.0 2.0 3.0
// expect: 12

//= after #include
#include "count.inc"; #debug "after\n"
// expect: after

//= one more after a declaration, also in the body of a macro that is a value
#macro M(A) #local R = 0; ; #for (K, 1, 3) #local R = R + A/K; #end (R) #end
#debug concat(str(M(6), 0, 1), "\n")
// expect: 11.0
