// Language §4.2: scopes.
#version 3.7;
global_settings { assumed_gamma 1 }

//= a local of the main file is global
#local A = 1; #macro M() #debug concat(str(A,0,0),"\n") #end M()
// expect: 1

//= names are looked up through the callers
#macro In() #debug concat(str(L,0,0),"\n") #end #macro Out() #local L = 7; In() #end Out()
// expect: 7

//= locals end with their macro
#macro M() #local L = 7; #end M()
#debug concat(str(defined(L), 0, 0), "\n")
// expect: 0

//= what a macro declares is global
#macro M() #declare G = 7; #end M()
#debug concat(str(G, 0, 0), "\n")
// expect: 7

//= locals of an include end with it
#include "locals.inc"
#debug concat(str(defined(Inner), 0, 0), "\n")
#debug concat(str(Outer, 0, 0), "\n")
#debug concat(str(Seen, 0, 0), "\n")
// expect: 0
// expect: 6
// expect: 1

//= an include inside of a macro shares its locals
#macro M() #local L = 3; #include "locals.inc" #debug concat(str(defined(Inner),0,0),str(Seen,0,0),"\n") #end M()
// expect: 01

//= macros are global
#macro M() #macro Inner() 5 #end #end M()
#debug concat(str(Inner(), 0, 0), "\n")
// expect: 5

//= a macro defined in an include
#include "locals.inc"
#debug concat(str(From_file(3), 0, 0), "\n")
// expect: 4

//= conditionals and loops open no scope
#if (1) #local A = 1; #end #for (I,1,2) #local B = I; #end
#debug concat(str(A, 0, 0), "\n")
#debug concat(str(B, 0, 0), "\n")
#debug concat(str(I, 0, 0), "\n")
// expect: 1
// expect: 2
// expect: 3

//= names that #read makes are global
#macro M() #fopen H "data.txt" read #read (H, Got) #fclose H #end M()
#debug concat(str(Got, 0, 0), "\n")
// expect: 1

//= a local in an include is not the caller's
#local Inner = 5; #include "locals.inc" #debug concat(str(Inner, 0, 0), "\n")
// expect: 5

//= a macro in a macro sees the locals of both
#macro B() #debug concat(str(P, 0, 0), str(Q, 0, 0), "\n") #end #macro A(P) #local Q = 2; B() #end A(1)
// expect: 12
