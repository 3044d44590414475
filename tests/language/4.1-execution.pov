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

//= a directive among the operators of a declare
#declare A = #if (1) 1 #else 2 #end;
// beyond

//= a macro that chooses, in a declare
#macro M(X) #if (X) 1 #else 2 #end #end #declare A = M(1);
#debug concat(str(A, 0, 0), "\n")
// beyond
// expect: 1

//= a macro that chooses, as an operand
#macro M(X) #if (X) 1 #else 2 #end #end #declare O = sphere { 0, 1 scale M(0) } #debug concat(str(max_extent(O).x, 0, 0), "\n")
// expect: 2

//= an unterminated comment in a skipped branch
#if (0) /* #end
// error: D0104 at 1:9

//= all the branch directives are counted in a skipped branch
#if (0) #if (1) #end #ifdef (A) #end #ifndef (A) #end #while (1) #end #for (I, 1, 2) #end #switch (1) #case (1) #end #macro X() #end #else #debug "else\n" #end
// expect: else

//= directives in the middle of @
#declare A = @ #debug concat("fine", "\n")
// each: 'color_map { [0 rgb 0] #if (1) [1 rgb 1] #end }' 'union { sphere { 0, 1 } #for (I, 1, 2) box { 0, I } #end }' 'spline { 0, 1 #for (I, 1, 3) I, I*I #end }' 'pigment { #if (1) rgb 1 #else bozo #end }' 'texture { #declare Q = 5; pigment { rgb 1 } finish { #if (0) phong 1 #end ambient 1 } }' 'transform { #if (1) scale 2 #end rotate 3 }'
// expect: fine

//= the limit of parameters
#macro M(a1,a2,a3,a4,a5,a6,a7,a8,a9,a10,a11,a12,a13,a14,a15,a16,a17,a18,a19,a20,a21,a22,a23,a24,a25,a26,a27,a28,a29,a30,a31,a32,a33,a34,a35,a36,a37,a38,a39,a40,a41,a42,a43,a44,a45,a46,a47,a48,a49,a50,a51,a52,a53,a54,a55) #debug concat(str(a55, 0, 0), "\n") #end
M(1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55)
// expect: 55

//= deep braces
union { union { union { union { union { union { union { union { union { union { sphere { 0, 1 } box { 0, 1 } } box { 0, 1 } } box { 0, 1 } } box { 0, 1 } } box { 0, 1 } } box { 0, 1 } } box { 0, 1 } } box { 0, 1 } } box { 0, 1 } } box { 0, 1 } }
#debug "fine\n"
// expect: fine

//= includes to a depth of 30
#declare Depth = 0; #include "deeper.inc" #debug concat(str(Depth, 0, 0), "\n")
// expect: 29
