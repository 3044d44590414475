// Language §2.6: colours before assumed_gamma is set.
#version 3.7;

//= srgb needs assumed_gamma
#declare A = srgb 0.5;
// error: D0301 at 1:14
