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
