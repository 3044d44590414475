// The standard includes: transforms.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "transforms.inc"

//= Shear_Trans
#debug concat(vstr(3, vtransform(<1,2,3>, Shear_Trans(x, <0.2,1,0>, z)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Shear_Trans(<1,2,3>, y, <0,1,1>)), " ", 0, 9), "\n")
// expect: 1.400000000 2.000000000 3.000000000
// expect: 1.000000000 7.000000000 6.000000000

//= Matrix_Trans
#debug concat(vstr(3, vtransform(<1,2,3>, Matrix_Trans(x, <0.5,1,0>, z, <1,2,3>)), " ", 0, 9), "\n")
// expect: 3.000000000 4.000000000 6.000000000

//= Axial_Scale_Trans
#debug concat(vstr(3, vtransform(<1,2,3>, Axial_Scale_Trans(x, 2)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Axial_Scale_Trans(<1,1,0>, 3)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Axial_Scale_Trans(-<1,2,3>, 0.5)), " ", 0, 9), "\n")
// expect: 2.000000000 2.000000000 3.000000000
// expect: 4.000000000 5.000000000 3.000000000
// expect: 0.500000000 1.000000000 1.500000000

//= Axis_Rotate_Trans
#debug concat(vstr(3, vtransform(<1,2,3>, Axis_Rotate_Trans(y, 30)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Axis_Rotate_Trans(<1,2,3>, 100)), " ", 0, 9), "\n")
// expect: 2.366025404 2.000000000 2.098076211
// expect: 1.000000000 2.000000000 3.000000000

//= Rotate_Around_Trans
#debug concat(vstr(3, vtransform(<1,2,3>, Rotate_Around_Trans(<10,20,30>, <1,0,2>)), " ", 0, 9), "\n")
// expect: 0.496583085 1.783156550 3.251768401

//= Reorient_Trans
#debug concat(vstr(3, vtransform(<1,2,3>, Reorient_Trans(x, -x)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Reorient_Trans(x, <1,1,0>)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Reorient_Trans(<1,2,3>, <3,-1,2>)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Reorient_Trans(y, y)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Reorient_Trans(y, -y)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Reorient_Trans(<1,1,1>, 2*<1,1,1>)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Reorient_Trans(2*z, -3*z)), " ", 0, 9), "\n")
// expect: -1.000000000 2.000000000 -3.000000000
// expect: -0.707106781 2.121320344 3.000000000
// expect: 3.000000000 -1.000000000 2.000000000
// expect: 1.000000000 2.000000000 3.000000000
// expect: 1.000000000 -2.000000000 -3.000000000
// expect: 1.000000000 2.000000000 3.000000000
// expect: 1.000000000 -2.000000000 -3.000000000

//= Point_At_Trans
#debug concat(vstr(3, vtransform(<1,2,3>, Point_At_Trans(<1,1,0>)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Point_At_Trans(<1,2,3>)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Point_At_Trans(-y)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Point_At_Trans(z)), " ", 0, 9), "\n")
// expect: 2.121320344 0.707106781 3.000000000
// expect: 3.425394819 1.456345672 0.381742870
// expect: -1.000000000 -2.000000000 3.000000000
// expect: -1.000000000 3.000000000 2.000000000

//= Center_Trans
#declare O = box { <1,2,3>, <3,7,8> }
#debug concat(vstr(3, vtransform(<0,0,0>, Center_Trans(O, x)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<0,0,0>, Center_Trans(O, x+y)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<0,0,0>, Center_Trans(O, <1,1,1>)), " ", 0, 9), "\n")
// expect: -2.000000000 0.000000000 0.000000000
// expect: -2.000000000 -4.500000000 0.000000000
// expect: -2.000000000 -4.500000000 -5.500000000

//= Align_Trans
#declare O = box { <1,2,3>, <3,7,8> }
#debug concat(vstr(3, vtransform(<0,0,0>, Align_Trans(O, x, <10,20,30>)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<0,0,0>, Align_Trans(O, -y, <10,20,30>)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<0,0,0>, Align_Trans(O, <1,-1,0>, <10,20,30>)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<0,0,0>, Align_Trans(O, y-z, 5)), " ", 0, 9), "\n")
// expect: 7.000000000 0.000000000 0.000000000
// expect: 0.000000000 18.000000000 0.000000000
// expect: 7.000000000 18.000000000 0.000000000
// expect: 0.000000000 -2.000000000 2.000000000

//= Spline_Trans
#declare S = spline { cubic_spline -0.5, <-1,0,0> 0, <0,0,0> 0.5, <1,0.5,1> 1, <1,1,3> 1.5, <0,1,4> }
#debug concat(vstr(3, vtransform(<1,2,3>, Spline_Trans(S, 0.25, y, 0.1, 0)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Spline_Trans(S, 0.25, y, 0.1, 0.5)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Spline_Trans(S, 0.7, y, 0.05, -2)), " ", 0, 9), "\n")
#debug concat(vstr(3, vtransform(<1,2,3>, Spline_Trans(S, 0.7, <0.1,1,0.2>, 0.05, 1)), " ", 0, 9), "\n")
// expect: 2.735555117 3.151956382 1.196055285
// expect: 2.613403110 3.214415669 1.280419040
// expect: 2.354535393 3.306657874 4.185522913
// expect: 2.282363783 3.348201283 4.176516208

//= vtransform
#debug concat(vstr(3, vtransform(<1,2,3>, transform { scale 2 translate x }), " ", 0, 9), "\n")
// expect: 3.000000000 4.000000000 6.000000000

//= vinv_transform
#debug concat(vstr(3, vinv_transform(<1,2,3>, transform { scale 2 translate x }), " ", 0, 9), "\n")
#declare T = transform { rotate <10,20,30> scale <1,2,3> }
#debug concat(vstr(3, vinv_transform(<1,2,3>, T), " ", 0, 9), "\n")
// expect: 0.000000000 1.000000000 1.500000000
// expect: 0.941623848 0.604770420 1.321967196
