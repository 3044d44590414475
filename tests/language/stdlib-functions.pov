// The standard includes: functions.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

//= eval_pigment
#local Out = eval_pigment(pigment { bozo color_map { [0 rgb 0] [1 rgb <1,0.5,0.2>] } }, <1.3,2.2,3.1>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
#declare P = pigment { rgbft <0.1,0.2,0.3,0.4,0.5> }
#local Out = eval_pigment(P, x); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
// expect: 0.279193759 0.139596879 0.055838753 0.000000000 0.000000000
// expect: 0.100000001 0.200000003 0.300000012 0.400000006 0.500000000

//= f_sine_wave
#debug concat(str(f_sine_wave(.3,2,1.5), 0, 9), "\n")
// expect: 1.975376681

//= f_scallop_wave
#debug concat(str(f_scallop_wave(1.3,2,1.5), 0, 9), "\n")
// expect: 0.312868930

//= f_hexagon
#local Out = f_hexagon(0.3,0,0.7); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
// expect: 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000

//= f_snoise3d
#debug concat(str(f_snoise3d(.3,.4,.5), 0, 9), "\n")
// expect: -0.048257466

//= f_spiral1
#debug concat(str(f_spiral1(.3,.4,.5), 0, 9), "\n")
// expect: 0.409685529

//= f_mandel
#debug concat(str(f_mandel(.3,.7,1.2), 0, 9), "\n")
// expect: 0.160000000
