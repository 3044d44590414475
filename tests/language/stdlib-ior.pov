// The standard includes: ior.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "ior.inc"

//= FnPovDispersion
#debug concat(str(FnPovDispersion(2.417, 0.044), 0, 9), "\n")
// expect: 1.018371608

//= indices and dispersions
#debug concat(str(iorCrownGlassBaK1, 0, 9), "\n")
#debug concat(str(dispCrownGlassBaK1, 0, 9), "\n")
#debug concat(str(iorDiamond, 0, 9), "\n")
#debug concat(str(dispDiamond, 0, 9), "\n")
#debug concat(str(iorGlass, 0, 9), "\n")
#debug concat(str(dispGlass, 0, 9), "\n")
#debug concat(str(iorOpal, 0, 9), "\n")
#debug concat(str(iorMossOpal, 0, 9), "\n")
#debug concat(str(iorTigersEye, 0, 9), "\n")
#debug concat(str(dispTigersEye, 0, 9), "\n")
#debug concat(str(dispFlintGlass, 0, 9), "\n")
// expect: 1.572410000
// expect: 1.012749208
// expect: 2.417000000
// expect: 1.018371608
// expect: 1.516730000
// expect: 1.010551641
// expect: 1.450000000
// expect: 1.450000000
// expect: 1.544000000
// expect: 1.008455285
// expect: 1.037735203
