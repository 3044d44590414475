// Language §3.3: vector and string functions.
#version 3.7;
global_settings { assumed_gamma 1 }

//= vaxis_rotate
#debug concat(vstr(3, vaxis_rotate(<1,2,3>,<1,1,0>,30), ",", 0, 9), "\n")
#debug concat(vstr(3, vaxis_rotate(x,y,90), ",", 0, 9), "\n")
#debug concat(vstr(3, vaxis_rotate(<1,2,3>,z*5,-45), ",", 0, 9), "\n")
#debug concat(vstr(3, vaxis_rotate(2,<1,2,3>,10), ",", 0, 9), "\n")
// expect: 2.127647470,0.872352530,2.951629602
// expect: 0.000000000,0.000000000,-1.000000000
// expect: 2.121320344,0.707106781,3.000000000
// expect: 1.889818577,2.181297068,1.915862429

//= vcross
#debug concat(vstr(3, vcross(x,y), ",", 0, 3), "\n")
#debug concat(vstr(3, vcross(<1,2,3>,<4,5,6>), ",", 0, 3), "\n")
#debug concat(vstr(3, vcross(<1,2>,<4,5>), ",", 0, 3), "\n")
// expect: 0.000,0.000,1.000
// expect: -3.000,6.000,-3.000
// expect: 0.000,0.000,-3.000

//= vnormalize
#debug concat(vstr(3, vnormalize(<3,4,0>), ",", 0, 9), "\n")
#debug concat(vstr(3, vnormalize(5), ",", 0, 9), "\n")
#debug concat(vstr(3, vnormalize(0), ",", 0, 9), "\n")
// expect: 0.600000000,0.800000000,0.000000000
// expect: 0.577350269,0.577350269,0.577350269
// expect: 0.000000000,0.000000000,0.000000000

//= vrotate
#debug concat(vstr(3, vrotate(<1,2,3>,<30,40,50>), ",", 0, 9), "\n")
#debug concat(vstr(3, vrotate(x,90*z), ",", 0, 9), "\n")
#debug concat(vstr(3, vrotate(y,90*x), ",", 0, 9), "\n")
#debug concat(vstr(3, vrotate(z,90*y), ",", 0, 9), "\n")
#debug concat(vstr(3, vrotate(<1,2,3>,90), ",", 0, 9), "\n")
// expect: 1.801281062,2.507690147,2.113498678
// expect: 0.000000000,1.000000000,0.000000000
// expect: 0.000000000,0.000000000,1.000000000
// expect: 1.000000000,0.000000000,0.000000000
// expect: 3.000000000,2.000000000,-1.000000000

//= vturbulence
#debug concat(vstr(3, vturbulence(2,.5,6,<1,2,3>), ",", 0, 6), "\n")
#debug concat(vstr(3, vturbulence(2,.5,1,<1,2,3>), ",", 0, 6), "\n")
#debug concat(vstr(3, vturbulence(2,.5,0,<1,2,3>), ",", 0, 6), "\n")
#debug concat(vstr(3, vturbulence(2,.5,20,<1,2,3>), ",", 0, 6), "\n")
#debug concat(vstr(3, vturbulence(2,.5,10,<1,2,3>), ",", 0, 6), "\n")
#debug concat(vstr(3, vturbulence(3,.7,3.9,<-1,.2,.3>), ",", 0, 6), "\n")
// expect: -0.380510,-0.538243,0.421739
// expect: -0.193003,-0.457183,0.474075
// expect: -0.193003,-0.457183,0.474075
// expect: -0.389961,-0.532918,0.416473
// expect: -0.389961,-0.532918,0.416473
// expect: 0.180184,0.071439,0.575428

//= trace
#declare O = sphere { 0, 1 } #declare N = <9,9,9>;
#debug concat(vstr(3, trace(O,-5*z,z), ",", 0, 3), "\n")
#debug concat(vstr(3, trace(O,-5*z,z,N), ",", 0, 3), "\n")
#debug concat(vstr(3, N, ",", 0, 3), "\n")
#debug concat(vstr(3, trace(O,-5*z,-z,N), ",", 0, 3), "\n")
#debug concat(vstr(3, N, ",", 0, 3), "\n")
#debug concat(vstr(3, trace(O,-5*z,10*z), ",", 0, 3), "\n")
#debug concat(vstr(3, trace(O,0,y,N), ",", 0, 3), "\n")
#debug concat(vstr(3, N, ",", 0, 3), "\n")
// expect: 0.000,0.000,-1.000
// expect: 0.000,0.000,-1.000
// expect: 0.000,0.000,-1.000
// expect: 0.000,0.000,0.000
// expect: 0.000,0.000,0.000
// expect: 0.000,0.000,-1.000
// expect: 0.000,1.000,0.000
// expect: 0.000,1.000,0.000

//= trace wants a variable for the normal
#declare O = sphere { 0, 1 } #declare A = trace(O, -5*z, z, N);
// error: D0203 at 1:61

//= trace wants a vector variable for the normal
#declare O = sphere { 0, 1 } #declare N = 1; #declare A = trace(O, -5*z, z, N);
// error: D0204 at 1:77

//= trace wants a declared object
#declare A = trace(sphere { 0, 1 }, -5*z, z);
// error: D0201 at 1:20

//= trace through solids
#declare O = difference { box { -1, 1 } sphere { 0, 1.2 } } #declare N = <0,0,0>;
#debug concat(vstr(3, trace(O,<0.9,0.9,-5>,z,N), ",", 0, 3), "\n")
#debug concat(vstr(3, N, ",", 0, 3), "\n")
#debug concat(vstr(3, trace(O,-5*z,z,N), ",", 0, 3), "\n")
#debug concat(vstr(3, N, ",", 0, 3), "\n")
// expect: 0.900,0.900,-1.000
// expect: 0.000,0.000,-1.000
// expect: 0.000,0.000,0.000
// expect: 0.000,0.000,0.000

//= extents
#declare O = union { sphere { 0, 1 } sphere { x, 1 } rotate 45*z }
#debug concat(vstr(3, min_extent(O), ",", 0, 3), "\n")
#debug concat(vstr(3, max_extent(O), ",", 0, 3), "\n")
// expect: -1.414,-1.414,-1.000
// expect: 2.121,2.121,1.000

//= extents of unbounded objects
#declare P = plane { y, 0 }
#debug concat(vstr(3, min_extent(P), ",", 0, 0), "\n")
#debug concat(vstr(3, max_extent(P), ",", 0, 0), "\n")
// expect: -10000000000,-10000000000,-10000000000
// expect: 10000000000,10000000000,10000000000

//= extents of a box
#declare O = box { <-1,-2,-3>, <4,5,6> scale 2 translate x }
#debug concat(vstr(3, min_extent(O), ",", 0, 3), "\n")
#debug concat(vstr(3, max_extent(O), ",", 0, 3), "\n")
// expect: -1.000,-4.000,-6.000
// expect: 9.000,10.000,12.000

//= chr
#debug concat(chr(65), "\n")
#debug concat(chr(97.9), "\n")
#debug concat(concat(chr(72),chr(105)), "\n")
#debug concat(str(strlen(chr(65)), 0, 0), "\n")
#debug concat(str(asc(chr(300)), 0, 0), "\n")
// expect: A
// expect: a
// expect: Hi
// expect: 1
// expect: 300

//= chr out of range
#declare A = chr(65536);
// error: D0302 at 1:14

//= chr of a negative code
#declare A = chr(-1);
// error: D0302 at 1:14

//= concat
#debug concat(concat("a","b","c"), "\n")
#debug concat(concat("one"), "\n")
#debug concat(concat(concat("a","b"),"c"), "\n")
// expect: abc
// expect: one
// expect: abc

//= datetime
#debug concat(datetime(0), "\n")
#debug concat(datetime(1.5), "\n")
#debug concat(datetime(-1), "\n")
#debug concat(datetime(8000.123456), "\n")
#debug concat(datetime(0, "%Y"), "\n")
#debug concat(datetime(366, "%d.%m.%y"), "\n")
// expect: 2000-01-01 00:00:00Z
// expect: 2000-01-02 12:00:00Z
// expect: 1999-12-31 00:00:00Z
// expect: 2021-11-26 02:57:47Z
// expect: 2000
// expect: 01.01.01

//= datetime with an empty format
#declare A = datetime(0, "");
// error: D0302 at 1:14

//= str
#debug concat(str(1.5,0,1), "\n")
#debug concat(str(-1.5,8,2), "\n")
#debug concat(str(3,5,0), "\n")
// expect: 1.5
// expect:    -1.50
// expect:     3

//= strlwr and strupr
#debug concat(strlwr("AbC dEf 1"), "\n")
#debug concat(strupr("AbC dEf 1"), "\n")
// expect: abc def 1
// expect: ABC DEF 1

//= substr
#debug concat(substr("ABCDEF",2,3), "\n")
#debug concat(substr("ABC",1,3), "\n")
#debug concat(substr("ABC",3,1), "\n")
#debug concat(concat("[",substr("ABC",2,0),"]"), "\n")
// expect: BCD
// expect: ABC
// expect: C
// expect: []

//= substr beyond the end
#declare A = substr("ABC",2,3);
// error: D0302 at 1:14

//= substr of a negative length
#declare A = substr("ABC",1,-1);
// error: D0302 at 1:14

//= substr from a negative place
#declare A = substr("ABC",-1,1);
// error: D0302 at 1:14

//= vstr
#debug concat(vstr(3,<1,2,3>,",",0,1), "\n")
#debug concat(vstr(2,<1,2,3>," ",0,0), "\n")
#debug concat(vstr(9,<1,2>,"; ",0,2), "\n")
#debug concat(vstr(1,<1,2,3>,",",0,1), "\n")
#debug concat(vstr(3,5,",",0,1), "\n")
#debug concat(vstr(3,<1,2,3>,"|",6,1), "\n")
#debug concat(vstr(3,<1,-2,3>,"|",-6,1), "\n")
// expect: 1.0,2.0,3.0
// expect: 1 2
// expect: 1.00; 2.00; 0.00; 0.00; 0.00
// expect: 1.0,2.0
// expect: 5.0,0.0,0.0
// expect:    1.0|   2.0|   3.0
// expect: 0001.0|-002.0|0003.0

//= a number is no string
#declare A = concat(1);
// error: D0204 at 1:21

//= concat of nothing
#declare A = concat();
// error: D0202 at 1:14

//= last digits
#debug concat(vstr(3, vnormalize(<7.31,-2.24,19.5>), ",", 0, 18), "\n")
#debug concat(vstr(3, vnormalize(<1,2,3>), ",", 0, 18), "\n")
#debug concat(vstr(3, vrotate(<7.31,-2.24,19.5>, <12.5,-73.1,141>), ",", 0, 18), "\n")
#debug concat(vstr(3, vaxis_rotate(<7.31,-2.24,19.5>, <12.5,-73.1,141>, 33.3), ",", 0, 18), "\n")
// expect: 0.349005063841176577,-0.106945464159266160,0.930998460315040188
// expect: 0.267261241912424397,0.534522483824848793,0.801783725737273190
// expect: 16.176565531019569733,-4.854644050404410827,12.387689807405678266
// expect: 2.528809156910987177,-0.581076547498989404,20.783916240542101406

//= @ of a string
#declare A = @(
"a", x);
// each: vcross vdot vrotate
// error: D0204 at 2:1

//= vnormalize of a string
#declare A = vnormalize("a");
// error: D0204 at 1:25

//= @ without arguments
#declare A = @();
// each: vcross vnormalize vrotate vaxis_rotate vturbulence trace
// error: D0202 at 1:14

//= @ as text without arguments
#declare A = @();
// each: chr datetime str strlwr strupr substr vstr
// error: D0202 at 1:14

//= @ of an unknown object
#declare A = @(Nothing);
// each: min_extent max_extent
// error: D0203 at 1:25

//= an axis of zero
#declare A = vaxis_rotate(<1,2,3>, 0, 30); #debug concat(str((A.x = 7), 0, 0), "\n")
// expect: 1

//= the format of datetime may not be too long
#declare A = datetime(0, "12345678901234567890123456789012345678901234567890123456789012345678901234567890123456789012345678901234567890123456789012345678901234567890123456789012345678901234567890123456789012345678901234567890123456789012345678901234567890");
// error: D0302 at 1:14

//= seconds are rounded
#debug concat(datetime(0.5/86400), " ", datetime(1.6/86400), " ", datetime(10000.99999999), "\n")
// expect: 2000-01-01 00:00:01Z 2000-01-01 00:00:02Z 2027-05-20 00:00:00Z

//= conversions of datetime
#debug concat(datetime(0.25, "%d %m %y %H %M %S %j %%"), "\n")
// expect: 01 01 00 06 00 00 001 %

//= datetime of now
#debug concat(str(strlen(datetime(now)), 0, 0), "\n")
// expect: 20

//= the normal of an inverse object
#declare N = <0,0,0>; #declare O = sphere { 0, 1 inverse } #declare P = trace(O, -5*z, z, N); #debug concat(vstr(3, P, ",", 0, 2), vstr(3, N, ",", 0, 2), "\n")
// expect: 0.00,0.00,-1.00-0.00,-0.00,1.00

//= the normal of a smooth triangle
#declare N = <0,0,0>; #declare O = smooth_triangle { -x-y, -z+x, 2*x-y, -z, y, -z-x } #declare P = trace(O, -5*z, z, N); #debug concat(vstr(3, P, ",", 0, 2), vstr(3, N, ",", 0, 2), "\n")
// expect: 0.00,0.00,0.00-0.15,0.00,-0.99

//= trace through transformations
#declare N = <0,0,0>; #declare O = sphere { 0, 1 scale <1,2,1> rotate 45*z translate 3*z } #declare P = trace(O, <0.5,0.5,-5>, z, N); #debug concat(vstr(3, P, ",", 0, 4), vstr(3, N, ",", 0, 4), "\n")
// expect: 0.5000,0.5000,2.29290.5000,0.5000,-0.7071

//= trace from inside
#declare O = sphere { 0, 1 } #debug concat(vstr(3, trace(O, 0, x), ",", 0, 2), vstr(3, trace(O, x, x), ",", 0, 2), "\n")
// expect: 1.00,0.00,0.000.00,0.00,0.00

//= trace in no direction
#declare O = sphere { 0, 1 } #debug concat(vstr(3, trace(O, -5*z, 0), ",", 0, 2), "\n")
// expect: 0.00,0.00,0.00

//= trace through a union of lights
#declare O = union { sphere { 0, 1 } light_source { 0, rgb 1 } } #debug concat(vstr(3, trace(O, -5*z, z), ",", 0, 2), "\n")
// expect: 0.00,0.00,-1.00

//= extents of @
#declare O = @ #debug concat(vstr(3, min_extent(O), ",", 0, 0), "\n")
// each: 'quadric { <1,1,1>, 0, 0, -1 }'
// expect: -1,-1,-1

//= codes of chr and asc
#debug concat(str(asc(chr(0)), 0, 0), str(asc(chr(65535)), 0, 0), "\n")
// expect: 065535

//= case mapping leaves others
#debug concat(strlwr("ÄB1_Z"), strupr("az19_"), "\n")
// expect:   b1_zAZ19_

//= substr from zero
#declare A = substr("ABC", 0, 1); #debug "fine\n"
// expect: fine

//= vstr of a colour with a separator
#debug concat(vstr(5, rgb 1, ";", 0, 1), "\n")
// error: D0201 at 1:23

//= vstr with five numbers
#debug concat(vstr(5, <1,2,3,4,5>, ";", 3, 0), "\n")
// expect:   1;  2;  3;  4;  5

//= a vector for a float, among arguments that are read one by one
#declare V = <1, 2, 3>;
#debug str(V #if (1) #end, 0, 0)
// error: D0204 at 2:12
