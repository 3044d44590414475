// Language §4.9: #include.
#version 3.7;
global_settings { assumed_gamma 1 }

//= a file
#include "locals.inc"
#debug concat(str(Outer, 0, 0), "\n")
// expect: 6

//= without its extension
#include "locals"
#debug concat(str(Outer, 0, 0), "\n")
// expect: 6

//= a name that is put together
#include concat("loc", "als", ".inc")
#debug concat(str(Outer, 0, 0), "\n")
// expect: 6

//= inside of a block
union { #include "spheres.inc" }
#debug concat("fine", "\n")
// expect: fine

//= inside of a vector
#declare V = < #include "numbers.inc" >;
#debug concat(vstr(3, V, ",", 0, 3), "\n")
// expect: 1.000,2.000,3.000

//= a missing file
#include "nothing.inc"
// error: D0601 at 1:10

//= twice
#include "count.inc" #include "count.inc"
#debug concat(str(Count, 0, 0), "\n")
// expect: 2

//= in a loop
#for (I, 1, 3) #include "count.inc" #end
#debug concat(str(Count, 0, 0), "\n")
// expect: 3

//= an include that includes itself
#include "itself.inc"
// before
// error: D0303 at itself.inc:1:10

//= a number is no file name
#include 5
// error: D0204 at 1:10

//= upper case suffixes
#include "upper" #debug concat(str(Upper, 0, 0), "\n")
// expect: 3

//= a file with its own suffix is tried first
#include "both.inc" #debug concat(str(Both, 0, 0), "\n")
// expect: 1

//= without the suffix, one is added first
#include "bare" #debug concat(str(Bare, 0, 0), "\n")
// expect: 2

//= a file that is written anew is read anew
#macro Through(Text) #fopen F "anew.inc" write #write (F, Text) #fclose F #include "anew.inc" #end
#declare A = Through("7"); #declare B = Through("2 + 3") * 2; #declare C = Through("9");
#debug concat(str(A, 0, 0), " ", str(B, 0, 0), " ", str(C, 0, 0), "\n")
// expect: 7 8 9
