// Language §3.4: random numbers.
#version 3.7;
global_settings { assumed_gamma 1 }

//= values of streams
#declare A = seed(0); #declare B = seed(-5); #declare C = seed(3);
#debug concat(str(A, 0, 0), "\n")
#debug concat(str(B, 0, 0), "\n")
#debug concat(str(C, 0, 0), "\n")
#debug concat(str(rand(A), 0, 15), "\n")
#debug concat(str(rand(A), 0, 15), "\n")
#debug concat(str(rand(A), 0, 15), "\n")
#debug concat(str(rand(B), 0, 15), "\n")
#debug concat(str(rand(C), 0, 15), "\n")
#debug concat(str(rand(B), 0, 15), "\n")
// expect: 0
// expect: 1
// expect: 2
// expect: 0.000002874294297
// expect: 0.466563684508801
// expect: 0.249070228833954
// expect: 0.890052870123194
// expect: 0.265972876983223
// expect: 0.363776116018131

//= the seed is truncated
#declare A = seed(3.9); #declare B = seed(3); #declare C = seed(-5.5); #declare D = seed(-5);
#debug concat(str((rand(A)=rand(B)), 0, 0), "\n")
#debug concat(str((rand(C)=rand(D)), 0, 0), "\n")
// expect: 1
// expect: 1

//= draws are made in the order of the text
#declare A = seed(7); #declare V = <rand(A),rand(A),rand(A)>; #declare B = rand(A)*2+rand(A);
#debug concat(vstr(3, V, ",", 0, 9), "\n")
#debug concat(str(B, 0, 9), "\n")
// expect: 0.953932881,0.610466280,0.166852136
// expect: 0.809080742

//= skipped branches draw nothing
#declare A = seed(7); #if (0) #declare B = rand(A); #end
#debug concat(str(rand(A), 0, 9), "\n")
// expect: 0.953932881

//= no such stream
#declare A = rand(5);
// error: D0302 at 1:14

//= seed of a large number
#declare A = seed(4294967295); #declare B = seed(3000000000);
#debug concat(str(rand(A), 0, 9), "\n")
#debug concat(str(rand(B), 0, 9), "\n")
// expect: 0.500002874
// expect: 0.500002874

//= a subscript draws once, whatever the element is looked at for
#declare S = seed(3);
#declare A = array[4] {1, 2, 3, 4}
#declare C = array[4] {rgb 1, rgb 0.5, rgb 0.2, rgb 0}
#macro M(Q) #end
#declare X = (A[int(rand(S)*4)]);
#debug concat(str(rand(S), 0, 9), "\n")
#if (A[int(rand(S)*4)]) #end
#if (A[int(rand(S)*4)] > 2) #end
#debug concat(str(rand(S), 0, 9), "\n")
M(A[int(rand(S)*4)] + 1)
#debug concat(str(rand(S), 0, 9), "\n")
#declare Ball = sphere { 0, A[int(rand(S)*4)] hollow A[int(rand(S)*4)] pigment { C[int(rand(S)*4)] } }
#debug concat(str(rand(S), 0, 9), "\n")
#declare V = <A[int(rand(S)*4)], A[int(rand(S)*4)]>;
#declare F = function { A[int(rand(S)*4)] }
#debug concat(str(rand(S), 0, 9), "\n")
// expect: 0.528236226
// expect: 0.823436552
// expect: 0.025859414
// expect: 0.714558860
// expect: 0.668461916
