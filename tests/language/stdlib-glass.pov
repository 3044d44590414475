// The standard includes: glass.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "glass.inc"

//= I_Glass_Exp and I_Glass_Sqr
sphere { 0, 1 interior { I_Glass_Exp(5) } } sphere { 0, 1 interior { I_Glass_Sqr(5) } }
#debug "read\n"
// expect: read

//= colours
#local Out = Col_Glass_Old; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = Col_Amber_09; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = Col_Red_01; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#local Out = Col_Glass_Bluish; #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
// expect: 0.800000012 0.899999976 0.850000024 0.850000024 0.000000000
// expect: 0.529399991 0.243100002 0.152899995 0.000000000 0.000000000
// expect: 0.850000024 0.100000001 0.200000003 0.000000000 0.000000000
// expect: 0.899999976 0.939999998 1.000000000 0.800000012 0.000000000
