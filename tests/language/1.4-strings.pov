// Language §1.4: strings.
#version 3.7;
global_settings { assumed_gamma 1 }

//= plain
#debug concat("abc", "\n")
#debug concat("", "\n")
#debug concat("a b", "\n")
// expect: abc
// expect:
// expect: a b

//= escapes
#debug concat("a\tb", "\n")
#debug concat("a\\b", "\n")
#debug concat("it\'s", "\n")
#debug concat("say \"x\"", "\n")
#debug concat("\u0041\u0062", "\n")
// expect: a	b
// expect: a\b
// expect: it's
// expect: say "x"
// expect: Ab

//= escapes by code
#debug concat(str(asc("\a"), 0, 0), "\n")
#debug concat(str(asc("\b"), 0, 0), "\n")
#debug concat(str(asc("\f"), 0, 0), "\n")
#debug concat(str(asc("\n"), 0, 0), "\n")
#debug concat(str(asc("\r"), 0, 0), "\n")
#debug concat(str(asc("\t"), 0, 0), "\n")
#debug concat(str(asc("\v"), 0, 0), "\n")
#debug concat(str(asc("\u20AC"), 0, 0), "\n")
#debug concat(str(asc("\\"), 0, 0), "\n")
// expect: 7
// expect: 8
// expect: 12
// expect: 10
// expect: 13
// expect: 9
// expect: 11
// expect: 8364
// expect: 92

//= unknown escape
#declare A = "\x";
// error: D0101 at 1:14

//= upper case U is no escape
#declare A = "\U0041";
// error: D0101 at 1:14

//= too few digits after \u
#declare A = "\u12";
// error: D0101 at 1:14

//= a string over two lines
#declare A = "one
two";
#debug concat(A, "\n")
#debug concat(str(strlen(A), 0, 0), "\n")
// expect: one
// expect: two
// expect: 7

//= a backslash before a line break
#declare A = "one\
two";
// error: D0104 at 1:14

//= bytes above 127 become blanks
#declare A = "aé";
#debug concat(concat("[",A,"]"), "\n")
#debug concat(str(strlen(A), 0, 0), "\n")
#debug concat(str(asc(substr(A,2,1)), 0, 0), "\n")
// expect: [a  ]
// expect: 3
// expect: 32

//= charset utf8 decodes
global_settings { charset utf8 }
#debug concat(str(strlen("é"), 0, 0), "\n")
#debug concat(str(asc("é"), 0, 0), "\n")
#debug concat(str(asc("€"), 0, 0), "\n")
#debug concat(str(strlen("𝄞"), 0, 0), "\n")
#debug concat(str(asc("𝄞"), 0, 0), "\n")
// expect: 1
// expect: 233
// expect: 8364
// expect: 1
// expect: 65533

//= charset ascii again
global_settings { charset utf8 } global_settings { charset ascii }
#debug concat(str(strlen("é"), 0, 0), "\n")
// expect: 2

//= file names keep backslashes
#fopen F "no\such.txt" read
// error: D0601 at 1:1

//= a string variable as file name has been translated
#declare N = "na\u006de.txt"; #fopen F N write #fclose F
#debug concat(str(file_exists("name.txt"), 0, 0), "\n")
// expect: 1

//= file_exists translates escapes
#debug concat(str(file_exists("da\u0074a.txt"), 0, 0), "\n")
// expect: 1

//= an unterminated string
#declare A = "one;
// error: D0104 at 2:18

//= an escaped quote is part of the text
#debug concat(str(strlen("\""), 0, 0), str(asc("\""), 0, 0), "\n")
// expect: 134

//= @ is no escape
#declare A = "\@";
// each: c e i z 0 1 8 ? % B N
// error: D0101 at 1:14

//= a backslash at the end swallows the quote
#fopen F "C:\dir\" read
// error: D0104 at 2:18

//= a literal of 255 characters
#declare A = "123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 12345";
#debug concat(str(strlen(A), 0, 0), "\n")
// expect: 255

//= a literal of 300 characters
#declare A = "123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 ";
#debug concat(str(strlen(A), 0, 0), "\n")
// beyond
// expect: 300

//= charset sys
global_settings { charset sys }
#debug concat("plain", "\n")
// beyond
// expect: plain

//= an unknown charset
global_settings { charset latin }
// error: D0203 at 1:27

//= \u with letters of both cases
#debug concat(str(asc("\u00e9"), 0, 0), ",", str(asc("\u00E9"), 0, 0), ",", str(asc("\uFFFF"), 0, 0), "\n")
// expect: 233,233,65535

//= include names keep backslashes
#include "no\name.inc"
// error: D0601 at 1:10
