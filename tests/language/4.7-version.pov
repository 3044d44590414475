// Language §4.7: #version.
#version 3.7;
global_settings { assumed_gamma 1 }

//= the idiom of the standard includes
#declare Old = version; #version 3.5;
#debug concat(str(version, 0, 2), "\n")
#version Old;
#debug concat(str(version, 0, 2), "\n")
// expect: 3.50
// expect: 3.70

//= expressions
#version 3 + 0.6;
#debug concat(str(version, 0, 2), "\n")
// expect: 3.60

//= a version beyond ours
#version 4.0;
// error: D0306 at 1:1

//= unofficial versions
#version unofficial patch 1.0;
// error: D0203 at 1:21

//= a number alone
#version 3.6 #debug concat(str(version, 0, 2), "\n")
// expect: 3.60

//= an expression in parentheses
#version (3.5 + 0.1); #debug concat(str(version, 0, 2), "\n")
// expect: 3.60

//= a version of a string
#version "3.5";
// error: D0204 at 1:10
