// Language §4.4: conditions.
#version 3.7;
global_settings { assumed_gamma 1 }

//= if, elseif, else
#if (1 = 1) #debug "one " #elseif (1 = 2) #debug "two " #elseif (1 = 3) #debug "three " #else #debug "else " #end
#if (2 = 1) #debug "one " #elseif (2 = 2) #debug "two " #elseif (2 = 3) #debug "three " #else #debug "else " #end
#if (3 = 1) #debug "one " #elseif (3 = 2) #debug "two " #elseif (3 = 3) #debug "three " #else #debug "else " #end
#if (4 = 1) #debug "one " #elseif (4 = 2) #debug "two " #elseif (4 = 3) #debug "three " #else #debug "else " #end
#debug "\n"
// expect: one two three else

//= ifdef and ifndef
#declare A = 1; #ifdef (A) #debug "a " #else #debug "b " #end #ifndef (A) #debug "c " #else #debug "d " #end #ifdef (Nothing) #debug "e " #elseif (1) #debug "f " #end
#debug "\n"
// expect: a d f

//= ifdef of elements
#declare A = array[2] #declare A[0] = 1; #ifdef (A[0]) #debug "set " #end #ifndef (A[1]) #debug "unset " #end
#debug "\n"
// expect: set unset

//= ifdef of an element out of range
#declare A = array[2] #ifdef (A[2]) #end
// error: D0302 at 1:33

//= ifdef of an element of nothing
#ifdef (Nothing[0]) #end
// error: D0203 at 1:9

//= a string is no condition
#if ("a") #end
// error: D0204 at 1:5

//= a comparison of strings is
#if ("a" = "a") #debug "yes\n" #end
// expect: yes

//= a vector is no condition
#if (x) #end
// error: D0204 at 1:5

//= elseif after else
#if (0) #else #elseif (1) #end
// error: D0101 at 1:16

//= stray else
#else
// error: D0102 at 1:1

//= stray end
#end
// error: D0102 at 1:1

//= stray case
#case (1)
// error: D0102 at 1:1

//= stray elseif
#elseif (1)
// error: D0102 at 1:1

//= switch
#switch (1) #case (1) #debug "one " #break #case (2) #case (3) #debug "two or three " #break #range (4, 6) #debug "four to six " #break #else #debug "else " #end
#switch (2) #case (1) #debug "one " #break #case (2) #case (3) #debug "two or three " #break #range (4, 6) #debug "four to six " #break #else #debug "else " #end
#switch (3) #case (1) #debug "one " #break #case (2) #case (3) #debug "two or three " #break #range (4, 6) #debug "four to six " #break #else #debug "else " #end
#switch (4) #case (1) #debug "one " #break #case (2) #case (3) #debug "two or three " #break #range (4, 6) #debug "four to six " #break #else #debug "else " #end
#switch (5.5) #case (1) #debug "one " #break #case (2) #case (3) #debug "two or three " #break #range (4, 6) #debug "four to six " #break #else #debug "else " #end
#switch (6) #case (1) #debug "one " #break #case (2) #case (3) #debug "two or three " #break #range (4, 6) #debug "four to six " #break #else #debug "else " #end
#switch (7) #case (1) #debug "one " #break #case (2) #case (3) #debug "two or three " #break #range (4, 6) #debug "four to six " #break #else #debug "else " #end
#switch (1+1e-11) #case (1) #debug "one " #break #case (2) #case (3) #debug "two or three " #break #range (4, 6) #debug "four to six " #break #else #debug "else " #end
#switch (6.1) #case (1) #debug "one " #break #case (2) #case (3) #debug "two or three " #break #range (4, 6) #debug "four to six " #break #else #debug "else " #end
#debug "\n"
// expect: one two or three two or three four to six four to six four to six else one else

//= switch falls through into else
#switch (1) #case (1) #debug "a " #case (2) #debug "b " #else #debug "c " #end
#debug "\n"
// expect: a b c

//= switch without a match
#switch (9) #case (1) #debug "a" #end
#debug concat("nothing", "\n")
// expect: nothing

//= range has no tolerance
#switch (2+1e-11) #range (1, 2) #debug "in" #else #debug "out" #end
#debug "\n"
// expect: out

//= case has
#switch (2+1e-11) #case (2) #debug "in" #else #debug "out" #end
#debug "\n"
// expect: inout

//= something before the first case
#switch (1) sphere { 0, 1 } #case (1) #end
// error: D0101 at 1:13

//= case expressions
#declare A = 3; #switch (A) #case (A - 1) #debug "no" #case (A*1) #debug "yes" #break #end
#debug "\n"
// expect: yes

//= switch on a string
#switch ("a") #case ("a") #end
// error: D0204 at 1:10

//= nested switches
#switch (1) #case (1) #switch (2) #case (2) #debug "in " #break #end #debug "out " #break #case (3) #debug "no" #end
#debug "\n"
// expect: in out

//= break leaves the nearest switch, loop or macro
#for (I,1,3) #switch (I) #case (2) #break #else #debug str(I,0,0) #end #end #for (I,1,9) #if (I > 2) #break #end #debug str(I,0,0) #end #macro M(A) #if (A) #break #end #debug "m" #end M(0) M(1)
#debug "\n"
// expect: 1312m

//= break outside of everything
#break
// error: D0102 at 1:1

//= a second else after a taken branch
#if (1) #debug "a" #else #debug "b" #else #debug "c" #end
#debug "\n"
// expect: a

//= ifdef of @
#ifdef (@) #debug "defined\n" #else #debug "undefined\n" #end
// each: Nothing sphere sin pi x
// expect: undefined

//= ifdef of @, which is there
#macro M() #end #declare F = function { x } #fopen H "data.txt" read #declare A = array[1] #declare E = array[1] { 1 } #ifdef (@) #debug "defined\n" #else #debug "undefined\n" #end
// each: M F H A E[0] image_width
// expect: defined

//= ifndef of a word
#ifndef (sphere) #debug "undefined\n" #end
// expect: undefined

//= stray range
#range (1, 2)
// error: D0102 at 1:1

//= stray break in an if
#if (1) #break #end
// error: D0102 at 1:9

//= else in a loop
#while (1) #else #end
// error: D0102 at 1:12

//= ends that are missing: @
@
// each: '#if (1)' '#ifdef (A)' '#while (0)' '#for (I, 1, 2)' '#switch (1) #case (1)' '#macro M()'
// before
// error: D0102 at 3:1

//= a condition without parentheses
#if 1 #end
// error: D0101 at 1:5

//= elseif after ifdef and ifndef
#ifndef (image_width) #debug "a" #elseif (0) #debug "b" #elseif (1) #debug "c" #else #debug "d" #end #debug "\n"
// expect: c

//= case expressions of a fall-through are read
#switch (1) #case (1) #debug "a" #case (1/2) #debug "b" #range (1, 2) #debug "c" #end #debug "\n"
// expect: abc

//= truth has a tolerance
#if (1e-11) #debug "true\n" #else #debug "false\n" #end #if (-1e-9) #debug "true\n" #end
// expect: false
// expect: true
