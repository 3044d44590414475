// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// Declared objects, lights, cameras, pigments and finishes, changed on use; #undef; #local at the top.
#declare Knob = union { sphere { 0, 0.4 } cone { 0.3*y, 0.3, y, 0 } pigment { rgb <0.9, 0.5, 0.2> } }
#declare Shine = finish { phong 0.9 phong_size 25 }
#declare Sea = pigment { gradient y color_map { [0 rgb <0.1, 0.2, 0.5>] [1 rgb <0.6, 0.9, 0.9>] } }
#local Turned = object { Knob rotate 120*z }
object { Knob translate -2.5*x }
object { Knob pigment { Sea scale 1.5 } finish { Shine } }
object { Turned translate 2.5*x finish { Shine ambient 0.6 } }
#undef Knob
#ifdef (Knob) sphere { 0, 3 } #else #declare Knob = box { -0.4, 0.4 texture { pigment { Sea } finish { Shine } } } #end
object { Knob translate -1.8*y } object { Knob scale <2, 0.5, 1> translate <2, -1.8, 0> } object { Knob rotate 45*z translate <-2, -1.8, 0> }
