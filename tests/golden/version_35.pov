// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
// 3.5: the degree of version is asked for, and changed on the way.
#version 3.5;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 44 }
light_source { <-4, 6, -6> rgb 1 }
#if (version < 3.7) #declare Tint = rgbf <0.9, 0.3, 0.2, 0.5>; #else #declare Tint = rgb 1; #end
sphere { <-1.3, 0, 0>, 0.9 pigment { Tint } finish { ambient 0.3 } }
#version 3.7;
#if (version = 3.7) sphere { <1.1, 0, 0>, 0.9 pigment { Tint } finish { ambient 0.3 } } #end
#version 3.5;
plane { y, -0.9 pigment { checker rgb 0.8, rgb <0.3, 0.4, 0.4> } }
