// Language §7.1: how bodies are built.
#version 3.7;
global_settings { assumed_gamma 1 }

//= positional operands, then modifiers
sphere { 0, 1 } box { -1, 1 scale 2 } cylinder { 0, y, 1 open } cone { 0, 1, y, 0 open } torus { 1, 0.2 sturm } plane { y, -1 } disc { 0, y, 1 }
#debug concat("fine", "\n")
// expect: fine

//= switch words with and without values
sphere { 0, 1 hollow } sphere { 0, 1 hollow on } sphere { 0, 1 hollow off } sphere { 0, 1 no_image no_reflection double_illuminate }
#debug concat("fine", "\n")
// expect: fine

//= no_shadow takes no value
sphere { 0, 1 no_shadow on }
// error: D0201 at 1:25

//= nested blocks
sphere { 0, 1 pigment { rgb 1 } finish { phong 1 } interior { ior 1.5 } }
#debug concat("fine", "\n")
// expect: fine

//= a name first
#declare P = pigment { rgb 1 } #declare T = texture { pigment { P } } #declare O = sphere { 0, 1 } #declare M = color_map { [0 rgb 0] [1 rgb 1] }
sphere { 0, 1 pigment { P scale 2 } } object { O texture { T finish { phong 1 } } } sphere { 0, 1 pigment { gradient x color_map { M } } }
#debug concat("fine", "\n")
// expect: fine

//= colour lists
sphere { 0, 1 pigment { checker rgb 1, rgb 0 } } sphere { 0, 1 pigment { checker rgb 1 } } sphere { 0, 1 pigment { hexagon rgb 1 rgb 0 rgb x } } sphere { 0, 1 pigment { brick rgb 1, rgb 0 } }
#debug concat("fine", "\n")
// expect: fine

//= transform by name and by block
#declare T = transform { scale 2 } sphere { 0, 1 transform T } sphere { 0, 1 transform { T translate x } }
#debug concat("fine", "\n")
// expect: fine

//= texture without braces
#declare T = texture { pigment { rgb 1 } } sphere { 0, 1 texture T }
// error: D0201 at 1:66

//= an object name at the top level
#declare O = sphere { 0, 1 } O
#debug concat("fine", "\n")
// expect: fine

//= an object name inside of a union
#declare O = sphere { 0, 1 } union { O O }
// beyond

//= a union of one
union { sphere { 0, 1 } }
#debug concat("fine", "\n")
// expect: fine

//= objects of objects
object { sphere { 0, 1 } translate x } object { union { sphere { 0, 1 } box { 0, 1 } } }
#debug concat("fine", "\n")
// expect: fine

//= an unknown setting
sphere { 0, 1 finish { difuse 0.5 } }
// error: D0214 at 1:24

//= a missing operand
sphere { 0 }
// error: D0202 at 1:12
