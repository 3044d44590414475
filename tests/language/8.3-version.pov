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
