// Language §2.4: lengths and promotion.
#version 3.7;
global_settings { assumed_gamma 1 }

//= a float fills
#debug concat(vstr(3, vrotate(5, 0), ",", 0, 3), "\n")
#debug concat(vstr(3, vcross(2, x), ",", 0, 3), "\n")
#declare C = rgb 0.5; #declare D = rgbt 0.2; #declare E = color 0.3;
#debug concat(vstr(5, C, ",", 0, 3), "\n")
#debug concat(vstr(5, D, ",", 0, 3), "\n")
#debug concat(vstr(5, E, ",", 0, 3), "\n")
// expect: 5.000,5.000,5.000
// expect: 0.000,2.000,-2.000
// expect: 0.500,0.500,0.500,0.000,0.000
// expect: 0.200,0.200,0.200,0.000,0.200
// expect: 0.300,0.300,0.300,0.300,0.300

//= a shorter vector is padded with zeros
#debug concat(vstr(3, <1,2>+<1,2,3>, ",", 0, 3), "\n")
#debug concat(vstr(3, <1,2,3>-<1,2>, ",", 0, 3), "\n")
#debug concat(vstr(3, <1,2,3>*<2,3>, ",", 0, 3), "\n")
#debug concat(vstr(5, <1,2,3,4,5>+<1,1>, ",", 0, 3), "\n")
// expect: 2.000,4.000,3.000
// expect: 0.000,0.000,3.000
// expect: 2.000,6.000,0.000
// expect: 2.000,3.000,3.000,4.000,5.000

//= a float is repeated
#debug concat(vstr(3, 1/<1,2,4>, ",", 0, 3), "\n")
#debug concat(vstr(3, <1,2,3>*2, ",", 0, 3), "\n")
#debug concat(vstr(3, 2*<1,2,3>, ",", 0, 3), "\n")
#debug concat(vstr(3, <1,2,3>+1, ",", 0, 3), "\n")
#debug concat(vstr(3, 1-<1,2,3>, ",", 0, 3), "\n")
// expect: 1.000,0.500,0.250
// expect: 2.000,4.000,6.000
// expect: 2.000,4.000,6.000
// expect: 2.000,3.000,4.000
// expect: 0.000,-1.000,-2.000

//= products are componentwise
#debug concat(vstr(3, <1,2,3>*<4,5,6>, ",", 0, 3), "\n")
#debug concat(vstr(3, <4,10,18>/<4,5,6>, ",", 0, 3), "\n")
// expect: 4.000,10.000,18.000
// expect: 1.000,2.000,3.000

//= padding makes a division by zero
#debug concat(vstr(3, <1,2,3>/<1,2>, ",", 0, 3), "\n")
// expect: 1.000,1.000,inf

//= colours with vectors
#declare C = rgbft <.1,.2,.3,.4,.5>;
#debug concat(vstr(5, C+<1,0,0>, ",", 0, 3), "\n")
#debug concat(vstr(5, C*2, ",", 0, 3), "\n")
#debug concat(vstr(5, C*<1,2,3>, ",", 0, 3), "\n")
#debug concat(vstr(5, <1,2,3>*C, ",", 0, 3), "\n")
// expect: 1.100,0.200,0.300,0.400,0.500
// expect: 0.200,0.400,0.600,0.800,1.000
// expect: 0.100,0.400,0.900,0.000,0.000
// expect: 0.100,0.400,0.900,0.000,0.000

//= relations of vectors
#debug concat(vstr(3, (<1,2,3> < <2,2,2>), ",", 0, 3), "\n")
#debug concat(vstr(3, (<1,2,3> = <1,0,3>), ",", 0, 3), "\n")
#debug concat(vstr(3, (<1,0,3> & 1), ",", 0, 3), "\n")
#debug concat(vstr(3, (<0,0,1> | <1,0,0>), ",", 0, 3), "\n")
#debug concat(vstr(3, !<1,0,2>, ",", 0, 3), "\n")
#debug concat(vstr(3, -<1,0,2>, ",", 0, 3), "\n")
// expect: 1.000,0.000,0.000
// expect: 1.000,0.000,1.000
// expect: 1.000,0.000,1.000
// expect: 1.000,0.000,1.000
// expect: 0.000,1.000,0.000
// expect: -1.000,-0.000,-2.000

//= a vector is no condition
#if (<1,2,3> < <2,2,2>) #end
// error: D0204 at 1:5

//= a vector is no condition of ?:
#declare A = (<1,2,3> ? 1 : 2);
// error: D0204 at 1:15

//= branches may differ in length
#debug concat(vstr(3, (1 ? <1,2,3> : 4), ",", 0, 3), "\n")
#debug concat(vstr(3, vrotate((0 ? <1,2,3> : 4), 0), ",", 0, 3), "\n")
#debug concat(str((0 ? <1,2> : 4), 0, 6), "\n")
// expect: 1.000,2.000,3.000
// expect: 4.000,4.000,4.000
// expect: 4.000000

//= a vector where a float is wanted
#declare A = sin(<1,2,3>);
// error: D0204 at 1:18

//= a colour where a point is wanted
#declare C = rgb 1; sphere { C, 1 }
// error: D0204 at 1:30

//= a four-vector where a vector is wanted
#declare A = vlength(<1,2,3,4>);
// error: D0204 at 1:22

//= a uv-vector as a point
#debug concat(str(vlength(<3,4>), 0, 6), "\n")
// expect: 5.000000

//= a float stays a float where any length will do
#declare A = 5; #macro M(P) #debug concat(str(P,0,1),"\n") #end M(A) M(5+1)
#debug concat(vstr(3, 5, ",", 0, 3), "\n")
// expect: 5.0
// expect: 6.0
// expect: 5.000,0.000,0.000

//= a component keeps the other slots
#declare A = <1,2,3>;
#debug concat(str(vlength(A.y), 0, 6), "\n")
#debug concat(str(vlength(A.z), 0, 6), "\n")
#debug concat(str(vlength(A.x), 0, 6), "\n")
#debug concat(str(vlength(-A.y), 0, 6), "\n")
#debug concat(str(vlength(A.x+1), 0, 6), "\n")
#debug concat(str(vlength(A.y*2), 0, 6), "\n")
#debug concat(vstr(3, vrotate(A.y,0), ",", 0, 3), "\n")
#debug concat(vstr(3, vrotate(A.z,0), ",", 0, 3), "\n")
#debug concat(vstr(3, vrotate(A.y*1,0), ",", 0, 3), "\n")
#debug concat(vstr(3, vrotate(-A.y,0), ",", 0, 3), "\n")
#debug concat(vstr(3, vrotate(A.x+1,0), ",", 0, 3), "\n")
// expect: 4.123106
// expect: 4.690416
// expect: 3.741657
// expect: 4.123106
// expect: 4.123106
// expect: 5.385165
// expect: 2.000,2.000,3.000
// expect: 3.000,2.000,3.000
// expect: 2.000,2.000,3.000
// expect: -2.000,2.000,3.000
// expect: 2.000,2.000,3.000

//= parentheses fill
#declare A = <1,2,3>;
#debug concat(vstr(3, vrotate((A.y),0), ",", 0, 3), "\n")
#debug concat(vstr(3, vrotate(1*A.y,0), ",", 0, 3), "\n")
#debug concat(vstr(3, vrotate(2*A.z,0), ",", 0, 3), "\n")
#debug concat(vstr(3, vrotate(A.y*y,0), ",", 0, 3), "\n")
#debug concat(vstr(3, <A.y,A.y,A.y>, ",", 0, 3), "\n")
// expect: 2.000,2.000,2.000
// expect: 2.000,2.000,2.000
// expect: 6.000,6.000,6.000
// expect: 0.000,2.000,0.000
// expect: 2.000,2.000,2.000

//= a macro argument is a plain float
#declare A = <1,2,3>; #macro M(P) #debug concat(vstr(3,vrotate(P,0),",",0,1),"\n") #end M(A.y)
// expect: 2.0,2.0,2.0

//= colours fill at the end
#declare A = <1,2,3>; #declare C = rgb A.y; #declare D = rgb A.y+0.5; #declare E = color A.green;
#debug concat(vstr(5, C, ",", 0, 3), "\n")
#debug concat(vstr(5, D, ",", 0, 3), "\n")
#debug concat(vstr(5, E, ",", 0, 3), "\n")
// expect: 2.000,2.000,2.000,0.000,0.000
// expect: 2.500,2.500,2.500,0.000,0.000
// expect: 2.000,2.000,2.000,2.000,2.000

//= parentheses are read without the length wanted
#debug concat(vstr(3, vrotate((1/<1,1>),0), ",", 0, 3), "\n")
#debug concat(vstr(3, vrotate((!<1,1>),0), ",", 0, 3), "\n")
#debug concat(vstr(3, vrotate(!(<1,1>),0), ",", 0, 3), "\n")
#debug concat(vstr(3, <1,2,3>*(1/<1,2>), ",", 0, 3), "\n")
// expect: 1.000,1.000,0.000
// expect: 0.000,0.000,0.000
// expect: 0.000,0.000,1.000
// expect: 1.000,1.000,0.000

//= .x of a float
#debug concat(str((5).x, 0, 0), "\n")
#debug concat(str((5).u, 0, 0), "\n")
#debug concat(str((5).red, 0, 0), "\n")
// expect: 5
// expect: 5
// expect: 5

//= .y of a float
#declare A = (5).y;
// error: D0204 at 1:14

//= a component beyond the length
#declare A = <1,2,3>.t;
// error: D0204 at 1:14

//= names of components
#declare C = <1,2,3,4,5>;
#debug concat(str(C.x, 0, 3), "\n")
#debug concat(str(C.y, 0, 3), "\n")
#debug concat(str(C.z, 0, 3), "\n")
#debug concat(str(C.t, 0, 3), "\n")
#debug concat(str(C.u, 0, 3), "\n")
#debug concat(str(C.v, 0, 3), "\n")
#debug concat(str(C.red, 0, 3), "\n")
#debug concat(str(C.green, 0, 3), "\n")
#debug concat(str(C.blue, 0, 3), "\n")
#debug concat(str(C.filter, 0, 3), "\n")
#debug concat(str(C.transmit, 0, 3), "\n")
#debug concat(str(C.gray, 0, 3), "\n")
// expect: 1.000
// expect: 2.000
// expect: 3.000
// expect: 4.000
// expect: 1.000
// expect: 2.000
// expect: 1.000
// expect: 2.000
// expect: 3.000
// expect: 4.000
// expect: 5.000
// expect: 1.817

//= gray needs no length
#debug concat(str(<1,2>.gray, 0, 6), "\n")
#debug concat(str(<1,2,3>.gray, 0, 6), "\n")
// expect: 1.475000
// expect: 1.817000

//= grey is no component
#declare A = <1,2,3>.grey;
// error: D0203 at 1:14

//= a transformation with a component takes the other slots too
#declare A = <1,2,3>; #declare B = box { 0, 1 translate A.y } #declare C = box { 0, 1 scale A.z } #declare D = box { 0, 1 translate A.x + 1 } #declare E = box { 0, 1 translate -A.y } #declare G = box { 0, 1 translate (A.y) } #declare H = box { 0, 1 scale 2*A.z } #declare K = sphere { A.x, 1 }
#debug concat(vstr(3, min_extent(B), ",", 0, 3), "\n")
#debug concat(vstr(3, max_extent(C), ",", 0, 3), "\n")
#debug concat(vstr(3, min_extent(D), ",", 0, 3), "\n")
#debug concat(vstr(3, min_extent(E), ",", 0, 3), "\n")
#debug concat(vstr(3, min_extent(G), ",", 0, 3), "\n")
#debug concat(vstr(3, max_extent(H), ",", 0, 3), "\n")
#debug concat(vstr(3, min_extent(K), ",", 0, 3), "\n")
// expect: 2.000,2.000,3.000
// expect: 3.000,2.000,3.000
// expect: 2.000,2.000,3.000
// expect: -2.000,2.000,3.000
// expect: 2.000,2.000,2.000
// expect: 6.000,6.000,6.000
// expect: 0.000,1.000,2.000

//= component .@ of a colour
#declare C = rgbft <0.1,0.2,0.3,0.4,0.5>; #debug concat(str(C.@, 0, 5), "\n")
// each: x u red
// expect: 0.10000

//= components by all their names
#declare C = rgbft <0.1,0.2,0.3,0.4,0.5>; #debug concat(str(C.y, 0, 3), str(C.v, 0, 3), str(C.green, 0, 3), str(C.z, 0, 3), str(C.blue, 0, 3), str(C.t, 0, 3), str(C.filter, 0, 3), str(C.transmit, 0, 3), str(C.gray, 0, 5), "\n")
// expect: 0.2000.2000.2000.3000.3000.4000.4000.5000.18170

//= component .@ beyond the length
#declare A = <1,2>; #debug str(A.@, 0, 0)
// each: z blue t filter transmit
// error: D0204 at 1:32

//= .gray needs no length
#debug concat(str(<1,2>.gray, 0, 3), "\n")
// expect: 1.475

//= grey and alpha are no components
#declare A = <1,2,3>; #debug str(A.@, 0, 0)
// each: grey alpha hf color rgb
// error: D0203 at 1:34

//= a vector of two as a colour
#declare C = rgb <0.5,1>; #debug concat(vstr(5, C, ",", 0, 1), "\n")
// expect: 0.5,1.0,0.0,0.0,0.0

//= three where two are wanted
sphere_sweep { linear_spline 2, 0, 1, x, <1,2,3> }
// error: D0220 at 1:1

//= a vector is no radius
sphere { 0, <1,2,3> }
// error: D0204 at 1:13

//= lengths of #write, #declare and macro arguments
#declare A = 2; #declare B = <A,1>; #declare C = B*2; #debug concat(vstr(4, C, ",", 0, 0), "\n")
// expect: 4,2,0,0
