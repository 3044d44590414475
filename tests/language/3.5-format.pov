// Language §3.5: number formatting.
#version 3.7;
global_settings { assumed_gamma 1 }

//= width and precision
#debug concat(str(3.14159,0,0), "\n")
#debug concat(str(3.14159,0,3), "\n")
#debug concat(str(3.14159,8,3), "\n")
#debug concat(str(3.14159,-8,3), "\n")
#debug concat(str(3.14159,0,-1), "\n")
#debug concat(str(3.14159,12,-1), "\n")
#debug concat(str(3.14159,-12,-1), "\n")
#debug concat(str(3.14159,2,4), "\n")
// expect: 3
// expect: 3.142
// expect:    3.142
// expect: 0003.142
// expect: 3.141590
// expect:     3.141590
// expect: 00003.141590
// expect: 3.1416

//= signs
#debug concat(str(-3.14159,-8,3), "\n")
#debug concat(str(-3.14159,8,3), "\n")
#debug concat(str(-0,0,1), "\n")
#debug concat(str(0,-5,0), "\n")
#debug concat(str(-0.04,0,1), "\n")
// expect: -003.142
// expect:   -3.142
// expect: -0.0
// expect: 00000
// expect: -0.0

//= rounding is half to even, on the binary value
#debug concat(str(2.5,0,0), "\n")
#debug concat(str(3.5,0,0), "\n")
#debug concat(str(0.5,0,0), "\n")
#debug concat(str(1.005,0,2), "\n")
#debug concat(str(0.125,0,2), "\n")
#debug concat(str(0.375,0,2), "\n")
// expect: 2
// expect: 4
// expect: 0
// expect: 1.00
// expect: 0.12
// expect: 0.38

//= infinities and NaN
#debug concat(str(1/0,0,3), "\n")
#debug concat(str(-(1/0),8,3), "\n")
#debug concat(str(1/0,-8,3), "\n")
// expect: inf
// expect:     -inf
// expect:      inf

//= beyond 254 characters the short form is used
#debug concat(str(1e300,0,3), "\n")
#debug concat(str(-1e300,5,0), "\n")
#debug concat(str(strlen(str(1e250,0,0)), 0, 0), "\n")
#debug concat(str(strlen(str(1e250,0,3)), 0, 0), "\n")
#debug concat(str(strlen(str(1e250,0,2)), 0, 0), "\n")
// expect: 1e+300
// expect: -1e+300
// expect: 250
// expect: 254
// expect: 253

//= many decimals
#debug concat(str(0.1,0,20), "\n")
#debug concat(str(1/3,0,30), "\n")
// expect: 0.10000000000000000555
// expect: 0.333333333333333314829616256247

//= arguments are truncated
#debug concat(str(1,0.9,1.9), "\n")
#debug concat(str(1,3.9,0), "\n")
// expect: 1.0
// expect:   1

//= too long for f
#debug concat("[", str(7.17709655124987654321e300, 0, 12), "]", str(1e300, 0, -1), "]", str(7.17e300, -20, 3), "]\n")
#debug concat("[", str(1, 255, 1), "]", str(1, 0, 253), "]", str(1.5, -300, 3), "]", str(strlen(str(1, 254, 1)), 0, 0), "\n")
#debug concat(str(strlen(vstr(2, <1e300, 7.123e270>, ",", 0, 12)), 0, 0), ",", str(strlen(vstr(2, 1, ",", 300, 1)), 0, 0), "\n")
// expect: [7.17709655125e+300]1e+300]000000000007.17e+300]
// expect: [<invalid>]1]<invalid>]254
// expect: 599,601
