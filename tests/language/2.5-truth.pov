// Language §2.5: truth, comparison, division.
#version 3.7;
global_settings { assumed_gamma 1 }

//= truth has a tolerance
#if (1e-10) #debug "yes\n" #else #debug "no\n" #end #if (1.1e-10) #debug "yes\n" #else #debug "no\n" #end #if (-1) #debug "yes\n" #end
#debug concat(str(!1e-10, 0, 0), "\n")
#debug concat(str(!2e-10, 0, 0), "\n")
#debug concat(str(!0, 0, 0), "\n")
#debug concat(str((1e-11|0), 0, 0), "\n")
#debug concat(str((1&1e-11), 0, 0), "\n")
// expect: no
// expect: yes
// expect: yes
// expect: 1
// expect: 0
// expect: 1
// expect: 0
// expect: 0

//= words for true and false
#debug concat(str(yes, 0, 0), "\n")
#debug concat(str(on, 0, 0), "\n")
#debug concat(str(true, 0, 0), "\n")
#debug concat(str(no, 0, 0), "\n")
#debug concat(str(off, 0, 0), "\n")
#debug concat(str(false, 0, 0), "\n")
// expect: 1
// expect: 1
// expect: 1
// expect: 0
// expect: 0
// expect: 0

//= equality has an absolute tolerance
#debug concat(str((0.1+0.2=0.3), 0, 0), "\n")
#debug concat(str((1=1+1e-11), 0, 0), "\n")
#debug concat(str((1=1+1e-9), 0, 0), "\n")
#debug concat(str((1e15=1e15+1), 0, 0), "\n")
#debug concat(str((1!=1+1e-11), 0, 0), "\n")
#debug concat(str((1!=1+1e-9), 0, 0), "\n")
// expect: 1
// expect: 1
// expect: 0
// expect: 0
// expect: 0
// expect: 1

//= < and > are exact
#debug concat(str((1<1+1e-11), 0, 0), "\n")
#debug concat(str((1+1e-11>1), 0, 0), "\n")
#debug concat(str((1<1), 0, 0), "\n")
// expect: 1
// expect: 1
// expect: 0

//= <= and >= are exact or equal
#debug concat(str((1<=1-1e-11), 0, 0), "\n")
#debug concat(str((1>=1+1e-11), 0, 0), "\n")
#debug concat(str((1<=1-1e-9), 0, 0), "\n")
#debug concat(str((1>=1+1e-9), 0, 0), "\n")
// expect: 1
// expect: 1
// expect: 0
// expect: 0

//= NaN equals everything
#declare N = mod(1,0);
#debug concat(str((N=N), 0, 0), "\n")
#debug concat(str((N=1), 0, 0), "\n")
#debug concat(str((N!=1), 0, 0), "\n")
#debug concat(str((N<=1), 0, 0), "\n")
#debug concat(str((N>=1), 0, 0), "\n")
#debug concat(str((N<1), 0, 0), "\n")
#debug concat(str((N>1), 0, 0), "\n")
#debug concat(str((N&1), 0, 0), "\n")
#debug concat(str((N|0), 0, 0), "\n")
#debug concat(str(!N, 0, 0), "\n")
#debug concat(str((N?1:2), 0, 0), "\n")
// expect: 1
// expect: 1
// expect: 0
// expect: 1
// expect: 1
// expect: 0
// expect: 0
// expect: 0
// expect: 0
// expect: 1
// expect: 2

//= infinity equals itself
#declare I = 1/0;
#debug concat(str((I=I), 0, 0), "\n")
#debug concat(str((I<=I), 0, 0), "\n")
#debug concat(str((I!=I), 0, 0), "\n")
#debug concat(str((I=-I), 0, 0), "\n")
#debug concat(str((I>1e300), 0, 0), "\n")
#debug concat(str((-I<I), 0, 0), "\n")
// expect: 1
// expect: 1
// expect: 0
// expect: 0
// expect: 1
// expect: 1

//= division by zero is plus infinity
#debug concat(str(1/0, 0, 6), "\n")
#debug concat(str(-1/0, 0, 6), "\n")
#debug concat(str(0/0, 0, 6), "\n")
#debug concat(str(1/-0, 0, 6), "\n")
#debug concat(vstr(3, <1,-1,0>/0, ",", 0, 3), "\n")
#debug concat(vstr(3, <1,2,3>/<1,0,2>, ",", 0, 3), "\n")
// expect: inf
// expect: inf
// expect: inf
// expect: inf
// expect: inf,inf,inf
// expect: 1.000,inf,1.500

//= a small divisor is not zero
#debug concat(str(1/1e-300*1e-300, 0, 0), "\n")
#debug concat(str(1/1e-12, 0, 0), "\n")
// expect: 1
// expect: 1000000000000

//= degrees and radians
#debug concat(str(sin(pi/2), 0, 6), "\n")
#debug concat(str(cos(pi), 0, 6), "\n")
#debug concat(str(tan(pi/4), 0, 6), "\n")
#debug concat(str(atan2(1,1)*4, 0, 6), "\n")
#debug concat(vstr(3, vrotate(x,90*z), ",", 0, 3), "\n")
#debug concat(vstr(3, vaxis_rotate(x,z,90), ",", 0, 3), "\n")
// expect: 1.000000
// expect: -1.000000
// expect: 1.000000
// expect: 3.141593
// expect: 0.000,1.000,0.000
// expect: 0.000,1.000,0.000

//= every name of truth
#debug concat(str(yes, 0, 0), str(on, 0, 0), str(true, 0, 0), str(no, 0, 0), str(off, 0, 0), str(false, 0, 0), str(!yes, 0, 0), "\n")
// expect: 1110000

//= nothing over nothing
#debug concat(str(0/0, 0, 0), str(1/(-0), 0, 0), str(-1/0, 0, 0), str((1/0 = 1/0), 0, 0), "\n")
// expect: infinfinf1

//= strings by their codes
#debug concat(str(("abc" < "abd"), 0, 0), str(("" = ""), 0, 0), str(("Z" < "a"), 0, 0), str(("a" != "A"), 0, 0), "\n")
// expect: 1111
