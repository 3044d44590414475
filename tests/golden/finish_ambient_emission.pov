// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb <1.2, 0.8, 1> }
// Light of its own: ambient follows the global ambient_light, emission does not.
camera { location <0, 1.4, -7> look_at <0, -0.1, 0> angle 40 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
sphere { <-1.92, 0, 0>, 0.442 pigment { rgb <0.9, 0.55, 0.25> } finish { ambient 0 diffuse 0.6 } }
sphere { <-0.96, 0, 0>, 0.442 pigment { rgb <0.9, 0.55, 0.25> } finish { ambient 0.5 diffuse 0.3 } }
sphere { <0, 0, 0>, 0.442 pigment { rgb <0.9, 0.55, 0.25> } finish { ambient rgb <0.1, 0.3, 0.9> diffuse 0.3 } }
sphere { <0.96, 0, 0>, 0.442 pigment { rgb <0.9, 0.55, 0.25> } finish { ambient 0 emission 0.4 diffuse 0.3 } }
sphere { <1.92, 0, 0>, 0.442 pigment { rgb <0.9, 0.55, 0.25> } finish { ambient 0 emission <0, 0.5, 0.2> diffuse 0 } }
box { <-3.5, -1, -3.5>, <3.5, -0.9, 2.5> pigment { checker rgb 0.8, rgb <0.35, 0.45, 0.4> } }
