// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// `default` is understood without its hash sign.
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -6> rgb 1 }
default { pigment { rgb <0.4, 0.7, 0.9> } finish { ambient 0.4 } }
sphere { -0.8*x, 0.7 }
sphere { 0.8*x, 0.7 pigment { rgb <0.9, 0.6, 0.3> } }
