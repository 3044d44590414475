// The standard includes: screen.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "screen.inc"
#include "transforms.inc"
#macro Tell() #debug concat(vstr(3,CamL," ",0,6)," | ",vstr(3,CamD," ",0,6),"\n",vstr(3,CamR," ",0,6)," | ",vstr(3,CamU," ",0,6)," | ",str(Camera_Zoom,0,6)," ",str(Camera_Aspect_Ratio,0,6),"\n") #end
#macro Box(O) #debug concat(vstr(3,min_extent(O)," ",0,6)," | ",vstr(3,max_extent(O)," ",0,6),"\n") #end

//= the camera at the start
Tell()
#debug concat(vstr(3, vtransform(<1,2,3>, transform { Camera_Transform }), " ", 0, 9), "\n")
// expect: 0.000000 0.000000 0.000000 | 0.000000 0.000000 1.000000
// expect: 1.000000 0.000000 0.000000 | 0.000000 1.000000 0.000000 | 1.000000 1.000000
// expect: 1.000000000 2.000000000 3.000000000

//= Update_Camera
#declare Camera_Location = <1,2,3>; Update_Camera() Tell()
#debug concat(vstr(3, vtransform(<1,2,3>, transform { Camera_Transform }), " ", 0, 9), "\n")
// expect: 1.000000 2.000000 3.000000 | -0.333333 -0.666667 -0.666667
// expect: -0.894427 0.000000 0.447214 | -0.298142 0.745356 -0.596285 | 1.000000 1.000000
// expect: -1.490711985 1.490711985 0.254644008

//= Set_Camera_Location
Set_Camera_Location(<1,2,-5>) Tell()
// expect: 1.000000 2.000000 -5.000000 | -0.156174 -0.312348 0.937043
// expect: 0.986394 -0.000000 0.164399 | -0.051350 0.949968 0.308098 | 1.000000 1.000000

//= Set_Camera_Look_At
Set_Camera_Look_At(<1,2,5>) Tell()
// expect: 0.000000 0.000000 0.000000 | 0.182574 0.365148 0.912871
// expect: 0.980581 0.000000 -0.196116 | -0.071611 0.930949 -0.358057 | 1.000000 1.000000

//= Set_Camera_Aspect_Ratio
Set_Camera_Aspect_Ratio(2) Tell()
// expect: 0.000000 0.000000 0.000000 | 0.000000 0.000000 1.000000
// expect: 1.000000 0.000000 0.000000 | 0.000000 1.000000 0.000000 | 1.000000 2.000000

//= Set_Camera_Aspect
Set_Camera_Aspect(16, 9) Tell()
// expect: 0.000000 0.000000 0.000000 | 0.000000 0.000000 1.000000
// expect: 1.000000 0.000000 0.000000 | 0.000000 1.000000 0.000000 | 1.000000 1.777778

//= Set_Camera_Sky
Set_Camera_Sky(<1,1,0>) Tell()
// expect: 0.000000 0.000000 0.000000 | 0.000000 0.000000 1.000000
// expect: 0.707107 -0.707107 0.000000 | 0.707107 0.707107 -0.000000 | 1.000000 1.000000

//= Set_Camera_Zoom
Set_Camera_Zoom(3) Tell()
// expect: 0.000000 0.000000 0.000000 | 0.000000 0.000000 1.000000
// expect: 1.000000 0.000000 0.000000 | 0.000000 1.000000 0.000000 | 3.000000 1.000000

//= Set_Camera_Angle
Set_Camera_Angle(60) Tell()
// expect: 0.000000 0.000000 0.000000 | 0.000000 0.000000 1.000000
// expect: 1.000000 0.000000 0.000000 | 0.000000 1.000000 0.000000 | 0.866025 1.000000

//= Set_Camera
Set_Camera(<0,0,-5>, <1,0,0>, 60) Tell()
// expect: 0.000000 0.000000 -5.000000 | 0.196116 0.000000 0.980581
// expect: 0.980581 0.000000 -0.196116 | -0.000000 1.000000 0.000000 | 0.866025 1.000000

//= Reset_Camera
Set_Camera(<0,0,-5>, <1,0,0>, 60) Reset_Camera() Tell()
// expect: 0.000000 0.000000 0.000000 | 0.000000 0.000000 1.000000
// expect: 1.000000 0.000000 0.000000 | 0.000000 1.000000 0.000000 | 1.000000 1.000000

//= Screen_Object
#declare B = box { 0, <1,2,0.5> scale 0.1 }
Set_Camera_Zoom(2)
#declare O = Screen_Object(B, <0,1>, <0.02,0.03>, true, 0.1) Box(O)
#declare O = Screen_Object(B, <0.5,0.25>, <0.02,0.03>, false, 1) Box(O)
// expect: -0.048000 0.027000 0.197500 | -0.038000 0.047000 0.202500
// expect: 0.000000 -0.250000 2.000000 | 0.100000 -0.050000 2.050000

//= Screen_Plane
#declare T = texture { pigment { rgb 1 } }
Set_Camera_Zoom(2)
#declare O = Screen_Plane(T, 0.1, <0.1,0.2>, <0.5,0.4>) Box(O)
#declare O = Screen_Plane(T, 1, 0, 1) Box(O)
// expect: -0.040000 -0.030000 0.200000 | 0.000000 -0.010000 0.200000
// expect: -0.500001 -0.500001 2.000000 | 0.500001 0.500001 2.000000
