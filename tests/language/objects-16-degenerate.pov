// Objects §16: shapes without a size, lists that are too short, words that do not belong.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Ask(O, From, To)
  #local N = <0, 0, 0>;
  #local P = trace(O, From, To, N);
  #debug concat(vstr(3, P, ",", 0, 2), " ", vstr(3, N + 1e-9, ",", 0, 2), "\n")
#end
#macro Say(O)
  Ask(O, <.1, .2, -5>, z)
  Ask(O, <5, .1, .2>, -x)
  Ask(O, <.1, 5, .1>, -y)
#end

//= a sphere of no radius
#declare O = sphere { 0, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a sphere of negative radius
#declare O = sphere { 0, -1 }
Say(O)
// expect: 0.10,0.20,-0.97 -0.10,-0.20,0.97
// expect: 0.97,0.10,0.20 -0.97,-0.10,-0.20
// expect: 0.10,0.99,0.10 -0.10,-0.99,-0.10

//= a sphere of a huge radius
#declare O = sphere { 0, 1e12 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a box without volume
#declare O = box { 0, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a box whose corners are swapped
#declare O = box { 1, -1 }
Say(O)
// expect: 0.10,0.20,-1.00 0.00,0.00,-1.00
// expect: 1.00,0.10,0.20 1.00,0.00,0.00
// expect: 0.10,1.00,0.10 0.00,1.00,0.00

//= a cylinder of no radius
#declare O = cylinder { -y, y, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a cylinder of negative radius
#declare O = cylinder { -y, y, -1 }
Say(O)
// expect: 0.10,0.20,-0.99 0.10,0.00,-0.99
// expect: 0.98,0.10,0.20 0.98,0.00,0.20
// expect: 0.10,1.00,0.10 0.00,1.00,0.00

//= a cylinder without length
#declare O = cylinder { y, y, 1 }
Say(O)
// before
// error: D0401 at 1:14

//= a cone without length
#declare O = cone { y, 1, y, 2 }
Say(O)
// before
// error: D0401 at 1:14

//= a cone of equal radii
#declare O = cone { -y, 1, y, 1 }
Say(O)
// expect: 0.10,0.20,-0.99 0.10,0.00,-0.99
// expect: 0.98,0.10,0.20 0.98,0.00,0.20
// expect: 0.10,1.00,0.10 0.00,1.00,0.00

//= a cone of negative radius
#declare O = cone { -y, -1, y, 1 }
Say(O)
// expect: 0.10,0.20,-0.17 0.35,-0.71,-0.61
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.10,1.00,0.10 0.00,1.00,0.00

//= a cone of no radii
#declare O = cone { -y, 0, y, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a plane without a normal
#declare O = plane { 0, 1 }
Say(O)
// error: D0401 at 1:14

//= a disc without a normal
#declare O = disc { 0, 0, 1 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a disc of no radius
#declare O = disc { 0, z, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a disc of negative radius
#declare O = disc { 0, z, -1 }
Say(O)
// expect: 0.10,0.20,0.00 0.00,0.00,1.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a disc whose hole is larger than itself
#declare O = disc { 0, z, 1, 2 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a torus of no radius
#declare O = torus { 0, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a torus of negative radius
#declare O = torus { 1, -.25 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a torus that meets itself
#declare O = torus { .5, 1 }
Say(O)
// expect: 0.10,0.20,-1.48 0.07,0.20,-0.98
// expect: 1.48,0.10,0.20 0.99,0.10,0.13
// expect: 0.10,0.93,0.10 -0.25,0.93,-0.25

//= a superellipsoid of exponent 0
#declare O = superellipsoid { <0, 0> }
Say(O)
// expect: 0.10,0.20,-1.00 0.00,0.00,-1.00
// expect: 1.00,0.10,0.20 1.00,0.00,0.00
// expect: 0.10,1.00,0.10 0.00,1.00,0.00

//= a superellipsoid of negative exponents
#declare O = superellipsoid { <-1, -1> }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a triangle without area
#declare O = triangle { 0, x, 2*x }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a triangle of one point
#declare O = triangle { 0, 0, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a smooth triangle without area
#declare O = smooth_triangle { 0, z, x, z, 2*x, z }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a smooth triangle without normals
#declare O = smooth_triangle { -1, 0, <1,-1,0>, 0, y, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a mesh of triangles without area
#declare O = mesh { triangle { 0, x, 2*x } }
Say(O)
// error: D0401 at 1:14

//= an empty mesh
#declare O = mesh { }
Say(O)
// error: D0401 at 1:14

//= a mesh2 whose faces name vertices that are not there
#declare O = mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 3> } }
Say(O)
// error: D0302 at 1:70

//= a mesh2 whose faces have no area
#declare O = mesh2 { vertex_vectors { 3, 0, x, 2*x } face_indices { 1, <0, 1, 2> } }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a mesh2 without vertices
#declare O = mesh2 { face_indices { 1, <0, 1, 2> } }
Say(O)
// error: D0202 at 1:14

//= a mesh2 with fewer items than it says
#declare O = mesh2 { vertex_vectors { 1000000000, 0, x, y } face_indices { 1, <0, 1, 2> } }
Say(O)
// error: D0202 at 1:59

//= a polygon of two points
#declare O = polygon { 2, 0, x }
Say(O)
// error: D0401 at 1:14

//= a polygon without area
#declare O = polygon { 4, 0, x, 2*x, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a polygon that is not plane
#declare O = polygon { 5, 0, x, <1,1,0>, <0,1,.5>, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a polygon that is not closed
#declare O = polygon { 3, <-1,-1>, <1,-1>, <0,1> }
Say(O)
// expect: 0.10,0.20,0.00 0.00,0.00,1.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a polygon of a billion points
#declare O = polygon { 1000000000, 0, x }
Say(O)
// error: D0202 at 1:41

//= a prism that is not closed
#declare O = prism { linear_spline -1, 1, 3, <-1,-1>, <1,-1>, <0,1> }
Say(O)
// expect: 0.10,0.20,-1.00 0.00,0.00,-1.00
// expect: 0.40,0.10,0.20 0.89,0.00,0.45
// expect: 0.10,1.00,0.10 0.00,1.00,0.00

//= a prism of a cubic spline that is not closed
#declare O = prism { cubic_spline -1, 1, 4, <-1,-1>, <1,-1>, <0,1>, <0,2> }
Say(O)
// error: D0401 at 1:14

//= a prism of no height
#declare O = prism { linear_spline 0, 0, 4, <-1,-1>, <1,-1>, <0,1>, <-1,-1> }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.10,0.00,0.10 0.00,1.00,0.00

//= a prism of no area
#declare O = prism { linear_spline -1, 1, 3, 0, 0, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a lathe of one point
#declare O = lathe { linear_spline 1, <1, 0> }
Say(O)
// error: D0401 at 1:14

//= a lathe of equal points
#declare O = lathe { linear_spline 2, <1, 0>, <1, 0> }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a sor whose heights fall
#declare O = sor { 4, <1,0>, <1,1>, <1,.5>, <1,2> }
Say(O)
// error: D0401 at 1:14

//= a sor of equal heights
#declare O = sor { 4, <1,-1>, <1,0>, <1,0>, <1,1> }
Say(O)
// error: D0401 at 1:14

//= a sor of three points
#declare O = sor { 3, <1,0>, <1,1>, <1,2> }
Say(O)
// error: D0401 at 1:14

//= a blob without components
#declare O = blob { threshold .5 }
Say(O)
// before
// error: D0401 at 1:14

//= a blob whose threshold is never reached
#declare O = blob { threshold 2 sphere { 0, 1, 1 } }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a blob of components without radius
#declare O = blob { threshold .5 sphere { 0, 0, 1 } }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a blob of a threshold of 0
#declare O = blob { threshold 0 sphere { 0, 1, 1 } }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a blob of a cylinder without length
#declare O = blob { threshold .5 cylinder { 0, 0, 1, 1 } }
Say(O)
// error: D0401 at 1:48

//= a sphere_sweep of one ball
#declare O = sphere_sweep { linear_spline 1, 0, 1 }
Say(O)
// error: D0401 at 1:14

//= a sphere_sweep of no radius
#declare O = sphere_sweep { linear_spline 2, -x, 0, x, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a sphere_sweep that stands still
#declare O = sphere_sweep { linear_spline 2, 0, 1, 0, 1 }
Say(O)
// expect: 0.10,0.20,-0.97 0.10,0.20,-0.97
// expect: 0.97,0.10,0.20 0.97,0.10,0.20
// expect: 0.10,0.99,0.10 0.10,0.99,0.10

//= a sphere_sweep without a spline
#declare O = sphere_sweep { 2, 0, 1, x, 1 }
Say(O)
// error: D0201 at 1:29

//= a sphere_sweep of three balls on a cubic spline
#declare O = sphere_sweep { cubic_spline 3, 0, 1, x, 1, y, 1 }
Say(O)
// error: D0401 at 1:14

//= a bicubic_patch of one point
#declare O = bicubic_patch { type 1 u_steps 3 v_steps 3 flatness 0 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }
Say(O)
// beyond
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a quadric without terms
#declare O = quadric { 0, 0, 0, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a quadric of a plane
#declare O = quadric { 0, 0, z, 0 }
Say(O)
// expect: 0.10,0.20,0.00 0.00,0.00,1.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a poly without terms
#declare O = poly { 2, <0,0,0,0,0,0,0,0,0,0> }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a poly of a constant
#declare O = poly { 2, <0,0,0,0,0,0,0,0,0,1> }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a poly of order 1
#declare O = poly { 1, <0,0,1,0> }
Say(O)
// error: D0302 at 1:14

//= a poly of order 36
#declare O = poly { 36, <0,0,1,0> }
Say(O)
// error: D0302 at 1:14

//= a poly of too few numbers
#declare O = poly { 2, <0,0,1,0> }
Say(O)
// error: D0202 at 1:14

//= a julia_fractal of a slice along a wrong axis
#declare O = julia_fractal { 0 slice <1,0,0,0>, 0 }
Say(O)
// error: D0401 at 1:14

//= a julia_fractal of no iterations
#declare O = julia_fractal { <-.1,.1,0,0> quaternion sqr max_iteration 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a julia_fractal of a quaternion's sine
#declare O = julia_fractal { <-.1,.1,0,0> quaternion sin }
Say(O)
// before
// error: D0401 at 1:14

//= an isosurface that is nowhere
#declare O = isosurface { function { 1 } contained_by { box { -1, 1 } } }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= an isosurface that is everywhere
#declare O = isosurface { function { -1 } contained_by { box { -1, 1 } } }
Say(O)
// expect: 0.10,0.20,-1.00 0.00,0.00,-1.00
// expect: 1.00,0.10,0.20 1.00,0.00,0.00
// expect: 0.10,1.00,0.10 0.00,1.00,0.00

//= an isosurface of negative max_gradient
#declare O = isosurface { function { z } max_gradient -1 contained_by { box { -1, 1 } } }
Say(O)
// expect: 0.10,0.20,-1.00 0.00,0.00,-1.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= an isosurface of an empty container
#declare O = isosurface { function { z } contained_by { box { 0, 0 } } }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a parametric of one point
#declare O = parametric { function { 0 }, function { 0 }, function { 0 } <0,0>, <1,1> contained_by { box { -1, 1 } } }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a parametric without a range
#declare O = parametric { function { u }, function { v }, function { 0 } <0,0>, <0,0> contained_by { box { -1, 1 } } }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a parametric of precompute 0
#declare O = parametric { function { u }, function { v }, function { 0 } <0,0>, <1,1> precompute 0 x, y, z }
Say(O)
// before
// error: D0302 at 1:87

//= a parametric of precompute 30
#declare O = parametric { function { u }, function { v }, function { 0 } <0,0>, <1,1> precompute 30 x, y, z }
Say(O)
// before
// error: D0302 at 1:87

//= an ovus of no radius
#declare O = ovus { 0, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= an ovus of negative radius
#declare O = ovus { -1, 1 }
Say(O)
// error: D0401 at 1:14

//= an ovus whose top is too large
#declare O = ovus { 1, 3 }
Say(O)
// expect: 0.10,0.20,-2.89 0.03,-0.27,-0.96
// expect: 2.85,0.10,0.20 0.95,-0.30,0.07
// expect: 0.10,4.00,0.10 0.03,1.00,0.03

//= a height_field from a missing picture
#declare O = height_field { png "nowhere.png" }
Say(O)
// before
// error: D0601 at 1:33

//= a text without letters
#declare O = text { internal 1 "" 1, 0 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a text without depth
#declare O = text { internal 1 "I" 0, 0 translate <-.1,0,0> }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a text in a missing font has letters of another one, whichever there is
#declare O = text { ttf "nowhere.ttf" "A" 1, 0 }
#declare Top = max_extent(O);
#debug concat(str(Top.x > 0.5 & Top.x < 0.9, 0, 0), str(Top.y > 0.5 & Top.y < 0.9, 0, 0), "\n")
// beyond
// expect: 11

//= an empty union
#declare O = union { }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= an empty intersection
#declare O = intersection { }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= an empty difference
#declare O = difference { }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a union of one
#declare O = union { sphere { 0, 1 } }
Say(O)
// expect: 0.10,0.20,-0.97 0.10,0.20,-0.97
// expect: 0.97,0.10,0.20 0.97,0.10,0.20
// expect: 0.10,0.99,0.10 0.10,0.99,0.10

//= a difference of one
#declare O = difference { sphere { 0, 1 } }
Say(O)
// expect: 0.10,0.20,-0.97 0.10,0.20,-0.97
// expect: 0.97,0.10,0.20 0.97,0.10,0.20
// expect: 0.10,0.99,0.10 0.10,0.99,0.10

//= a difference that leaves nothing
#declare O = difference { sphere { 0, 1 } sphere { 0, 2 } }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= a scale of zero
#declare O = sphere { 0, 1 scale <0, 1, 1> }
Say(O)
// expect: 0.10,0.20,-0.97 0.10,0.20,-0.97
// expect: 0.97,0.10,0.20 0.97,0.10,0.20
// expect: 0.10,0.99,0.10 0.10,0.99,0.10

//= a scale of all zeros
#declare O = sphere { 0, 1 scale 0 }
Say(O)
// expect: 0.10,0.20,-0.97 0.10,0.20,-0.97
// expect: 0.97,0.10,0.20 0.97,0.10,0.20
// expect: 0.10,0.99,0.10 0.10,0.99,0.10

//= a negative scale
#declare O = sphere { 0, 1 scale -2 }
Say(O)
// expect: 0.10,0.20,-1.99 0.05,0.10,-0.99
// expect: 1.99,0.10,0.20 0.99,0.05,0.10
// expect: 0.10,1.99,0.10 0.05,1.00,0.05

//= a matrix with a column of zeros
#declare O = sphere { 0, 1 matrix <0,0,0, 0,1,0, 0,0,1, 0,0,0> }
Say(O)
// expect: 0.10,0.20,-0.97 0.10,0.20,-0.97
// expect: 0.97,0.10,0.20 0.97,0.10,0.20
// expect: 0.10,0.99,0.10 0.10,0.99,0.10

//= a singular matrix
#declare O = sphere { 0, 1 matrix <1,1,0, 1,1,0, 0,0,1, 0,0,0> }
Say(O)
// before
// error: D0401 at 1:28

//= a tiny scale
#declare O = sphere { 0, 1 scale 1e-9 }
Say(O)
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00
// expect: 0.00,0.00,0.00 0.00,0.00,0.00

//= sturm where it means nothing
#declare O = sphere { 0, 1 sturm }
Say(O)
// error: D0214 at 1:28

//= hierarchy where it means nothing
#declare O = sphere { 0, 1 hierarchy }
Say(O)
// error: D0214 at 1:28

//= split_union of an intersection
#declare O = intersection { sphere { 0, 1 } sphere { 0, 1 } split_union off }
Say(O)
// error: D0214 at 1:61

//= a textured clip
#declare O = sphere { 0, 1 clipped_by { sphere { 0, 1 pigment { rgb 1 } } } }
Say(O)
// error: D0402 at 1:41

//= a clip that is a patch
#declare O = sphere { 0, 1 clipped_by { triangle { 0, x, y } } }
Say(O)
// error: D0402 at 1:41

//= a bound that is a patch
#declare O = union { sphere { 0, 1 } sphere { 0, 1 } bounded_by { triangle { 0, x, y } } }
Say(O)
// error: D0402 at 1:67

//= an interior_texture without a texture
#declare O = sphere { 0, 1 interior_texture { pigment { rgb 1 } } }
Say(O)
// error: D0402 at 1:14

//= a clip list that is borrowed twice
#declare O = union { sphere { 0, 1 } sphere { 0, 1 } clipped_by { sphere { 0, 1 } } bounded_by { sphere { 0, 1 } } bounded_by { clipped_by } }
Say(O)
// error: D0402 at 1:140
