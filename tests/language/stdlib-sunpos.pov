// The standard includes: sunpos.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "sunpos.inc"

//= SunPos
#debug concat(vstr(3, SunPos(2000,6,21,12,2,0,51.4667,0), " ", 0, 9), "\n")
#debug concat(str(Al, 0, 9), "\n")
#debug concat(str(Az, 0, 9), "\n")
// expect: -670224.404599589 882716873.016293526 -469904748.743385375
// expect: 61.971855228
// expect: 180.081720825

//= SunPos in the south
#debug concat(vstr(3, SunPos(2013,11,3,2,30,150,-33.9,151.2), " ", 0, 9), "\n")
#debug concat(str(Al, 0, 9), "\n")
#debug concat(str(Az, 0, 9), "\n")
#debug concat(vstr(3, SolarPosition, " ", 0, 9), "\n")
// expect: 656555202.286828995 -444488163.435005724 -609397685.355201125
// expect: -26.390596262
// expect: 132.866683650
// expect: 656555202.286828995 -444488163.435005724 -609397685.355201125

//= SunPos in the evening of another day
#debug concat(vstr(3, SunPos(2020,1,1,23,30,-90,10,-100), " ", 0, 9), "\n")
#debug concat(vstr(3, SunPos(2020,12,31,0,30,90,10,100), " ", 0, 9), "\n")
// expect: -290916926.819224656 -928084959.633346200 -232434182.925893873
// expect: 265628494.877460808 -935409154.603594184 -233347843.771747649
