// golden: +W96 +H72 -A; psnr >= 60; in maps, slope and aoi see the normal that the entry before has left
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.1 phong 0.4 } pigment { rgb <0.9, 0.8, 0.6> } }
camera { orthographic location -5*z right 4*x up 3*y direction z }
light_source { <-6, 8, -9> rgb 1 }
background { rgb <0.2, 0.3, 0.4> }
#declare Ball = sphere { 0, 0.6 }
#declare Steep = normal { slope <0.3, 1, 0> normal_map { [0.4 ripples 0.9 scale 0.2] [0.6 dents 0.9 scale 0.1] } }
#declare Facing = normal { aoi normal_map { [0.3 bumps 1 scale 0.1] [0.5 wrinkles 0.9 scale 0.2] } }
object { Ball normal { average normal_map { [1 bumps 0.8 scale 0.2] [1 Steep] } } translate <-1.3, 0.7, 0> }
object { Ball normal { gradient x normal_map { [0.2 bumps 0.9 scale 0.3] [0.8 Steep] } } translate <0, 0.7, 0> }
object { Ball normal { gradient x normal_map { [0.2 Steep] [0.8 dents 0.9 scale 0.2] } } translate <1.3, 0.7, 0> }
object { Ball normal { average normal_map { [2 Facing] [1 wrinkles 0.8 scale 0.2] [1 Facing] } } translate <-1.3, -0.7, 0> }
object { Ball normal { uv_mapping bumps 0.9 scale <0.1, 0.3, 0.1> no_bump_scale } translate <0, -0.7, 0> }
object { Ball normal { average normal_map { [1 Facing] [1 Steep scale 0.7] } scale 0.5 rotate 30*z } translate <1.3, -0.7, 0> }
