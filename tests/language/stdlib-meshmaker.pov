// The standard includes: meshmaker.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "meshmaker.inc"
// Distances at which rays along z and x meet an object, on a grid over a box: `.` where they miss it.
#macro Probe(O, L, H, N)
  #for (J, 0, N - 1) #debug "= " #for (I, 0, N - 1)
    #local U = (I + 0.5) / N; #local V = (J + 0.5) / N;
    #local M = <0,0,0>; #local P = trace(O, <L.x + (H.x - L.x) * U, L.y + (H.y - L.y) * V, L.z - 1>, z, M);
    #if (vlength(M) = 0) #debug ". " #else #debug concat(str(P.z - L.z, 0, 3), " ") #end
    #local M = <0,0,0>; #local P = trace(O, <L.x - 1, L.y + (H.y - L.y) * U, L.z + (H.z - L.z) * V>, x, M);
    #if (vlength(M) = 0) #debug ". " #else #debug concat(str(P.x - L.x, 0, 3), " ") #end
  #end #debug "\n" #end
#end
// Which points of a grid are inside an object, in a given box.
#macro Fill(O, L, H, N)
  #for (J, 0, N - 1) #for (K, 0, N - 1) #for (I, 0, N - 1)
    #debug #if (inside(O, L + (H - L) * <I + 0.51, J + 0.52, K + 0.53> / N)) "#" #else "." #end
  #end #end #debug "\n" #end
#end
#macro Box(O) #debug concat("= ",vstr(3,min_extent(O)," ",0,4)," | ",vstr(3,max_extent(O)," ",0,4),"\n") #end

//= LInterpolate
// chatty
#debug concat("= ",str(LInterpolate(0.25, 10, 20), 0, 9), "\n")
#debug concat("= ",vstr(3, LInterpolate(0.25, x, y), " ", 0, 9), "\n")
// expect: = 12.500000000
// expect: = 0.750000000 0.250000000 0.000000000

//= RangeMM
// chatty
#debug concat("= ",str(RangeMM(3, 2, 6, 10, 20), 0, 9), "\n")
// expect: = 12.500000000

//= CheckFileName
// chatty
#fopen F "there.inc" write #write (F, "1") #fclose F #fopen F "there.obj" write #write (F, "1") #fclose F
#debug concat("= ",str(CheckFileName(""), 0, 9), "\n")
#debug concat("= ",str(CheckFileName("a.inc"), 0, 9), "\n")
#debug concat("= ",str(CheckFileName("a.obj"), 0, 9), "\n")
#debug concat("= ",str(CheckFileName("a.pcm"), 0, 9), "\n")
#debug concat("= ",str(CheckFileName("a.arr"), 0, 9), "\n")
#debug concat("= ",str(CheckFileName("there.inc"), 0, 9), "\n")
#debug concat("= ",str(CheckFileName("there.obj"), 0, 9), "\n")
#debug concat("= ",str(CheckFileName("a.OBJ"), 0, 9), "\n")
#debug concat("= ",str(CheckFileName("x"), 0, 9), "\n")
// expect: = 1.000000000
// expect: = 1.000000000
// expect: = 2.000000000
// expect: = 3.000000000
// expect: = 4.000000000
// expect: = 0.000000000
// expect: = 99.000000000
// expect: = 2.000000000
// expect: = 1.000000000

//= BuildSpline
// chatty
#declare A = array[5] {<0,0,0>, <1,0,0>, <1,1,0>, <2,1,1>, <3,0,0>}
#declare S = BuildSpline(A, "Cubic") #debug concat("= ",vstr(3, (<0,0,0>+S(-0.25)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(0)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(0.3)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(1)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(1.4)), " ", 0, 9), "\n")
#declare S = BuildSpline(A, "L") #debug concat("= ",vstr(3, (<0,0,0>+S(-0.25)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(0)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(0.3)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(1)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(1.4)), " ", 0, 9), "\n")
#declare S = BuildSpline(A, "quadratic") #debug concat("= ",vstr(3, (<0,0,0>+S(-0.25)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(0)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(0.3)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(1)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(1.4)), " ", 0, 9), "\n")
#declare S = BuildSpline(A, "N") #debug concat("= ",vstr(3, (<0,0,0>+S(-0.25)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(0)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(0.3)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(1)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(1.4)), " ", 0, 9), "\n")
#declare S = BuildSpline(A, "x") #debug concat("= ",vstr(3, (<0,0,0>+S(-0.25)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(0)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(0.3)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(1)), " ", 0, 9), "\n") #debug concat("= ",vstr(3, (<0,0,0>+S(1.4)), " ", 0, 9), "\n")
// expect: = 1.000000000 0.000000000 0.000000000
// expect: = 1.000000000 0.000000000 0.000000000
// expect: = 0.976000000 0.624000000 -0.072000000
// expect: = 2.000000000 1.000000000 1.000000000
// expect: = 2.000000000 1.000000000 1.000000000
// expect: = 0.500000000 0.000000000 0.000000000
// expect: = 1.000000000 0.000000000 0.000000000
// expect: = 1.000000000 0.600000000 0.000000000
// expect: = 2.000000000 1.000000000 1.000000000
// expect: = 2.800000000 0.200000000 0.200000000
// expect: = 0.625000000 -0.125000000 0.000000000
// expect: = 1.000000000 0.000000000 0.000000000
// expect: = 1.120000000 0.480000000 0.000000000
// expect: = 2.000000000 1.000000000 1.000000000
// expect: = 2.800000000 0.280000000 0.360000000
// expect: = 0.500000000 0.000000000 0.000000000
// expect: = 1.000000000 0.000000000 0.000000000
// expect: = 1.000000000 0.600000000 0.000000000
// expect: = 2.000000000 1.000000000 1.000000000
// expect: = 2.800000000 0.200000000 0.200000000
// expect: = 0.500000000 0.000000000 0.000000000
// expect: = 1.000000000 0.000000000 0.000000000
// expect: = 1.000000000 0.600000000 0.000000000
// expect: = 2.000000000 1.000000000 1.000000000
// expect: = 2.800000000 0.200000000 0.200000000

//= MSM
// chatty
#declare S1 = spline { cubic_spline -0.2, <0.5,0,0> 0, <0.6,0,0.1> 0.3, <1,0.5,0.5> 0.7, <0.4,1,1> 1, <0.8,1.5,0.4> 1.2, <1,2,0> }
#declare S2 = spline { cubic_spline -0.2, <0.5,0,1> 0, <0.6,0,1.1> 0.3, <1.2,0.5,1.5> 0.7, <0.4,1,2> 1, <0.8,1.5,1.4> 1.2, <1,2,1> }
#declare S3 = spline { cubic_spline -0.2, <0.5,0,2> 0, <0.6,0.5,2.1> 0.3, <1,0.5,2.5> 0.7, <0.4,1,3> 1, <0.8,1.5,2.4> 1.2, <1,2,2> } #declare S4 = spline { linear_spline 0, <0.5,0.5,3> 1, <0.6,1.5,3.1> }
#declare A = array[4] { S1, S2, S3, S4 }
#declare O = object { MSM(A, 6, "Cubic", 8, "") }
Probe(O, <0.413,0.022,1.117>, <1.174,1.488,2.986>, 5)
// expect: = . 0.421 0.347 . 0.250 . . . . .
// expect: = . . 0.891 0.706 0.975 . 1.007 . 0.725 0.237
// expect: = . . . 0.308 0.858 0.367 . 0.046 . 0.245
// expect: = . . . . . 0.291 . 0.044 . 0.248
// expect: = . . . . . 0.235 . 0.043 . .

//= FromU, ToU, FromV, ToV
// chatty
#debug concat("= ",str(FromU(0)*1e12, 0, 9), "\n")
#debug concat("= ",str((ToU(1)-1)*1e12, 0, 9), "\n")
#debug concat("= ",str(FromV(0)*1e12, 0, 9), "\n")
#debug concat("= ",str((ToV(2)-2)*1e12, 0, 9), "\n")
// expect: = 1.000000000
// expect: = -0.999977878
// expect: = 1.000000000
// expect: = -1.000088901

//= Parametric
// chatty
#declare FX = function(u,v) { cos(u)*sin(v) } #declare FY = function(u,v) { cos(v)*1.2 } #declare FZ = function(u,v) { sin(u)*sin(v) }
#declare O = object { Parametric(FX, FY, FZ, <0,FromV(0)>, <2*pi,ToV(pi)>, 16, 8, "") }
Probe(O, <-0.987,-1.178,-0.983>, <0.984,1.188,0.986>, 4)
#declare N = <0,0,0>; #declare P = trace(O, <0.3,0.2,-5>, z, N); #debug concat("= ",vstr(3, P, " ", 0, 5), "\n") #debug concat("= ",vstr(3, N, " ", 0, 5), "\n")
#declare N = <0,0,0>; #declare P = trace(O, <0.02,5,-0.03>, -y, N); #debug concat("= ",vstr(3, P, " ", 0, 5), "\n") #debug concat("= ",vstr(3, N, " ", 0, 5), "\n")
// expect: = . . 0.367 0.410 0.367 0.412 . .
// expect: = 0.411 0.371 0.081 0.084 0.080 0.086 0.407 0.383
// expect: = 0.414 0.371 0.082 0.084 0.082 0.086 0.410 0.384
// expect: = . . 0.380 0.414 0.379 0.417 . .
// expect: = 0.30000 0.20000 -0.90717
// expect: = 0.30969 0.14575 -0.93960
// expect: = 0.02000 1.19123 -0.03000
// expect: = 0.11402 0.96276 -0.24512

//= Paramcalc
// chatty
#declare __Fx = function(u,v) { u } #declare __Fy = function(u,v) { u*v } #declare __Fz = function(u,v) { v*v }
#declare O = object { Paramcalc(<-1,-1>, <1,1>, 6, 8, "") }
Probe(O, <-0.987,-0.978,0.017>, <0.984,0.988,0.986>, 4)
#ifdef (__Fx) #debug "= there\n" #else #debug "= gone\n" #end
// expect: = 0.968 . . 0.293 . 0.287 0.974 .
// expect: = 0.108 . 0.946 0.575 0.961 0.588 0.109 .
// expect: = 0.098 0.041 . 0.674 . 0.668 0.100 0.043
// expect: = . 0.178 . 0.721 . 0.729 . 0.193
// expect: = gone

//= Prism
// chatty
#declare S1 = spline { cubic_spline -0.2, <0.5,0,0> 0, <0.6,0,0.1> 0.3, <1,0.5,0.5> 0.7, <0.4,1,1> 1, <0.8,1.5,0.4> 1.2, <1,2,0> }
#declare O = object { Prism(S1, 12, 2, 3, "") }
Probe(O, <0.423,0.022,0.117>, <0.974,3.488,0.986>, 4)
#declare N = <0,0,0>; #declare P = trace(O, <-5,0.7,0.2>, x, N); #debug concat("= ",vstr(3, P, " ", 0, 5), "\n") #debug concat("= ",vstr(3, N, " ", 0, 5), "\n")
// expect: = . 0.335 0.007 0.335 0.116 . 0.235 .
// expect: = 0.732 0.557 0.007 0.557 0.116 0.349 0.235 0.349
// expect: = 0.732 . 0.537 0.202 0.333 0.202 0.235 0.202
// expect: = 0.732 . 0.537 0.049 0.333 0.049 . 0.049
// expect: = 0.72480 0.70000 0.20000
// expect: = -0.62180 0.00000 0.78317

//= Prism1
// chatty
#declare S1 = spline { cubic_spline -0.2, <0.5,0,0> 0, <0.6,0,0.1> 0.3, <1,0.5,0.5> 0.7, <0.4,1,1> 1, <0.8,1.5,0.4> 1.2, <1,2,0> }
#declare S2 = spline { linear_spline 0, <1,0,0> 0.5, <1.5,1,0> 1, <0.5,2,0.5> }
#declare O = object { Prism1(S1, 12, S2, 6, "") }
Probe(O, <0.223,0.022,0.067>, <1.784,3.718,1.816>, 4)
#declare N = <0,0,0>; #declare P = trace(O, <-5,0.7,0.4>, x, N); #debug concat("= ",vstr(3, P, " ", 0, 5), "\n") #debug concat("= ",vstr(3, N, " ", 0, 5), "\n")
// expect: = . 0.725 . 0.814 . . . .
// expect: = . . 0.102 0.415 0.296 0.282 . 0.812
// expect: = . . 0.997 0.268 1.300 0.555 . 0.816
// expect: = . . . . 0.913 0.446 . .
// expect: = 1.12381 0.70000 0.40000
// expect: = -0.82800 0.40489 0.38792

//= Lathe
// chatty
#declare S1 = spline { cubic_spline -0.2, <0.5,0,0> 0, <0.6,0,0.1> 0.3, <1,0.5,0.5> 0.7, <0.4,1,1> 1, <0.8,1.5,0.4> 1.2, <1,2,0> }
#declare O = object { Lathe(S1, 12, 360, 12, "") }
Probe(O, <-1.117,0.022,-1.113>, <1.114,1.488,1.116>, 4)
#declare N = <0,0,0>; #declare P = trace(O, <0.1,0.7,-5>, z, N); #debug concat("= ",vstr(3, P, " ", 0, 5), "\n") #debug concat("= ",vstr(3, N, " ", 0, 5), "\n")
#declare O = object { Lathe(S1, 12, 100, 12, "") }
Probe(O, <0.003,0.022,-1.053>, <1.114,1.488,0.986>, 4)
// expect: = 1.137 0.932 0.324 0.403 0.304 0.475 0.930 0.825
// expect: = 0.407 0.307 0.056 0.060 0.056 0.092 0.400 0.276
// expect: = 0.434 0.328 0.088 0.060 0.088 0.092 0.472 0.275
// expect: = 0.833 1.132 0.271 0.410 0.272 0.437 0.822 0.836
// expect: = 0.10000 0.70000 -1.07693
// expect: = 0.08928 0.20309 -0.97508
// expect: = 0.207 0.308 0.306 0.787 0.556 . . .
// expect: = . 0.804 0.014 1.081 0.175 1.044 0.496 0.847
// expect: = . 0.824 . 1.097 1.884 1.058 0.579 0.866
// expect: = . . . . 0.480 0.799 . .

//= Coons
// chatty
#declare s1 = spline { linear_spline 0, <0,0,0> 0.5, <0.5,0.3,0> 1, <1,0,0> } #declare s2 = spline { linear_spline 0, <1,0,0> 1, <1,0.2,1> } #declare s3 = spline { linear_spline 0, <1,0.2,1> 0.4, <0.5,0.5,1> 1, <0,0,1> } #declare s4 = spline { linear_spline 0, <0,0,1> 1, <0,0,0> }
#declare O = object { Coons(s1, s2, s3, s4, 6, 5, "") }
Probe(O, <0.013,0.022,0.017>, <0.984,0.438,0.986>, 4)
#declare N = <0,0,0>; #declare P = trace(O, <0.3,5,0.2>, -y, N); #debug concat("= ",vstr(3, P, " ", 0, 5), "\n") #debug concat("= ",vstr(3, N, " ", 0, 5), "\n")
#declare N = <0,0,0>; #declare P = trace(O, <0.02,5,0.97>, -y, N); #debug concat("= ",vstr(3, P, " ", 0, 5), "\n") #debug concat("= ",vstr(3, N, " ", 0, 5), "\n")
// expect: = . 0.098 . 0.258 . 0.419 . .
// expect: = . 0.087 . 0.228 . 0.370 0.461 .
// expect: = . 0.075 0.393 0.200 0.271 0.325 0.981 .
// expect: = . 0.064 . 0.174 0.773 0.287 . 0.399
// expect: = 0.30000 0.20069 0.20000
// expect: = -0.55384 0.82790 -0.08858
// expect: = 0.02000 0.02000 0.97000
// expect: = -0.70194 0.71220 -0.00678

//= TwoVarSurf
// chatty
#declare F = function(x, y) { sin(x)*y }
#declare O = object { TwoVarSurf(F, <-1,2>, <0,1>, 7, 5, "") }
Probe(O, <-0.987,0.022,-0.823>, <1.984,0.988,0.986>, 4)
#declare N = <0,0,0>; #declare P = trace(O, <0.3,0.4,-5>, z, N); #debug concat("= ",vstr(3, P, " ", 0, 5), "\n") #debug concat("= ",vstr(3, N, " ", 0, 5), "\n")
// expect: = 0.746 . 0.856 . 0.935 . 0.964 0.188
// expect: = 0.608 . 0.875 0.585 1.112 0.745 1.204 0.816
// expect: = 0.466 . 0.905 1.936 1.295 1.506 1.442 1.345
// expect: = 0.329 . 0.942 . 1.482 . 1.682 2.069
// expect: = 0.30000 0.40000 0.11771
// expect: = 0.31432 0.26698 -0.91100

//= SweepSpline1
// chatty
#declare T = spline { cubic_spline -0.2, <-1,0,0> 0, <0,0,0> 0.5, <1,0.3,1> 1, <2,0,0.5> 1.2, <3,0,0> } #declare H = spline { cubic_spline -0.25, <0,-1,0> 0, <1,0,0> 0.25, <0,1,0> 0.5, <-1,0,0> 0.75, <0,-1,0> 1, <1,0,0> 1.25, <0,1,0> } #declare W = spline { linear_spline 0, 0.3*x 1, 0.1*x }
#declare O = object { SweepSpline1(T, H, W, 8, 8, "") }
Probe(O, <-0.067,-0.278,-0.273>, <1.704,0.488,1.176>, 4)
#declare N = <0,0,0>; #for (K, 0, 3) #declare P = trace(O, <0.3 + 0.3 * K, 0.1, -5>, z, N); #debug concat("= ",vstr(3, N, " ", 0, 5), "\n") #end
// expect: = 0.190 0.214 . 0.412 . 0.261 . .
// expect: = 0.033 0.419 0.458 0.706 . 0.172 1.051 .
// expect: = 0.160 . 0.470 0.546 1.138 0.453 0.995 0.638
// expect: = . . 0.744 . 1.135 0.775 . 0.845
// expect: = 0.54382 0.28073 -0.79085
// expect: = 0.77609 0.04897 -0.62872
// expect: = 0.53751 -0.83710 -0.10169
// expect: = -0.28139 -0.95104 -0.12780

//= SweepSpline2
// chatty
#declare T = spline { cubic_spline -0.2, <-1,0,0> 0, <0,0,0> 0.5, <1,0.3,1> 1, <2,0,0.5> 1.2, <3,0,0> } #declare H = spline { cubic_spline -0.25, <0,-1,0> 0, <1,0,0> 0.25, <0,1,0> 0.5, <-1,0,0> 0.75, <0,-1,0> 1, <1,0,0> 1.25, <0,1,0> } #declare W = spline { linear_spline 0, 0.3*x 1, 0.1*x }
#declare O = object { SweepSpline2(T, H, W, 8, 8, "") }
Probe(O, <-0.067,-0.278,-0.273>, <1.704,0.488,1.176>, 4)
#declare N = <0,0,0>; #for (K, 0, 3) #declare P = trace(O, <0.3 + 0.3 * K, 0.1, -5>, z, N); #debug concat("= ",vstr(3, N, " ", 0, 5), "\n") #end
// expect: = 0.188 0.215 . 0.409 . 0.260 . .
// expect: = 0.034 0.446 0.458 0.708 . 0.168 1.050 .
// expect: = 0.161 . 0.463 0.547 1.138 0.462 0.996 0.633
// expect: = . . 0.763 . 1.133 0.776 . 0.846
// expect: = 0.49064 0.26822 -0.82905
// expect: = 0.73374 0.03349 -0.67860
// expect: = 0.49024 -0.85883 -0.14860
// expect: = -0.37926 -0.92294 -0.06593

//= FindPoint is used by the sweeps
// chatty
#declare T = spline { cubic_spline -0.2, <-1,0,0> 0, <0,0,0> 0.5, <1,0.3,1> 1, <2,0,0.5> 1.2, <3,0,0> } #declare H = spline { cubic_spline -0.25, <0,-1,0> 0, <1,0,0> 0.25, <0,1,0> 0.5, <-1,0,0> 0.75, <0,-1,0> 1, <1,0,0> 1.25, <0,1,0> } #declare W = spline { linear_spline 0, 0.3*x 1, 0.1*x }
#declare O = object { SweepSpline1(T, H, W, 3, 3, "") } Box(O)
// expect: = -0.0831 -0.2436 -0.1231 | 1.3523 0.4177 1.1213

//= BuildWriteMesh2 writes scene text, and reads it the next time
// chatty
#declare F = function(x, y) { sin(x)*y }
#declare O = object { TwoVarSurf(F, <-1,2>, <0,1>, 4, 3, "t.inc") }
#debug concat("= ",str(file_exists("t.inc"), 0, 9), "\n")
#declare P = object { TwoVarSurf(F, <0,0>, <0,0>, 4, 3, "t.inc") } Box(P)
// expect: = 1.000000000
// expect: = -1.0000 0.0000 -0.8415 | 2.0000 1.0000 0.9490

//= BuildWriteMesh2 writes arrays
// chatty
#declare F = function(x, y) { sin(x)*y }
#declare O = object { TwoVarSurf(F, <-1,2>, <0,1>, 4, 3, "t.arr") }
#debug concat("= ",str(file_exists("t.arr"), 0, 9), "\n")
// expect: = 1.000000000

//= BuildWriteMesh2 writes other formats
// chatty
#declare F = function(x, y) { sin(x)*y }
#declare O = object { TwoVarSurf(F, <-1,2>, <0,1>, 4, 3, "t.obj") } #declare O = object { TwoVarSurf(F, <-1,2>, <0,1>, 4, 3, "t.pcm") }
#debug concat("= ",str(file_exists("t.obj") + file_exists("t.pcm"), 0, 9), "\n")
// expect: = 2.000000000
