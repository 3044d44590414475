// Language §4.5: loops.
#version 3.7;
global_settings { assumed_gamma 1 }

//= while
#declare I = 0; #while (I < 3) #debug concat(str(I,0,1)," ") #declare I = I + 1; #end
#debug "\n"
// expect: 0.0 1.0 2.0

//= while that never runs
#while (0) #debug "no" #end
#debug concat("fine", "\n")
// expect: fine

//= the condition is read anew
#declare N = 2; #declare I = 0; #while (I < N) #debug concat(str(I,0,1)," ") #declare I = I + 1; #if (I = 1) #declare N = 4; #end #end
#debug "\n"
// expect: 0.0 1.0 2.0 3.0

//= for, inclusive
#for (I, 1, 3) #debug concat(str(I,0,1)," ") #end #debug concat(str(I,0,1)," ")
#debug "\n"
// expect: 1.0 2.0 3.0 4.0

//= for with a step
#for (I, 0, 1, 0.25) #debug concat(str(I,0,1)," ") #end #for (I, 5, 1, -2) #debug concat(str(I,0,1)," ") #end
#debug "\n"
// expect: 0.0 0.2 0.5 0.8 1.0 5.0 3.0 1.0

//= for accumulates its steps
#declare N = 0; #for (I, 0, 1, .1) #declare N = N + 1; #end
#debug concat(str(N, 0, 15), "\n")
#debug concat(str(I, 0, 15), "\n")
// expect: 11.000000000000000
// expect: 1.100000000000000

//= for that never runs leaves the start
#for (I, 5, 1) #debug "no" #end
#debug concat(str(I, 0, 0), "\n")
// expect: 5

//= a fractional bound
#for (I, 0.5, 2.9) #debug concat(str(I,0,1)," ") #end
#debug "\n"
// expect: 0.5 1.5 2.5

//= the variable may be assigned
#for (I, 0, 10, 4) #debug concat(str(I,0,1)," ") #declare I = I + 1; #end
#debug "\n"
// expect: 0.0 5.0 10.0

//= break keeps the current value
#for (I, 1, 9) #if (I = 4) #break #end #end
#debug concat(str(I, 0, 0), "\n")
// expect: 4

//= a step of zero
#for (I, 1, 2, 0) #end
// error: D0302 at 1:1

//= the variable is local to the macro
#declare I = 77; #macro M() #for (I, 1, 2) #end #debug concat(str(I,0,0),"\n") #end M()
#debug concat(str(I, 0, 0), "\n")
// expect: 3
// expect: 77

//= the variable had another type
#declare I = "s"; #for (I, 1, 2) #debug concat(str(I,0,1)," ") #end
#debug "\n"
// expect: 1.0 2.0

//= end and step are evaluated once
#declare E = 3; #for (I, 1, E) #declare E = 1; #debug concat(str(I,0,1)," ") #end
#debug "\n"
// expect: 1.0 2.0 3.0

//= the variable is removed in the body
#for (I, 1, 3) #undef I #end
// error: D0204 at 1:1

//= the variable becomes a string
#for (I, 1, 3) #declare I = "s"; #end
// error: D0204 at 1:1

//= an element is no loop variable
#declare A = array[2] { 1, 2 } #for (A[0], 1, 2) #end
// error: D0101 at 1:39

//= nested loops
#for (I, 1, 2) #for (K, 1, I) #debug concat(str(I,0,0),str(K,0,0)," ") #end #end
#debug "\n"
// expect: 11 21 22

//= bounds within the tolerance
#for (I, 0, 1-1e-11, 1) #debug concat(str(I,0,1)," ") #end
#debug "\n"
// expect: 0.0 1.0

//= commas may be left out
#for (I 1 2) #debug concat(str(I,0,1)," ") #end
#debug "\n"
// expect: 1.0 2.0

//= the variable was a function
#declare F = function { x } #for (F, 1, 2) #end
// error: D0204 at 1:29

//= the variable was @
#declare F = @ #for (F, 1, 2) #debug concat(str(F, 0, 0), " ") #end #debug "\n"
// each: '"text"' 'sphere { 0, 1 }' 'array[2] { 1, 2 }' 'spline { 0, 1 }' '<1,2,3>;' 'pigment { rgb 1 }' 'transform { scale 2 }'
// expect: 1 2

//= the variable was a macro
#macro M() #end #for (M, 1, 2) #debug concat(str(M, 0, 0), " ") #end #debug "\n"
// error: D0204 at 1:17

//= the variable was a file
#fopen M "data.txt" read #for (M, 1, 2) #debug concat(str(M, 0, 0), " ") #end #debug "\n"
// error: D0204 at 1:26

//= no array elements
#declare A = array[2] #for (A[0], 1, 2) #end
// error: D0101 at 1:30

//= the variable is no float any more at the end
#for (I, 1, 2) #declare I = "s"; #end
// error: D0204 at 1:1

//= the variable is gone at the end
#for (I, 1, 2) #undef I #end
// error: D0204 at 1:1

//= a vector bound
#for (I, 1, x) #end
// error: D0204 at 1:13

//= commas
#for (I, 1, 2,) #debug "turn\n" #end
// expect: turn
// expect: turn

//= too few
#for (I, 1) #end
// error: D0101 at 1:11

//= the end is read once
#declare N = 2; #for (I, 1, N) #declare N = 5; #debug concat(str(I, 0, 0), " ") #end #debug "\n"
// expect: 1 2

//= while with a string
#while ("a") #end
// error: D0204 at 1:8

//= while with a vector
#while (x) #end
// error: D0204 at 1:8

//= a loop may not end in another file
#while (1) #include "count.inc" #break #end #debug "fine\n"
// expect: fine

//= tolerance at both ends
#for (I, 1, 2 - 1e-11) #debug concat(str(I, 0, 0), " ") #end #for (I, 2, 1 + 1e-11, -1) #debug concat(str(I, 0, 0), " ") #end #debug "\n"
// expect: 1 2 2 1
