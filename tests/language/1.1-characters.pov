// Language §1.1: characters and encoding.
#version 3.7;
global_settings { assumed_gamma 1 }

//= white space of all kinds
#declare	A=1
;
#debug concat(str(A, 0, 6), "\n")
// expect: 1.000000

//= control-Z is white space
#declare A = 1;#debug concat(str(A, 0, 6), "\n")
// expect: 1.000000

//= a byte above 127 is an error outside strings and comments
#declare A = é1;
// error: D0103 at 1:14

//= a byte above 127 is an error in a skipped branch too
#if (0) é #end
// error: D0103 at 1:9

//= meaningless punctuation is harmless in a skipped branch
#if (0) @ $ ` ~ ? \ % ' #end
#debug concat("fine", "\n")
// expect: fine

//= meaningless punctuation is an error when executed
@
// error: D0201 at 1:1

//= a byte above 127 is fine in a comment
// é
/* ü */
#debug concat("fine", "\n")
// expect: fine

//= <= is one token
#declare A = <=5>;
// error: D0101 at 1:18

//= >= never closes a vector
#declare A = <1,2>=3;
// error: D0101 at 1:18

//= there is no ==
#declare A = (1 == 1);
// error: D0101 at 1:18

//= there is no &&
#declare A = (1 && 1);
// error: D0101 at 1:18

//= there is no <>
#declare A = (1 <> 2);
// error: D0101 at 1:18

//= there is no power operator
#declare A = 2^3;
// error: D0101 at 1:15

//= any line ending
#include "endings.inc"
#debug concat(str(Unix, 0, 0), str(Dos, 0, 0), str(Mac, 0, 0), "\n")
// expect: 123

//= the end of a file ends its last line
#include "no_end.inc"
#debug concat(str(Last, 0, 0), "\n")
// expect: 7

//= @ stands for itself nowhere
#declare Q = 1; Q @
// each: $ ~ ` "'" % "\\" ^
// error: D0201 at 1:17

//= ! with a blank is not !=
#declare A = (1 ! = 2);
// error: D0101 at 1:19

//= the longest match
#debug concat(str((2<=2), 0, 0), str((1>=2), 0, 0), str((1!=2), 0, 0), "\n")
// expect: 101
