// golden: +W96 +H72 -A; psnr >= 50; analytic surfaces, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// The sense of turning about each axis, in the left-handed frame: the small ball goes the way of the thumb.
camera { location <2.6, 2.6, -6> look_at 0 angle 36 }
light_source { <2, 6, -6> rgb 1 }
#macro Arm(Turn, Colour)
  union { cylinder { 0, <1.4, 0, 0>, 0.1 } sphere { <1.4, 0, 0>, 0.2 } rotate Turn pigment { rgb Colour } }
#end
Arm(<0, 0, 0>, <0.9, 0.2, 0.2>)
Arm(<0, 30, 0>, <0.9, 0.5, 0.2>)
Arm(<0, 0, 60>, <0.2, 0.9, 0.2>)
Arm(<0, 90, 0>, <0.2, 0.3, 0.9>)
Arm(<50, 0, 90>, <0.8, 0.8, 0.2>)
Arm(<0, -60, 30>, <0.8, 0.3, 0.8>)
plane { y, -1.3 pigment { rgb 0.7 } }
