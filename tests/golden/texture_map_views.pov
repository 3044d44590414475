// golden: +W96 +H72 -A; psnr >= 60; in mixed textures, slope and aoi see the normal that the entry before has left
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.2 phong 0.3 } }
camera { orthographic location -5*z right 4*x up 3*y direction z }
light_source { <-6, 8, -9> rgb 1 }
background { rgb <0.2, 0.3, 0.4> }
#declare Ball = sphere { 0, 0.6 }
#declare Bumpy = texture { pigment { rgb <0.9, 0.6, 0.3> } normal { bumps 0.7 scale 0.15 } }
#declare Steep = texture { pigment { slope <0.3, 1, 0> color_map { [0.3 rgb <0.2, 0.5, 0.1>] [0.7 rgb 1] } } }
#declare Facing = texture { aoi texture_map { [0.2 pigment { rgb x }] [0.5 Bumpy] } }
object { Ball texture { average texture_map { [1 Bumpy] [1 Steep] } } translate <-1.3, 0.7, 0> }
object { Ball texture { gradient x texture_map { [0.2 Bumpy] [0.8 Steep] } scale 1.3 translate 0.4*x } translate <0, 0.7, 0> }
object { Ball texture { gradient x texture_map { [0.2 Steep] [0.8 Bumpy] } scale 1.3 translate 0.4*x } translate <1.3, 0.7, 0> }
object { Ball texture { average texture_map { [1 Bumpy] [2 Facing] [1 Steep] } } translate <-1.3, -0.7, 0> }
object { Ball texture { onion texture_map { [0.2 Facing] [0.9 Bumpy] } scale 0.4 } translate <0, -0.7, 0> }
object { Ball texture { checker texture { Steep }, texture { Bumpy } scale 0.3 } translate <1.3, -0.7, 0> }
