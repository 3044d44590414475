// The standard includes: math.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "math.inc"

//= sind
#debug concat(str(sind(30), 0, 9), "\n")
#debug concat(str(sind(-100), 0, 9), "\n")
// expect: 0.500000000
// expect: -0.984807753

//= cosd
#debug concat(str(cosd(60), 0, 9), "\n")
#debug concat(str(cosd(200), 0, 9), "\n")
// expect: 0.500000000
// expect: -0.939692621

//= tand
#debug concat(str(tand(45), 0, 9), "\n")
#debug concat(str(tand(-30), 0, 9), "\n")
// expect: 1.000000000
// expect: -0.577350269

//= asind
#debug concat(str(asind(0.5), 0, 9), "\n")
// expect: 30.000000000

//= acosd
#debug concat(str(acosd(-0.5), 0, 9), "\n")
// expect: 120.000000000

//= atand
#debug concat(str(atand(1), 0, 9), "\n")
// expect: 45.000000000

//= atan2d
#debug concat(str(atan2d(1, 2), 0, 9), "\n")
#debug concat(str(atan2d(-1, -2), 0, 9), "\n")
// expect: 26.565051177
// expect: -153.434948823

//= max3
#debug concat(str(max3(1, 3, 2), 0, 9), "\n")
// expect: 3.000000000

//= min3
#debug concat(str(min3(4, 3, 5), 0, 9), "\n")
// expect: 3.000000000

//= even
#debug concat(str(even(2), 0, 9), "\n")
#debug concat(str(even(3), 0, 9), "\n")
#debug concat(str(even(-3), 0, 9), "\n")
#debug concat(str(even(2.5), 0, 9), "\n")
#debug concat(str(even(0), 0, 9), "\n")
// expect: 1.000000000
// expect: 0.000000000
// expect: 0.000000000
// expect: 0.000000000
// expect: 1.000000000

//= odd
#debug concat(str(odd(2), 0, 9), "\n")
#debug concat(str(odd(3), 0, 9), "\n")
#debug concat(str(odd(-3), 0, 9), "\n")
#debug concat(str(odd(2.5), 0, 9), "\n")
#debug concat(str(odd(0), 0, 9), "\n")
// expect: 0.000000000
// expect: 1.000000000
// expect: 1.000000000
// expect: 1.000000000
// expect: 0.000000000

//= f_sqr
#debug concat(str(f_sqr(-3), 0, 9), "\n")
// expect: 9.000000000

//= sgn
#debug concat(str(sgn(-2), 0, 9), "\n")
#debug concat(str(sgn(0), 0, 9), "\n")
#debug concat(str(sgn(5), 0, 9), "\n")
// expect: -1.000000000
// expect: 0.000000000
// expect: 1.000000000

//= clip
#debug concat(str(clip(-1, 0, 3), 0, 9), "\n")
#debug concat(str(clip(4, 0, 3), 0, 9), "\n")
#debug concat(str(clip(2, 0, 3), 0, 9), "\n")
// expect: 0.000000000
// expect: 3.000000000
// expect: 2.000000000

//= clamp
#debug concat(str(clamp(3, 0, 3), 0, 9), "\n")
#debug concat(str(clamp(-1, 0, 3), 0, 9), "\n")
#debug concat(str(clamp(360, 0, 360), 0, 9), "\n")
#debug concat(str(clamp(7.5, 2, 4), 0, 9), "\n")
// expect: 0.000000000
// expect: 2.000000000
// expect: 0.000000000
// expect: 3.500000000

//= adj_range
#debug concat(str(adj_range(0.25, 2, 6), 0, 9), "\n")
// expect: 3.000000000

//= adj_range2
#debug concat(str(adj_range2(3, 2, 6, 10, 20), 0, 9), "\n")
// expect: 12.500000000

//= Mean
#declare A = array[4] {1, 2, 3, 4}
#debug concat(str(Mean(A), 0, 9), "\n")
#declare B = array[2] {<1,2,3>, <3,5,7>}
#debug concat(vstr(3, Mean(B), " ", 0, 9), "\n")
// expect: 2.500000000
// expect: 2.000000000 3.500000000 5.000000000

//= Std_Dev
#declare A = array[4] {1, 2, 3, 4}
#debug concat(str(Std_Dev(A, 2.5), 0, 9), "\n")
// expect: 1.118033989

//= GetStats sets StatisticsArray
// chatty
#declare A = array[5] {1, 2, 3, 4, -7}
GetStats(A)
#for (I, 0, 4) #debug concat("= ", str(StatisticsArray[I], 0, 9), "\n") #end
// expect: = 5.000000000
// expect: = 0.600000000
// expect: = -7.000000000
// expect: = 4.000000000
// expect: = 3.929376541

//= Histogram sets HistogramArray
// chatty
#declare N = 6; #declare A = array[6] {1, 2, 3, 4, -7, 4}
Histogram(A, 4)
#for (I, 0, 3) #debug concat("= ", str(HistogramArray[I][0], 0, 6), " ", str(HistogramArray[I][1], 0, 0), "\n") #end
// expect: = -5.625000 1
// expect: = -2.875000 0
// expect: = -0.125000 1
// expect: = 2.625000 4

//= Interpolate
#debug concat(str(Interpolate(.25, 0, 1, 10, 20, 0), 0, 9), "\n")
#debug concat(str(Interpolate(.25, 0, 1, 10, 20, 1), 0, 9), "\n")
#debug concat(str(Interpolate(.25, 0, 1, 10, 20, 2), 0, 9), "\n")
#debug concat(str(Interpolate(3, 2, 6, -1, 1, 0), 0, 9), "\n")
#debug concat(vstr(3, Interpolate(3, 2, 6, x, y, 1), " ", 0, 9), "\n")
// expect: 11.464466094
// expect: 12.500000000
// expect: 10.625000000
// expect: -0.707106781
// expect: 0.750000000 0.250000000 0.000000000

//= VSqr
#debug concat(vstr(3, VSqr(<1,-2,3>), " ", 0, 9), "\n")
// expect: 1.000000000 4.000000000 9.000000000

//= VPow
#debug concat(vstr(3, VPow(<1,2,3>, 1.5), " ", 0, 9), "\n")
// expect: 1.000000000 2.828427125 5.196152423

//= VPow5D
#local Out = VPow5D(<1,2,3,4,5>, 2); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
// expect: 1.000000000 4.000000000 9.000000000 16.000000000 25.000000000

//= VEq
#debug concat(str(VEq(x, x), 0, 9), "\n")
#debug concat(str(VEq(x, y), 0, 9), "\n")
// expect: 1.000000000
// expect: 0.000000000

//= VEq5D
#debug concat(str(VEq5D(<1,2,3,4,5>, <1,2,3,4,5>), 0, 9), "\n")
#debug concat(str(VEq5D(<1,2,3,4,5>, <1,2,3,4,6>), 0, 9), "\n")
// expect: 1.000000000
// expect: 0.000000000

//= VZero
#debug concat(str(VZero(<0,0,0>), 0, 9), "\n")
#debug concat(str(VZero(z), 0, 9), "\n")
// expect: 1.000000000
// expect: 0.000000000

//= VZero5D
#debug concat(str(VZero5D(<0,0,0,0,0>), 0, 9), "\n")
#debug concat(str(VZero5D(<0,0,0,0,1>), 0, 9), "\n")
// expect: 1.000000000
// expect: 0.000000000

//= VLength5D
#debug concat(str(VLength5D(<1,2,3,4,5>), 0, 9), "\n")
// expect: 7.416198487

//= VNormalize5D
#local Out = VNormalize5D(<1,2,3,4,5>); #debug concat(str(Out.red,0,9)," ",str(Out.green,0,9)," ",str(Out.blue,0,9)," ",str(Out.filter,0,9)," ",str(Out.transmit,0,9),"\n")
// expect: 0.134839967 0.269679934 0.404519916 0.539359868 0.674199879

//= VDot5D
#debug concat(str(VDot5D(<1,2,3,4,5>, <2,1,1,1,3>), 0, 9), "\n")
// expect: 26.000000000

//= VCos_Angle
#debug concat(str(VCos_Angle(<1,2,3>, <2,0,-1>), 0, 9), "\n")
// expect: -0.119522861

//= VAngle
#debug concat(str(VAngle(<1,2,3>, <2,0,-1>), 0, 9), "\n")
#debug concat(str(VAngle(3*x, 2*x), 0, 9), "\n")
// expect: 1.690605611
// expect: 0.000000000

//= VAngleD
#debug concat(str(VAngleD(<1,2,3>, <2,0,-1>), 0, 9), "\n")
// expect: 96.864566338

//= VRotation
#debug concat(str(VRotation(<1,2,3>, <2,0,-1>, y), 0, 9), "\n")
#debug concat(str(VRotation(<1,2,3>, <2,0,-1>, -y), 0, 9), "\n")
// expect: 1.690605611
// expect: -1.690605611

//= VRotationD
#debug concat(str(VRotationD(x, y, z), 0, 9), "\n")
#debug concat(str(VRotationD(x, y, -z), 0, 9), "\n")
#debug concat(str(VRotationD(x, y, <0,0,0>), 0, 9), "\n")
// expect: 90.000000000
// expect: -90.000000000
// expect: 90.000000000

//= VDist
#debug concat(str(VDist(<1,2,3>, <4,6,3>), 0, 9), "\n")
// expect: 5.000000000

//= VPerp_To_Vector
#debug concat(vstr(3, VPerp_To_Vector(<1,2,3>), " ", 0, 9), "\n")
#debug concat(vstr(3, VPerp_To_Vector(x), " ", 0, 9), "\n")
#debug concat(vstr(3, VPerp_To_Vector(y), " ", 0, 9), "\n")
#debug concat(vstr(3, VPerp_To_Vector(z), " ", 0, 9), "\n")
#debug concat(vstr(3, VPerp_To_Vector(<3,1,2>), " ", 0, 9), "\n")
#debug concat(vstr(3, VPerp_To_Vector(<-2,3,-1>), " ", 0, 9), "\n")
#debug concat(vstr(3, VPerp_To_Vector(<1,1,1>), " ", 0, 9), "\n")
#debug concat(vstr(3, VPerp_To_Vector(<0,0,0>), " ", 0, 9), "\n")
#debug concat(vstr(3, VPerp_To_Vector(-5*y), " ", 0, 9), "\n")
// expect: 0.000000000 0.832050294 -0.554700196
// expect: 0.000000000 -1.000000000 0.000000000
// expect: 1.000000000 0.000000000 0.000000000
// expect: -1.000000000 0.000000000 0.000000000
// expect: -0.554700196 0.000000000 0.832050294
// expect: 0.832050294 0.554700196 -0.000000000
// expect: 0.707106781 -0.707106781 0.000000000
// expect: 0.000000000 0.000000000 0.000000000
// expect: -1.000000000 0.000000000 0.000000000

//= VPerp_To_Plane
#debug concat(vstr(3, VPerp_To_Plane(<1,2,3>, x), " ", 0, 9), "\n")
// expect: 0.000000000 0.832050294 -0.554700196

//= VPerp_Adjust
#debug concat(vstr(3, VPerp_Adjust(<1,1,0>, x), " ", 0, 9), "\n")
#debug concat(vstr(3, VPerp_Adjust(<1,2,3>, <2,0,1>), " ", 0, 9), "\n")
// expect: 0.000000000 1.000000000 0.000000000
// expect: -0.333333333 0.666666667 0.666666667

//= VProject_Plane
#debug concat(vstr(3, VProject_Plane(<1,1,0>, 2*x), " ", 0, 9), "\n")
#debug concat(vstr(3, VProject_Plane(<1,2,3>, <1,1,0>), " ", 0, 9), "\n")
// expect: 0.000000000 1.000000000 0.000000000
// expect: -0.500000000 0.500000000 3.000000000

//= VProject_Axis
#debug concat(vstr(3, VProject_Axis(<1,1,0>, 2*x), " ", 0, 9), "\n")
#debug concat(vstr(3, VProject_Axis(<1,2,3>, <1,1,0>), " ", 0, 9), "\n")
// expect: 1.000000000 0.000000000 0.000000000
// expect: 1.500000000 1.500000000 0.000000000

//= VMin
#debug concat(str(VMin(<3,1,2>), 0, 9), "\n")
// expect: 1.000000000

//= VMax
#debug concat(str(VMax(<3,1,2>), 0, 9), "\n")
// expect: 3.000000000

//= VWith_Len
#debug concat(vstr(3, VWith_Len(<0,3,4>, 10), " ", 0, 9), "\n")
// expect: 0.000000000 6.000000000 8.000000000

//= SetGradientAccuracy
#declare F = function { x*x*x }
SetGradientAccuracy(-0.5)
#debug concat(vstr(3, vGradient(F, <1,2,3>), " ", 0, 9), "\n")
// expect: 3.250000000 0.000000000 0.000000000

//= fn_Gradient
#declare F = function { x*x + y*z } #declare G = function { x*y - z } #declare H = function { x + y*y*z }
#declare D = fn_Gradient(F)
#debug concat(str(D(1,2,3), 0, 9), "\n")
// expect: 4.123105626

//= fn_Gradient_Directional
#declare F = function { x*x + y*z } #declare G = function { x*y - z } #declare H = function { x + y*y*z }
#declare D = fn_Gradient_Directional(F, <1,1,0>)
#debug concat(str(D(1,2,3), 0, 9), "\n")
// expect: 3.535533906

//= fn_Divergence
#declare F = function { x*x + y*z } #declare G = function { x*y - z } #declare H = function { x + y*y*z }
#declare D = fn_Divergence(F, G, H)
#debug concat(str(D(1,2,3), 0, 9), "\n")
// expect: 7.000000000

//= vGradient
#declare F = function { x*x + y*z } #declare G = function { x*y - z } #declare H = function { x + y*y*z }
#debug concat(vstr(3, vGradient(F, <1,2,3>), " ", 0, 9), "\n")
// expect: 2.000000000 3.000000000 2.000000000

//= vCurl
#declare F = function { x*x + y*z } #declare G = function { x*y - z } #declare H = function { x + y*y*z }
#debug concat(vstr(3, vCurl(F, G, H, <1,2,3>), " ", 0, 9), "\n")
// expect: 13.000000000 1.000000000 -1.000000000

//= Divergence
#declare F = function { x*x + y*z } #declare G = function { x*y - z } #declare H = function { x + y*y*z }
#debug concat(str(Divergence(F, G, H, <1,2,3>), 0, 9), "\n")
// expect: 7.000000000

//= Gradient_Length
#declare F = function { x*x + y*z } #declare G = function { x*y - z } #declare H = function { x + y*y*z }
#debug concat(str(Gradient_Length(F, <1,2,3>), 0, 9), "\n")
// expect: 4.123105626

//= Gradient_Directional
#declare F = function { x*x + y*z } #declare G = function { x*y - z } #declare H = function { x + y*y*z }
#debug concat(str(Gradient_Directional(F, <1,2,3>, <0,2,1>), 0, 9), "\n")
// expect: 3.577708764
