// Language §7.5: the top level.
#version 3.7;
global_settings { assumed_gamma 1 }

//= what may stand there
camera { location -5*z } background { rgb 0.1 } light_source { 0, rgb 1 } sky_sphere { pigment { rgb 1 } } sphere { 0, 1 } plane { y, -1 }
#debug concat("fine", "\n")
// expect: fine

//= a number
5
// error: D0201 at 1:1

//= a string
"text"
// error: D0201 at 1:1

//= a word that is no object
pigment { rgb 1 }
// error: D0201 at 1:1

//= a stray brace
}
// error: D0102 at 1:1

//= an undeclared name
Nothing
// error: D0203 at 1:1

//= an undeclared name with a body
spere { 0, 1 }
// error: D0203 at 1:1

//= two cameras
camera { location -z } camera { location -2*z }
#debug concat("fine", "\n")
// expect: fine

//= nothing
#debug concat("fine", "\n")
// expect: fine

//= block @ at the top level
@ #debug "fine\n"
// each: 'camera { location 0 }' 'global_settings { max_trace_level 3 }' 'background { rgb 1 }' 'background { color rgb 1 }' 'fog { distance 10 rgb 0.5 }' 'sky_sphere { pigment { rgb 1 } }' 'max_trace_level 5' 'max_intersections 64' 'light_group { light_source { 0, rgb 1 } sphere { 0, 1 } }' 'media { emission 0.1 }'
// expect: fine

//= @ is nothing at the top level
@
// each: 1 '"text"' 'pigment { rgb 1 }' 'finish { phong 1 }' 'texture { pigment { rgb 1 } }' 'rgb 1' 'translate x' 'color_map { [0 rgb 0] }' 'interior { ior 1 }' 'transform { scale 2 }' 'spline { 0, 1 }' 'array[1] { 1 }' 'function { x }' '>' '=' 'phong' 'bozo' 'on'
// error: D0201 at 1:1

//= directives of the oldest scenes have no sign: @
@ #debug "fine\n"
// each: 'declare A = 1;' 'include "count.inc"' 'default { pigment { rgb 1 } }'
// expect: fine

//= two of @
@ @ #debug "fine\n"
// each: 'camera { location 0 }' 'background { rgb 1 }' 'fog { distance 10 rgb 0.5 }' 'sky_sphere { pigment { rgb 1 } }'
// expect: fine
