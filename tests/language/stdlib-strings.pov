// The standard includes: strings.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "strings.inc"

//= CRGBFTStr
#debug concat(CRGBFTStr(rgbft <0.1,0.2,0.3,0.4,0.5>, 0, 3), "\n")
#debug concat(CRGBFTStr(rgb <1,0,0>, 8, 2), "\n")
// expect: color rgbft < 0.100, 0.200, 0.300, 0.400, 0.500>
// expect: color rgbft <     1.00,     0.00,     0.00,     0.00,     0.00>

//= CRGBStr
#debug concat(CRGBStr(rgb <0.1,0.2,0.3>, 0, 3), "\n")
// expect: color rgb <   0.100, 0.200, 0.300>

//= Str
#debug concat(Str(pi), "\n")
#debug concat(Str(-2), "\n")
// expect: 3.141593
// expect: -2.000000

//= VStr2D
#debug concat(VStr2D(<1,2.5>), "\n")
// expect: <1.000000,2.500000>

//= VStr
#debug concat(VStr(<1,2.5,-3>), "\n")
// expect: <1.000000,2.500000,-3.000000>

//= Vstr2D
#debug concat(Vstr2D(<1,2.5>, 0, 2), "\n")
// expect: <1.00,2.50>

//= Vstr
#debug concat(Vstr(<1,2.5,-3>, 6, 2), "\n")
// expect: <  1.00,  2.50, -3.00>

//= Triangle_Str
#declare S = Triangle_Str(x, y, <1,2,3>);
#debug concat(substr(S, 1, 50), "\n")
#debug concat(substr(S, 51, strlen(S) - 50), "\n")
// expect: triangle {<1.000000,0.000000,0.000000>,<0.000000,1
// expect: .000000,0.000000>,<1.000000,2.000000,3.000000>}

//= Smooth_Triangle_Str
#declare S = Smooth_Triangle_Str(x, z, y, z, <1,2,3>, y);
#debug concat(substr(S, 1, 60), "\n")
#debug concat(substr(S, 61, 60), "\n")
#debug concat(substr(S, 121, strlen(S) - 120), "\n")
// expect: smooth_triangle {<1.000000,0.000000,0.000000>,<0.000000,0.00
// expect: 0000,1.000000>,<0.000000,1.000000,0.000000>,<0.000000,0.0000
// expect: 00,1.000000>,<1.000000,2.000000,3.000000>,<0.000000,1.000000,0.000000>}

//= Parse_String
Parse_String("#declare A = 5;")
#debug concat(str(A, 0, 9), "\n")
#declare B = Parse_String("2 + 3") * 2;
#debug concat(str(B, 0, 9), "\n")
// expect: 5.000000000
// expect: 8.000000000

//= Parse_String of another text
#declare B = Parse_String("7"); #declare C = Parse_String("8");
#debug concat(str(B, 0, 9), "\n")
#debug concat(str(C, 0, 9), "\n")
// expect: 7.000000000
// expect: 8.000000000
