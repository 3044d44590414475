// Language §4.1: the execution model.
#version 3.7;
global_settings { assumed_gamma 1 }

//= blanks and lines between # and its word
# declare A = 1; #
declare B = 2;
#debug concat(str(A, 0, 0), "\n")
#debug concat(str(B, 0, 0), "\n")
// expect: 1
// expect: 2

//= directive words are case sensitive
#Declare A = 1;
// error: D0101 at 1:2

//= an unknown word is an error when executed
#unknown
// error: D0101 at 1:2

//= an unknown word in a skipped branch
#if (0) #unknown #end #debug concat("fine", "\n")
// expect: fine

//= undefined names and nonsense in a skipped branch
#if (0) Nothing { <<< ] #declare = ; sphere ( #end #debug concat("fine", "\n")
// expect: fine

//= strings in a skipped branch must end
#if (0) "abc #end
// error: D0104 at 2:18


//= nested directives are counted in a skipped branch
#if (0) #while (x) #for (a) #switch #macro #ifdef #end #end #end #end #end #else #debug concat("else", "\n") #end
// expect: else

//= a directive as operand of a declare
#declare A = #if (1) 1; #else 2; #end
#debug concat(str(A, 0, 0), "\n")
// expect: 1

//= a directive inside of a vector
#declare V = <1, #if (0) 2 #else 7 #end, 3>;
#debug concat(vstr(3, V, ",", 0, 3), "\n")
// expect: 1.000,7.000,3.000

//= a directive among operators in parentheses
#declare P = (1 #if (1) +2 #end);
#debug concat(str(P, 0, 0), "\n")
// expect: 3

//= a directive between the operands of an object
sphere { 0, 1 #if (1) +1 #end } box { 0 #declare Q = 4; 1 }
#debug concat(str(Q, 0, 0), "\n")
// expect: 4

//= a macro that chooses among values
#macro M(X) #if (X) 1 #else 2 #end #end
#debug concat(vstr(3, <M(1),M(0),3>, ",", 0, 3), "\n")
// expect: 1.000,2.000,3.000

//= a macro with statements and a value at the end
#macro M() #local R = 5; R #end #declare A = M();
#debug concat(str(A, 0, 0), "\n")
// expect: 5

//= recursion to a depth of 90
#macro R(N) #if (N > 0) (1 + R(N - 1)) #else 0 #end #end
#debug concat(str(R(90), 0, 0), "\n")
// expect: 90

//= directives in the arguments of a function
#declare A = max(1, #if (1) 5, #end 3);
#debug concat(str(A, 0, 0), "\n")
// expect: 5

//= a # before what cannot be a directive means nothing
#declare S = "s"; #declare V = <1, 2, 3>; #declare F = function(X) { X }
#debug concat("[" # S, # "]", vstr(3, # V, ",", 0, 0), str(# F(4) # * 2, 0, 0), "\n")
sphere { 0, # (1) }
// expect: [s]1,2,38
