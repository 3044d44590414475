// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// default, declared textures with changes, a child's own texture, and the texture of the whole.
camera { location <0, 1.5, -6> look_at 0 angle 44 }
light_source { <-4, 6, -6> rgb 1 }
#default { pigment { rgb <0.5, 0.6, 0.8> } finish { ambient 0.3 } }
#declare Clay = texture { pigment { rgb <0.8, 0.5, 0.3> } finish { phong 0.5 } }
sphere { <-2, 0, 0>, 0.6 }
sphere { <-0.7, 0, 0>, 0.6 texture { Clay } }
sphere { <0.6, 0, 0>, 0.6 texture { Clay pigment { rgb <0.3, 0.7, 0.4> } } }
#default { finish { ambient 0.05 diffuse 0.9 } }
union { sphere { <1.9, 0.2, 0>, 0.4 } sphere { <2, -0.4, -0.3>, 0.25 pigment { rgb <0.9, 0.9, 0.3> } } texture { Clay } }
plane { y, -0.65 }
