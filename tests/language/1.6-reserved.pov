// Language §1.6: reserved words.
#version 3.7;
global_settings { assumed_gamma 1 }

//= reserved words are not defined names
#if (defined(abs)) #debug "abs\n" #end
#if (defined(acos)) #debug "acos\n" #end
#if (defined(append)) #debug "append\n" #end
#if (defined(array)) #debug "array\n" #end
#if (defined(asc)) #debug "asc\n" #end
#if (defined(atan2)) #debug "atan2\n" #end
#if (defined(background)) #debug "background\n" #end
#if (defined(bicubic_patch)) #debug "bicubic_patch\n" #end
#if (defined(bozo)) #debug "bozo\n" #end
#if (defined(break)) #debug "break\n" #end
#if (defined(brick)) #debug "brick\n" #end
#if (defined(camera)) #debug "camera\n" #end
#if (defined(case)) #debug "case\n" #end
#if (defined(clock)) #debug "clock\n" #end
#if (defined(clock_on)) #debug "clock_on\n" #end
#if (defined(cone)) #debug "cone\n" #end
#if (defined(concat)) #debug "concat\n" #end
#if (defined(cos)) #debug "cos\n" #end
#if (defined(cubic)) #debug "cubic\n" #end
#if (defined(debug)) #debug "debug\n" #end
#if (defined(declare)) #debug "declare\n" #end
#if (defined(default)) #debug "default\n" #end
#if (defined(defined)) #debug "defined\n" #end
#if (defined(density)) #debug "density\n" #end
#if (defined(difference)) #debug "difference\n" #end
#if (defined(dimension_size)) #debug "dimension_size\n" #end
#if (defined(disc)) #debug "disc\n" #end
#if (defined(else)) #debug "else\n" #end
#if (defined(end)) #debug "end\n" #end
#if (defined(error)) #debug "error\n" #end
#if (defined(exp)) #debug "exp\n" #end
#if (defined(false)) #debug "false\n" #end
#if (defined(fclose)) #debug "fclose\n" #end
#if (defined(filter)) #debug "filter\n" #end
#if (defined(finish)) #debug "finish\n" #end
#if (defined(fog)) #debug "fog\n" #end
#if (defined(for)) #debug "for\n" #end
#if (defined(function)) #debug "function\n" #end
#if (defined(gamma)) #debug "gamma\n" #end
#if (defined(global_settings)) #debug "global_settings\n" #end
#if (defined(gradient)) #debug "gradient\n" #end
#if (defined(gray)) #debug "gray\n" #end
#if (defined(height_field)) #debug "height_field\n" #end
#if (defined(ifdef)) #debug "ifdef\n" #end
#if (defined(include)) #debug "include\n" #end
#if (defined(inside)) #debug "inside\n" #end
#if (defined(interior)) #debug "interior\n" #end
#if (defined(isosurface)) #debug "isosurface\n" #end
#if (defined(julia_fractal)) #debug "julia_fractal\n" #end
#if (defined(lathe)) #debug "lathe\n" #end
#if (defined(light_source)) #debug "light_source\n" #end
#if (defined(local)) #debug "local\n" #end
#if (defined(looks_like)) #debug "looks_like\n" #end
#if (defined(macro)) #debug "macro\n" #end
#if (defined(marble)) #debug "marble\n" #end
#if (defined(material)) #debug "material\n" #end
#if (defined(max)) #debug "max\n" #end
#if (defined(media)) #debug "media\n" #end
#if (defined(mesh)) #debug "mesh\n" #end
#if (defined(mesh2)) #debug "mesh2\n" #end
#if (defined(min)) #debug "min\n" #end
#if (defined(mod)) #debug "mod\n" #end
#if (defined(natural_spline)) #debug "natural_spline\n" #end
#if (defined(no)) #debug "no\n" #end
#if (defined(normal)) #debug "normal\n" #end
#if (defined(now)) #debug "now\n" #end
#if (defined(object)) #debug "object\n" #end
#if (defined(off)) #debug "off\n" #end
#if (defined(on)) #debug "on\n" #end
#if (defined(once)) #debug "once\n" #end
#if (defined(pattern)) #debug "pattern\n" #end
#if (defined(photons)) #debug "photons\n" #end
#if (defined(pi)) #debug "pi\n" #end
#if (defined(pigment)) #debug "pigment\n" #end
#if (defined(plane)) #debug "plane\n" #end
#if (defined(polygon)) #debug "polygon\n" #end
#if (defined(precompute)) #debug "precompute\n" #end
#if (defined(prism)) #debug "prism\n" #end
#if (defined(quadric)) #debug "quadric\n" #end
#if (defined(radiosity)) #debug "radiosity\n" #end
#if (defined(rainbow)) #debug "rainbow\n" #end
#if (defined(rand)) #debug "rand\n" #end
#if (defined(range)) #debug "range\n" #end
#if (defined(red)) #debug "red\n" #end
#if (defined(render)) #debug "render\n" #end
#if (defined(rgb)) #debug "rgb\n" #end
#if (defined(rgbft)) #debug "rgbft\n" #end
#if (defined(rotate)) #debug "rotate\n" #end
#if (defined(scale)) #debug "scale\n" #end
#if (defined(seed)) #debug "seed\n" #end
#if (defined(select)) #debug "select\n" #end
#if (defined(sin)) #debug "sin\n" #end
#if (defined(sky_sphere)) #debug "sky_sphere\n" #end
#if (defined(slope_map)) #debug "slope_map\n" #end
#if (defined(sor)) #debug "sor\n" #end
#if (defined(sphere)) #debug "sphere\n" #end
#if (defined(spline)) #debug "spline\n" #end
#if (defined(sqr)) #debug "sqr\n" #end
#if (defined(srgb)) #debug "srgb\n" #end
#if (defined(statistics)) #debug "statistics\n" #end
#if (defined(str)) #debug "str\n" #end
#if (defined(strlen)) #debug "strlen\n" #end
#if (defined(sum)) #debug "sum\n" #end
#if (defined(superellipsoid)) #debug "superellipsoid\n" #end
#if (defined(switch)) #debug "switch\n" #end
#if (defined(t)) #debug "t\n" #end
#if (defined(text)) #debug "text\n" #end
#if (defined(texture)) #debug "texture\n" #end
#if (defined(torus)) #debug "torus\n" #end
#if (defined(transform)) #debug "transform\n" #end
#if (defined(translate)) #debug "translate\n" #end
#if (defined(triangle)) #debug "triangle\n" #end
#if (defined(true)) #debug "true\n" #end
#if (defined(turbulence)) #debug "turbulence\n" #end
#if (defined(u)) #debug "u\n" #end
#if (defined(undef)) #debug "undef\n" #end
#if (defined(union)) #debug "union\n" #end
#if (defined(uv_mapping)) #debug "uv_mapping\n" #end
#if (defined(v)) #debug "v\n" #end
#if (defined(val)) #debug "val\n" #end
#if (defined(vdot)) #debug "vdot\n" #end
#if (defined(version)) #debug "version\n" #end
#if (defined(vstr)) #debug "vstr\n" #end
#if (defined(warning)) #debug "warning\n" #end
#if (defined(waves)) #debug "waves\n" #end
#if (defined(while)) #debug "while\n" #end
#if (defined(write)) #debug "write\n" #end
#if (defined(x)) #debug "x\n" #end
#if (defined(y)) #debug "y\n" #end
#if (defined(yes)) #debug "yes\n" #end
#if (defined(z)) #debug "z\n" #end
#debug concat("none", "\n")
// expect: none

//= predefined variables are ordinary names
#debug concat(str(defined(image_width), 0, 0), "\n")
#debug concat(str(defined(image_height), 0, 0), "\n")
#debug concat(str(defined(input_file_name), 0, 0), "\n")
#debug concat(str(defined(frame_number), 0, 0), "\n")
#debug concat(str(defined(initial_frame), 0, 0), "\n")
#debug concat(str(defined(final_frame), 0, 0), "\n")
#debug concat(str(defined(initial_clock), 0, 0), "\n")
#debug concat(str(defined(final_clock), 0, 0), "\n")
#debug concat(str(defined(clock_delta), 0, 0), "\n")
// expect: 1
// expect: 1
// expect: 1
// expect: 1
// expect: 1
// expect: 1
// expect: 1
// expect: 1
// expect: 1

//= they can be declared anew
#declare image_width = 5; #declare frame_number = "x";
#debug concat(str(image_width, 0, 0), "\n")
#debug concat(frame_number, "\n")
// expect: 5
// expect: x

//= they can be removed
#undef image_width
#debug concat(str(defined(image_width), 0, 0), "\n")
// expect: 0

//= tau and grey are free names in 3.7
#declare tau = 6.28; #declare grey = 0.5; #declare mixed = 1; #declare global = 2; #declare optional = 3; #declare dictionary = 4;
#debug concat(str(tau, 0, 2), "\n")
#debug concat(str(grey, 0, 2), "\n")
#debug concat(str(mixed, 0, 2), "\n")
#debug concat(str(global, 0, 2), "\n")
#debug concat(str(optional, 0, 2), "\n")
#debug concat(str(dictionary, 0, 2), "\n")
// expect: 6.28
// expect: 0.50
// expect: 1.00
// expect: 2.00
// expect: 3.00
// expect: 4.00

//= sqr is reserved but no function
#declare A = sqr(3);
// error: D0201 at 1:14

//= cube is reserved but no function
#declare A = cube(3);
// error: D0201 at 1:14

//= obsolete reserved words
#declare tile2 = 1;
// error: D0101 at 1:10
