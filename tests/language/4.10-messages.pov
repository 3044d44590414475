// Language §4.10: messages.
#version 3.7;
global_settings { assumed_gamma 1 }

//= debug adds no line break
#debug "a" #debug "b\n" #debug "c\n"
// expect: ab
// expect: c

//= empty lines
#debug "a\n\nb\n"
// expect: a
// expect:
// expect: b

//= debug of a number
#debug 1
// error: D0204 at 1:8

//= debug of an expression
#debug concat(concat("a",str(1,0,0)), "\n")
// expect: a1

//= error stops
#debug "before\n" #error "stop" #debug "after\n"
// expect: before
// error: D0304 at 1:19

//= warning, render and statistics go on
#warning "w" #render "r" #statistics "s" #debug concat("after", "\n")
// expect: rsafter

//= a comparison is no message
#debug ("a" = "b")
// error: D0204 at 1:9

//= @ of a number
#@
1
// each: warning error render statistics
// error: D0204 at 2:1

//= @ of nothing
#@
// each: debug warning error render statistics
// before
// error: D0202 at 3:1
