// Language §4.8: #default.
#version 3.7;
global_settings { assumed_gamma 1 }

//= each item once or more
#default { pigment { rgb 1 } } #default { finish { ambient 0 } normal { bumps 0.1 } } #default { texture { pigment { rgb 0.5 } finish { ambient 0.2 } } }
#debug concat("fine", "\n")
// expect: fine

//= inside of a block
union { sphere { 0, 1 } #default { pigment { rgb x } } sphere { x, 1 } }
#debug concat("fine", "\n")
// expect: fine

//= two textures: the last holds
#default { texture { pigment { rgb 1 } } texture { pigment { rgb 1 } } }
#debug concat("fine", "\n")
// expect: fine

//= something else
#default { sphere { 0, 1 } }
// error: D0201 at 1:12

//= @ as a default
#default { @ } #debug concat("fine", "\n")
// each: 'pigment { rgb 1 }' 'normal { bumps 0.5 }' 'finish { phong 1 }' 'texture { pigment { rgb 1 } finish { ambient 1 } }' 'camera { location 0 }'
// expect: fine

//= @ is no default
#default { @ }
// each: 'sphere { 0, 1 }' 'rgb 1' 'light_source { 0, rgb 1 }' 'interior { ior 1 }'
// error: D0201 at 1:12

//= the importance of radiosity is at most 1
#default { radiosity { importance 2 } }
// error: D0302 at 1:24

//= a patterned default texture
#default { texture { checker texture { pigment { rgb 1 } } texture { pigment { rgb 0 } } } }
// error: D0201 at 1:12

//= functions of pigments do not start from the default
#default { pigment { rgb 0.5 } } #declare F = function { pigment { scale 2 } } #debug concat(str(F(0,0,0).red, 0, 3), "\n")
// expect: 0.000

//= the importance of radiosity as a default
#default { radiosity { importance 0.5 } } #debug concat("fine", "\n")
// expect: fine

//= a layered default texture
#declare T = texture { pigment { rgb 1 } } texture { pigment { rgbt 1 } } #default { texture { T } }
// error: D0201 at 1:86
