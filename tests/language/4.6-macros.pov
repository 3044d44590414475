// Language §4.6: macros.
#version 3.7;
global_settings { assumed_gamma 1 }

//= parameters and value
#macro Add(A, B) (A + B) #end
#debug concat(str(Add(1,2), 0, 0), "\n")
#debug concat(str(Add(1,2)*2, 0, 0), "\n")
// expect: 3
// expect: 6

//= no parameters
#macro Five() 5 #end
#debug concat(str(Five(), 0, 0), "\n")
// expect: 5

//= parentheses are needed in the definition
#macro M 1 #end
// error: D0101 at 1:10

//= and in the call
#macro M() 1 #end #declare A = M;
// error: D0204 at 1:32

//= the body takes part in the expression
#macro M(a,b) a+b #end
#debug concat(str(2*M(1,2), 0, 0), "\n")
#debug concat(str(M(1,2)*2, 0, 0), "\n")
#debug concat(str(10-M(1,2), 0, 0), "\n")
#debug concat(str(-M(1,2), 0, 0), "\n")
#debug concat(str(abs(M(-3,1)), 0, 0), "\n")
#debug concat(str((M(1,2) < 4), 0, 0), "\n")
// expect: 4
// expect: 5
// expect: 11
// expect: 1
// expect: 2
// expect: 1

//= a component of the last operand
#macro W() x+<1,2,3> #end
#debug concat(str((W().y), 0, 0), "\n")
// error: D0204 at 2:19

//= a body of operators
#macro Plus() +1 #end
#debug concat(str((1 Plus()), 0, 0), "\n")
#debug concat(str((2*3 Plus()), 0, 0), "\n")
// expect: 2
// expect: 7

//= a body of modifiers, of part of an object
#macro Mods() scale 2 translate x #end #macro Head() sphere { 0, #end #declare O = box { -1, 1 Mods() } #declare Q = Head() 1 }
#debug concat(vstr(3, max_extent(O), ",", 0, 3), "\n")
#debug concat(vstr(3, max_extent(Q), ",", 0, 3), "\n")
// expect: 3.000,2.000,2.000
// expect: 1.000,1.000,1.000

//= an empty body
#macro Nil() #end Nil() sphere { 0, 1 Nil() }
#debug concat("fine", "\n")
// expect: fine

//= too few arguments
#macro M(a,b) 1 #end #declare A = M(1);
// error: D0202 at 1:35

//= too many arguments
#macro M(a) 1 #end #declare A = M(1,2);
// error: D0202 at 1:33

//= an undeclared argument
#macro M(a) 1 #end #declare A = M(Nothing);
// error: D0203 at 1:35

//= a macro that is not defined
Nothing(1)
// error: D0201 at 1:1

//= a macro is defined when its definition is executed
M() #macro M() #end
// error: D0201 at 1:1

//= redefinition
#macro M() 1 #end #macro M(A) (A*2) #end
#debug concat(str(M(4), 0, 0), "\n")
// expect: 8

//= by reference
#macro M(P) #declare P = P + 1; #end #declare A = 1; M(A)
#debug concat(str(A, 0, 0), "\n")
// expect: 2

//= by reference with #local
#macro M(P) #local P = 6; #end #declare A = 1; M(A)
#debug concat(str(A, 0, 0), "\n")
// expect: 6

//= by value: parentheses, signs, sums, components
#macro M(P) #declare P = 6; #end #declare A = 1; #declare V = <1,2,3>; M((A)) M(+A) M(A+0) M(V.x)
#debug concat(str(A, 0, 0), "\n")
#debug concat(vstr(3, V, ",", 0, 3), "\n")
// expect: 1
// expect: 1.000,2.000,3.000

//= by reference: an element
#macro M(P) #declare P = 6; #end #declare A = array[2] { 1, 2 } M(A[1])
#debug concat(str(A[0], 0, 0), "\n")
#debug concat(str(A[1], 0, 0), "\n")
// expect: 1
// expect: 6

//= by reference: an array
#macro M(P) #declare P[0] = 6; #end #declare A = array[2] { 1, 2 } M(A)
#debug concat(str(A[0], 0, 0), "\n")
// expect: 6

//= by reference: a string, a vector, a colour
#macro S(P) #declare P = "new"; #end #macro W(P) #declare P = <4,5,6>; #end #declare A = "old"; #declare B = <1,2,3>; #declare C = rgb 1; S(A) W(B)
#debug concat(A, "\n")
#debug concat(vstr(3, B, ",", 0, 3), "\n")
// expect: new
// expect: 4.000,5.000,6.000

//= by reference: the type may change
#macro M(P) #declare P = "text"; #end #declare A = 1; M(A)
#debug concat(A, "\n")
// expect: text

//= through two calls
#macro In(P) #declare P = 6; #end #macro Out(Q) In(Q) #end #declare A = 1; Out(A)
#debug concat(str(A, 0, 0), "\n")
// expect: 6

//= a function by value
#declare F = function(A) { A*3 } #macro M(P) #debug concat(str(P(2),0,0),"\n") #end M(F)
// expect: 6

//= blocks as arguments
#macro M(O) object { O translate x } #end #declare Q = M(sphere { 0, 1 })
#debug concat(vstr(3, max_extent(Q), ",", 0, 3), "\n")
// expect: 2.000,1.000,1.000

//= colours as arguments
#macro M(C) #debug concat(vstr(5,C,",",0,1),"\n") #end M(rgb 1) M(color red 1) M(rgbt <1,.5,.2,.3>)
// expect: 1.0,1.0,1.0,0.0,0.0
// expect: 1.0,0.0,0.0,0.0,0.0
// expect: 1.0,0.5,0.2,0.0,0.3

//= strings as arguments
#macro M(S) #debug concat(S,"\n") #end M("a") M(concat("a","b")) M(str(1,0,1))
// expect: a
// expect: ab
// expect: 1.0

//= parameters shadow
#declare A = 1; #macro M(A) #debug concat(str(A,0,0)," ") #end M(2) #debug concat(str(A,0,1)," ")
#debug "\n"
// expect: 2 1.0

//= arguments are evaluated before the parameters exist
#declare A = 1; #macro M(A, B) #debug concat(str(B,0,0),"\n") #end M(5, A)
// expect: 1

//= break returns
#macro M(A) #if (A) #break #end #debug "end " #end M(0) M(1) M(0)
#debug "\n"
// expect: end end

//= recursion
#macro Fact(N) #if (N < 2) 1 #else (N*Fact(N - 1)) #end #end
#debug concat(str(Fact(5), 0, 0), "\n")
#debug concat(str(Fact(0), 0, 0), "\n")
// expect: 120
// expect: 1

//= recursion without end
#macro M() M() #end M()
// error: D0303 at 1:12

//= a macro call without value as operand
#macro M() #end #declare A = 1 + M();
// error: D0202 at 1:30

//= a macro defined by a macro
#macro Def() #macro Inner(A) (A + 1) #end #end Def()
#debug concat(str(Inner(1), 0, 0), "\n")
// expect: 2

//= calls as arguments of calls
#macro M(A) (A*2) #end
#debug concat(str(M(M(M(1))), 0, 0), "\n")
// expect: 8

//= directives need to balance in a body
#macro M() #if (1) #end
// before
// error: D0102 at 3:1

//= braces do not
#macro Open() union { #end #macro Close() } #end Open() sphere { 0, 1 } box { 0, 1 } Close()
#debug concat("fine", "\n")
// expect: fine

//= below version 3.1 macros are errors
#version 3.0; #macro M() #end
// error: D0306 at 1:22

//= an argument before a sign is no number
#macro Turned(A) object { A rotate x } #end
#macro Show(A, V, W) #debug concat(vstr(3, V, " ", 0, 0), "; ", vstr(3, W, " ", 0, 0), "\n") #end
#declare Ball = sphere { 0, 1 };
Show(Turned(Ball) -2*y, <1,2,3>)
Show(Ball -2*y, <1,2,3>)
// expect: -0 -2 -0; 1 2 3
// expect: -0 -2 -0; 1 2 3

//= a macro of a value in a loop sees what it is called with, not what lies beneath
#declare T = 5;
#macro Twice(A) #local T = 2; (A*T) #end
#for (I, 1, 2)
  #declare R = Twice(T) + Twice(I);
  #debug concat(str(R, 0, 3), " ", str(T, 0, 0), "\n")
#end
// expect: 12.000 5
// expect: 14.000 5

//= macros of values inside one another, by reference and by value
#macro Inner(A, B) #local C = A - B; (C*C) #end
#macro Outer(V, A) #local C = Inner(A, V.x) + Inner(V.y, A); (C + V.z) #end
#declare P = <1, 2, 3>;
#for (I, 1, 2)
  #declare R = Outer(P, I);
  #debug concat(str(R, 0, 3), " ", vstr(3, P*Outer(P + x, 2*I), " ", 0, 2), "\n")
#end
// expect: 4.000 3.00 6.00 9.00
// expect: 4.000 11.00 22.00 33.00

//= a macro that changes between two turns of a loop
#for (I, 1, 3)
  #if (I = 2) #undef M #end
  #macro M(A) (A*I + (I > 1)) #end
  #declare R = M(10);
  #debug concat(str(R, 0, 3), "\n")
#end
// expect: 10.000
// expect: 21.000
// expect: 31.000

//= the body of a macro reaches into the formula around its call
#macro Sum(A, B) A + B #end
#for (I, 1, 2)
  #declare R = 2*Sum(I, 3);
  #declare Q = Sum(I, 3)*2;
  #debug concat(str(R, 0, 1), " ", str(Q, 0, 1), "\n")
#end
// expect: 5.0 7.0
// expect: 7.0 8.0

//= strings in loops keep what was assigned before
#declare A = "one";
#macro Tag(S, N) #local L = strlen(S); concat(S, "-", str(L + N, 0, 0)) #end
#for (I, 1, 3)
  #declare B = A;
  #declare A = concat(Tag(A, I), "!");
  #declare C = strupr(substr(A, 1, 3));
  #debug concat(A, " ", B, " ", C, " ", vstr(2, <I, 1/3>, "/", -4, 1), "\n")
#end
// expect: one-4! one ONE 01.0/00.3
// expect: one-4!-8! one-4! ONE 02.0/00.3
// expect: one-4!-8!-12! one-4!-8! ONE 03.0/00.3

//= lengths of vectors in loops: floats fill, short vectors are padded
#declare U = <1, 2>;
#declare F = 3;
#for (I, 1, 2)
  #declare V = F*U + <1, 1, 1>;
  #declare W = (F + U) + <1, 1, 1>;
  #declare K = rgb F*0.1 + U.x;
  #declare L = -V + (U < 2) + y*I;
  #debug concat(vstr(3, V, " ", 0, 1), ", ", vstr(3, W, " ", 0, 1), ", ", vstr(5, K, " ", 0, 1), "\n")
  #debug concat(vstr(3, L, " ", 0, 1), " ", str(vlength(L), 0, 3), " ", str(vdot(U, V), 0, 3), "\n")
#end
// expect: 4.0 7.0 1.0, 5.0 6.0 1.0, 1.3 1.3 1.3 0.0 0.0
// expect: -3.0 -6.0 -1.0 6.782 18.000
// expect: 4.0 7.0 1.0, 5.0 6.0 1.0, 1.3 1.3 1.3 0.0 0.0
// expect: -3.0 -5.0 -1.0 5.916 18.000

//= an argument that is worked out may not be a local of the caller
#declare G = 7;
#macro Keep(A) #local G = A + 1; (G) #end
#for (I, 1, 2)
  #declare R = Keep(G);
  #debug concat(str(R, 0, 0), " ", str(G, 0, 0), "\n")
#end
// expect: 8 7
// expect: 8 7

//= an undeclared argument of a macro of a value
#macro One(A) (1) #end
#for (I, 1, 2)
  #declare R = One(Nothing);
#end
// error: D0203 at 3:20
// error: D0203 at 3:20

//= by reference: @
#macro M(P) #declare P = 5; #end #declare A = @ M(A) #debug concat(str(A, 0, 0), "\n")
// each: '1;' '<1,2>;' '<1,2,3>;' '<1,2,3,4>;' 'rgb 1;' '"s"' 'spline { 0, 1 }' 'array[2] { 1, 2 }' 'sphere { 0, 1 }' 'texture { pigment { rgb 1 } }' 'pigment { rgb 1 }' 'transform { scale 2 }' 'finish { phong 1 }'
// expect: 5

//= by value: @
#declare V = <7,8,9>; #declare F = function { x } #declare A = 1; #macro M(P) #declare P = 5; #end M(@) #debug concat(str(A, 0, 0), vstr(3, V, ",", 0, 0), "\n")
// each: A+0 +A (A) -A V.x F(1,2,3) 3 '"s"' 'sphere { 0, 1 }' 'A*1' '<1,2,3>'
// expect: 17,8,9

//= by reference: an element does not change its type
#macro M(P) #declare P = "text"; #end #declare A = array[2] { 1, 2 } M(A[1])
#debug concat(str(A[0], 0, 0), "\n")
// before
// expect: 1
// error: D0204 at 1:22

//= a local of a macro in the argument
#macro In() #local L = 3; L #end #macro Out(P) #declare P = 6; #debug concat(str(P, 0, 0), "\n") #end Out(In())
// expect: 6

//= a file as an argument
#fopen F "data.txt" read #macro M(P) #end M(F)
// error: D0204 at 1:45

//= @ as argument
#macro M(P) #debug concat(str(defined(P), 0, 0), "\n") #end M(@)
// each: 1 '<1,2>' '<1,2,3>' 'rgb 1' '"s"' 'sphere { 0, 1 }' 'texture { pigment { rgb 1 } }' 'pigment { rgb 1 }' 'normal { bumps }' 'finish { phong 1 }' 'color_map { [0 rgb 0] [1 rgb 1] }' 'array[2] { 1, 2 }' 'function { x }' 'spline { 0, 1 }' 'transform { scale 2 }' 'camera { location 0 }' 'interior { ior 1.5 }' 'material { texture { pigment { rgb 1 } } }'
// expect: 1

//= a macro of map entries
#macro E(A, B) [A rgb 0] [B rgb 1] #end sphere { 0, 1 pigment { gradient x color_map { E(0, 0.5) E(0.5, 1) } } } #debug "fine\n"
// expect: fine

//= a macro of modifiers
#macro T(A) scale A translate x #end #declare O = sphere { 0, 1 T(2) } #debug concat(vstr(3, max_extent(O), ",", 0, 0), "\n")
// expect: 3,2,2

//= a macro of nothing
#macro N() #end sphere { 0, 1 N() } N() #debug concat("fine", "\n")
// expect: fine

//= a parameter named twice
#macro M(A, A) #debug str(A, 0, 0) #end M(1, 2)
// expect: 2

//= a reserved word is no macro
#macro rotate() #end
// error: D0101 at 1:8
