// Language §1.2: comments.
#version 3.7;
global_settings { assumed_gamma 1 }

//= comments stand between any tokens
#declare /* a */ A // b
= /* c
 d */ 1 /**/ ;
#debug concat(str(A, 0, 6), "\n")
// expect: 1.000000

//= block comments nest
/* a /* b */ c */#debug concat(str(1, 0, 6), "\n")
// expect: 1.000000

//= strings are not recognised in comments
/* "*/ #debug concat("out", "\n")
// expect: out

//= an unterminated comment
/* a /* b */
// before
// error: D0104 at 1:1

//= comments in skipped branches
#if (0) /* #end */ // #end
#end #debug concat("after", "\n")
// expect: after

//= comments in macros
#macro M() /* #end */ 5 // #end
#end #debug concat(str(M(), 0, 6), "\n")
// expect: 5.000000
