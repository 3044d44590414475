// Language §4.11: files.
#version 3.7;
global_settings { assumed_gamma 1 }

//= write and read
#fopen F "t1.txt" write #write (F, 1.5, ",", <1,2,3>, ",\"a\\tb\",\n", 7, ",\n") #fclose F
#fopen F "t1.txt" read #read (F, A, B, C, D)
#debug concat(str(A, 0, 6), "\n")
#debug concat(str(D, 0, 6), "\n")
#debug concat(vstr(3, B, ",", 0, 3), "\n")
#debug concat(C, "\n")
#debug concat(str(defined(F), 0, 0), "\n")
// expect: 1.500000
// expect: 7.000000
// expect: 1.000,2.000,3.000
// expect: a	b
// expect: 1

//= append
#fopen F "t2.txt" write #write (F, "1,") #fclose F #fopen F "t2.txt" append #write (F, "2,") #fclose F
#fopen F "t2.txt" read #read (F, A, B)
#debug concat(str(A, 0, 0), "\n")
#debug concat(str(B, 0, 0), "\n")
// expect: 1
// expect: 2

//= the end of a file closes it
#fopen F "t3.txt" write #write (F, "1,2") #fclose F #fopen F "t3.txt" read #read (F, A)
#debug concat(str(A, 0, 0), "\n")
#debug concat(str(defined(F), 0, 0), "\n")
#read (F, B)
#debug concat(str(B, 0, 0), "\n")
#debug concat(str(defined(F), 0, 0), "\n")
// expect: 1
// expect: 1
// expect: 2
// expect: 0

//= with a comma at the end it takes one more read
#fopen F "t4.txt" write #write (F, "1,2,") #fclose F #fopen F "t4.txt" read #read (F, A, B)
#debug concat(str(A, 0, 0), "\n")
#debug concat(str(B, 0, 0), "\n")
#debug concat(str(defined(F), 0, 0), "\n")
#read (F, C)
#debug concat(str(defined(F), 0, 0), "\n")
// expect: 1
// expect: 2
// expect: 1
// expect: 0

//= the loop over a file
#fopen F "data.txt" read #declare N = 0; #while (defined(F)) #read (F, A) #declare N = N + 1; #end
#debug concat(str(N, 0, 0), "\n")
// expect: 6

//= values of all kinds
#fopen F "data.txt" read #read (F, A, B, C, D, E)
#debug concat(str(A, 0, 6), "\n")
#debug concat(str(B, 0, 6), "\n")
#debug concat(str(E, 0, 6), "\n")
#debug concat(vstr(3, C, ",", 0, 3), "\n")
#debug concat(D, "\n")
// expect: 1.000000
// expect: -2.500000
// expect: 4.000000
// expect: 1.000,2.000,3.000
// expect: text

//= blanks lose the next value
#fopen F "t5.txt" write #write (F, "1 2 3 4") #fclose F #fopen F "t5.txt" read #read (F, A, B)
#debug concat(str(A, 0, 0), "\n")
#debug concat(str(B, 0, 0), "\n")
// expect: 1
// expect: 3

//= vectors lose their bracket
#fopen F "t6.txt" write #write (F, <1,2,3>, "\n", <4,5,6>, "\n") #fclose F #fopen F "t6.txt" read #read (F, A) #read (F, B)
#debug concat(vstr(3, A, ",", 0, 3), "\n")
#debug concat(str(B, 0, 0), "\n")
// expect: 1.000,2.000,3.000
// expect: 4

//= into elements
#declare A = array[2] { 0, 0 } #fopen F "t7.txt" write #write (F, "5,6,") #fclose F #fopen F "t7.txt" read #read (F, A[0], A[1])
#debug concat(str(A[0], 0, 0), "\n")
#debug concat(str(A[1], 0, 0), "\n")
// expect: 5
// expect: 6

//= names in data
#fopen F "t8.txt" write #write (F, "pi,") #fclose F #fopen F "t8.txt" read #read (F, A)
// before
// error: D0301 at 1:83

//= numbers are written with six digits
#fopen F "t9.txt" write #write (F, "\"", 1/3, " ", 1e10, " ", 123456789, " ", <1/3,1,2>, "\",") #fclose F #fopen F "t9.txt" read #read (F, A)
#debug concat(A, "\n")
// expect: 0.333333 1e+10 1.23457e+08 <0.333333,1,2>

//= vectors of all lengths
#fopen F "t10.txt" write #write (F, "\"", <1,2>, <1,2,3>, <1,2,3,4>, <1,2,3,4,5>, "\",") #fclose F #fopen F "t10.txt" read #read (F, A)
#debug concat(concat("[",A,"]"), "\n")
// expect: [<1,2> <1,2,3> <1,2,3,4> <1,2,3,4,5> ]

//= bytes
#fopen F "t11.txt" write #write (F, "\"", uint8 65, sint8 66.4, uint16be 16707, uint16le 17475, sint16be 17734, sint16le 18248, sint32be 1212827714, sint32le 1296911693, "\",") #fclose F #fopen F "t11.txt" read #read (F, A)
#debug concat(A, "\n")
// expect: ABACCDEFHGHJHBMMMM

//= formats hold up to the next comma
#fopen F "t12.txt" write #write (F, "\"", uint8 <65,66,67>, 68, uint8 69 70, "\",") #fclose F #fopen F "t12.txt" read #read (F, A)
#debug concat(A, "\n")
// expect: ABC68EF

//= bytes are clamped and rounded
#fopen F "t13.txt" write #write (F, "\"", uint8 65.5, uint8 64.5, uint8 90.49, "\",") #fclose F #fopen F "t13.txt" read #read (F, A)
#debug concat(A, "\n")
// expect: BAZ

//= reading from a file that is being written
#fopen F "t14.txt" write #read (F, A)
// error: D0301 at 1:33

//= writing to a file that is being read
#fopen F "data.txt" read #write (F, 1)
// error: D0301 at 1:34

//= opening a name that is taken
#declare F = 1; #fopen F "data.txt" read
// error: D0301 at 1:24

//= opening a file that is not there
#fopen F "nothing.txt" read
// error: D0601 at 1:1

//= closing what is not open
#fclose F
#debug concat("fine", "\n")
// expect: fine

//= reading from what is not open
#read (F, A)
// error: D0203 at 1:8

//= writing to what is not open
#write (F, 1)
// error: D0203 at 1:9

//= handles are global
#macro M() #fopen F "data.txt" read #end M() #read (F, A)
#debug concat(str(A, 0, 0), "\n")
// expect: 1

//= handles are defined names
#fopen F "data.txt" read
#debug concat(str(defined(F), 0, 0), "\n")
#fclose F
#debug concat(str(defined(F), 0, 0), "\n")
// expect: 1
// expect: 0

//= @ in hexadecimal
#fopen F "t31.txt" write #write (F, "\"", @ 26729, "\",") #fclose F #fopen F "t31.txt" read #read (F, A) #debug concat(A, "\n")
// each: sint16be uint16be
// expect: hi

//= little ends
#fopen F "t32.txt" write #write (F, "\"", sint16le 26984, uint16le 26984, sint32le 1735289202, "\",") #fclose F #fopen F "t32.txt" read #read (F, A) #debug concat(A, "\n")
// expect: hihiring

//= values beyond their type
#fopen F "t33.txt" write #write (F, "\"", uint8 65 66.6, sint8 1000 97, "\",") #fclose F #fopen F "t33.txt" read #read (F, A) #debug concat(A, "\n")
// expect: ACa

//= strings in data keep their escapes
#fopen F "t34.txt" write #write (F, "\"a\\\"b\\\\c\",") #fclose F #fopen F "t34.txt" read #read (F, A) #debug concat(A, "\n")
// expect: a"b\c

//= signed numbers and vectors of 2 to 5
#fopen F "t35.txt" write #write (F, "-1, +2, <1,-2>, <1,2,3>, <1,2,3,4>, <1,2,3,4,5>,") #fclose F #fopen F "t35.txt" read #read (F, A, B, C, D, E, G)
#debug concat(str(A, 0, 0), str(B, 0, 0), vstr(2, C, ",", 0, 0), vstr(3, D, ",", 0, 0), vstr(4, E, ",", 0, 0), vstr(5, G, ",", 0, 0), "\n")
// expect: -121,-21,2,31,2,3,41,2,3,4,5

//= comments in data
#fopen F "t36.txt" write #write (F, "1, // one\n2, /* two */ 3,") #fclose F #fopen F "t36.txt" read #read (F, A, B, C) #debug concat(str(A, 0, 0), str(B, 0, 0), str(C, 0, 0), "\n")
// expect: 123

//= what is read replaces another type
#declare A = "old"; #fopen F "t37.txt" write #write (F, "<1,2,3>,7,") #fclose F #fopen F "t37.txt" read #read (F, A) #debug concat(vstr(3, A, ",", 0, 0), "\n") #read (F, A) #debug concat(str(A, 0, 0), "\n")
// expect: 1,2,3
// expect: 7

//= a name that holds an object is not read into
#declare A = sphere { 0, 1 } #fopen F "data.txt" read #read (F, A)
// error: D0204 at 1:65

//= expressions in data
#fopen F "t38.txt" write #write (F, "1+1,") #fclose F #fopen F "t38.txt" read #read (F, A, B) #debug concat(str(A, 0, 0), str(B, 0, 0), "\n")
// expect: 11

//= an object is not written
#declare O = sphere { 0, 1 } #fopen F "t39.txt" write #write (F, O)
// error: D0204 at 1:66

//= a mode that is none
#fopen F "t40.txt" update
// error: D0203 at 1:20

//= a file opened again after it was closed
#fopen F "t41.txt" write #write (F, "1,") #fclose F #fopen F "t41.txt" write #write (F, "2,") #fclose F #fopen F "t41.txt" read #read (F, A) #debug concat(str(A, 0, 0), "\n")
// expect: 2

//= append to what is not there
#fopen F "t42.txt" append #write (F, "5,") #fclose F #fopen F "t42.txt" read #read (F, A) #debug concat(str(A, 0, 0), "\n")
// expect: 5

//= an empty file
#fopen F "t43.txt" write #fclose F #fopen F "t43.txt" read #read (F, A) #debug concat(str(defined(A), 0, 0), str(defined(F), 0, 0), "\n")
// expect: 10

//= a value in parentheses after the name of the file
#fopen F "durer-language-name.txt" write #write (F (2), ",", 3, ",") #fclose F
#fopen F "durer-language-name.txt" read #read (F, A, B)
#debug concat(str(A, 0, 0), str(B, 0, 0), "\n")
// expect: 23
