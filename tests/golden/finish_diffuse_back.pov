// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// Lit from behind: not at all, through and through, as from before, and with highlights.
camera { location <0, 1.2, -7> look_at <0, 0, 0> angle 40 }
light_source { <-3, 4, 6> rgb 1 }
light_source { <2, 3, -6> rgb <0.3, 0.2, 0.1> }
#declare D = disc { 0, z, 0.7 }
object { D translate <-2.2, 0.5, 0> pigment { rgb <0.9, 0.6, 0.4> } finish { phong 0.6 } }
object { D translate <-0.7, 0.5, 0> pigment { rgb <0.9, 0.6, 0.4> } finish { diffuse 0.6, 0.4 phong 0.6 brilliance 2 } }
object { D translate <0.8, 0.5, 0> pigment { rgb <0.9, 0.6, 0.4> } finish { diffuse albedo 0.6, 0.4 brilliance 2 } }
object { D translate <2.3, 0.5, 0> pigment { rgb <0.9, 0.6, 0.4> } finish { specular 0.6 } double_illuminate }
box { <-3.5, -1, -3.5>, <3.5, -0.9, 2.5> pigment { checker rgb 0.8, rgb <0.35, 0.45, 0.4> } }
