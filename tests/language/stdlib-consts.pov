// The standard includes: consts.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "consts.inc"

//= constants
#debug concat(str(e, 0, 9), "\n")
#debug concat(str(Torus_Map, 0, 9), "\n")
#debug concat(str(Norm, 0, 9), "\n")
#debug concat(str(Hex_Blur3, 0, 9), "\n")
#debug concat(str(Diamond_Ior, 0, 9), "\n")
#debug concat(str(FoV_90, 0, 9), "\n")
#debug concat(str(FoV_45, 0, 9), "\n")
#debug concat(str(HENYEY_GREENSTEIN_SCATTERING, 0, 9), "\n")
#debug concat(str(Quartz_Glass_Dispersion, 0, 9), "\n")
#debug concat(vstr(3, o, " ", 0, 9), "\n")
#debug concat(vstr(3, xy, " ", 0, 9), "\n")
#debug concat(vstr(3, yz, " ", 0, 9), "\n")
#debug concat(vstr(3, xz, " ", 0, 9), "\n")
// expect: 2.718281828
// expect: 5.000000000
// expect: 4.000000000
// expect: 37.000000000
// expect: 2.470000000
// expect: 1.000046000
// expect: 2.414293000
// expect: 5.000000000
// expect: 1.012000000
// expect: 0.000000000 0.000000000 0.000000000
// expect: 1.000000000 1.000000000 0.000000000
// expect: 0.000000000 1.000000000 1.000000000
// expect: 1.000000000 0.000000000 1.000000000
