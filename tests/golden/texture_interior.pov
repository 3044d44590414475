// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// The inside of an open surface has its own texture.
camera { location <0, 2.4, -6> look_at 0 angle 42 }
light_source { <-4, 6, -6> rgb 1 }
#declare Warm = texture { pigment { rgb <0.9, 0.5, 0.3> } }
#declare Cold = texture { pigment { checker rgb <0.3, 0.5, 0.9>, rgb 0.9 scale 0.25 } }
cylinder { -0.8*y, 0.8*y, 0.8 open texture { Warm } interior_texture { Cold } rotate -25*x translate -1.3*x }
sphere { 0, 0.9 clipped_by { plane { <0.3, 1, -0.6>, 0.1 } } texture { Warm } interior_texture { Cold } translate 1.2*x }
plane { y, -1.1 pigment { rgb 0.7 } }
