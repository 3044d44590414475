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
