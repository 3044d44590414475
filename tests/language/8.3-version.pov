// Language §8.3: what the language version changes.
#version 3.7;
global_settings { assumed_gamma 1 }

//= the variable
#version 3.6;
#debug concat(str(version, 0, 2), "\n")
#version 3.5;
#debug concat(str(version, 0, 2), "\n")
// expect: 3.60
// expect: 3.50

//= a missing semicolon below 3.5
#version 3.1; #declare A = 1 #declare B = 2
#debug concat(str(A+B, 0, 0), "\n")
// expect: 3

//= bytes above 127 below 3.5
#version 3.1;
#debug concat(str(asc("é"), 0, 0), "\n")
// expect: 195

//= the noise generator below 3.5
#version 3.1; #declare F = function { internal(76) }
#debug concat(str(F(0.3,1.7,-2.2), 0, 6), "\n")
// expect: 0.527186

//= versions have two decimals
#version 3.62;
#debug concat(str(version, 0, 4), "\n")
// expect: 3.6200

//= version @ is known
#version @; #debug concat(str(version, 0, 2), "\n")
// each: 3.7
// expect: 3.70

//= versions are stored in hundredths
#version 3.567; #debug concat(str(version, 0, 4), "\n") #version 3.001; #debug concat(str(version, 0, 4), "\n")
// expect: 3.5700
// expect: 3.0000

//= all versions up to ours
#version 0.5; #debug concat(str(version, 0, 2), " ") #version 1.0; #debug concat(str(version, 0, 2), " ") #version 1.5; #debug concat(str(version, 0, 2), " ") #version 2.2; #debug concat(str(version, 0, 2), " ") #version 3.1; #debug concat(str(version, 0, 2), " ") #version 3.6; #debug concat(str(version, 0, 2), "\n")
// expect: 0.50 1.00 1.50 2.20 3.10 3.60

//= a semicolon is missing at @
#version @; #declare A = 1 #declare B = 2 #debug concat(str(A + B, 0, 0), "\n")
// each: 1.5 2.0 3.0 3.1 3.49
// expect: 3

//= a semicolon is missing, and must not, at @
#version @; #declare A = 1
#declare B = 2;
// each: 3.5 3.6 3.7
// error: D0101 at 1:24

//= macros at @
#version @; #macro M() 5 #end #debug concat(str(M(), 0, 0), "\n")
// each: 3.1 3.5 3.7
// expect: 5

//= no macros at @
#version @;
#macro M() 5 #end
// each: 1.0 3.0 3.09
// error: D0306 at 2:8

//= the zero vector has no direction
#version 3.1; #debug concat(vstr(3, vnormalize(0), ",", 0, 0), "\n")
// expect: 0,0,0

//= the noise generator by version
#declare F = function { internal(76) } #declare A = F(0.3,1.7,-2.2); #version 3.1; #declare B = F(0.3,1.7,-2.2); #debug concat(str(A, 0, 6), " ", str(B, 0, 6), "\n")
// expect: 0.528851 0.527186

//= layered textures of old versions
#version 3.0; sphere { 0, 1 texture { pigment { rgb 1 } } texture { pigment { rgb 1 } } } #debug "fine\n"
// expect: fine

//= a union of one at @
#version @; union { sphere { 0, 1 } } #debug "fine\n"
// each: 1.0 3.0 3.7
// expect: fine

//= version 3.8 is beyond
#version 3.8; #debug concat(str(version, 0, 1), "\n")
// beyond
// expect: 3.8
