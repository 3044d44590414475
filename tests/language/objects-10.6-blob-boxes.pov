// Boxes of the components of a blob, and of what holds them (objects §10.6).
#version 3.7;
#macro Box(B) #debug concat(vstr(3, min_extent(B), " ", 0, 4), " to ", vstr(3, max_extent(B), " ", 0, 4), "\n") #end

//= a rod whose caps are far from its middle
Box(blob { threshold .25 cylinder { -2.4*y, 2.4*y, .7, 1 } })
// expect: -2.5000 -3.1000 -2.5000 to 2.5000 3.1000 2.5000

//= a slanting rod
Box(blob { threshold .25 cylinder { <1,2,3>, <2,4,1>, .7, 1 } })
// expect: -1.2588 0.2412 -0.7588 to 4.2588 5.7588 4.7588

//= a stretched rod
Box(blob { threshold .25 cylinder { 0, y, .5, 1 scale <1,2,1> } })
// expect: -1.4142 -1.0000 -1.4142 to 1.4142 3.0000 1.4142

//= a rod that turns after it was stretched
Box(blob { threshold .25 cylinder { 0, x+2*z, .6, 1 scale <1,2,1> rotate 30*z } })
// expect: -2.6159 -2.7989 -2.0489 to 3.4819 3.2989 4.0489

//= a turned blob of a rod
Box(blob { threshold .25 cylinder { 0, x+2*z, .6, 1 } rotate 30*z })
// expect: -1.8924 -2.0755 -0.8050 to 2.7585 2.5755 2.8050

//= a ball that turns, moves and grows
Box(blob { threshold .25 sphere { x, 1, 1 rotate 30*z scale 2 translate y } })
// expect: -0.2679 0.0000 -2.0000 to 3.7321 4.0000 2.0000

//= a stretched ball
Box(blob { threshold .25 sphere { x, 1, 1 scale <1,2,1> } })
// expect: -1.0000 -2.0000 -2.0000 to 3.0000 2.0000 2.0000

//= a ball that is stretched after it turned
Box(blob { threshold .25 sphere { x, 1, 1 rotate 30*z scale <1,2,1> } })
// expect: -1.1340 -1.0000 -2.0000 to 2.8660 3.0000 2.0000

//= a ball that turns after it was stretched
Box(blob { threshold .25 sphere { x, 1, 1 scale <1,2,1> rotate 30*z } })
// expect: -1.3660 -1.7321 -2.2321 to 3.0981 2.7321 2.2321

//= a ball that a matrix turns
Box(blob { threshold .25 sphere { x, 1, 1 matrix <.8,.6,0,-.6,.8,0,0,0,1,0,0,0> } })
// expect: -0.6000 -0.8000 -1.4000 to 2.2000 2.0000 1.4000

//= a ball of a slanted space
Box(blob { threshold .25 sphere { 0, 1, 1 matrix <1,0,0,.5,1,.3,0,.2,2,0,0,0> } })
// expect: -2.3000 -2.3000 -2.3000 to 2.3000 2.3000 2.3000

//= a component that takes away
Box(blob { threshold .25 sphere { 0, 1, 1 } sphere { 5*x, 1, -1 } })
// expect: -1.0000 -1.0000 -1.0000 to 1.0000 1.0000 1.0000
