// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
// The same scene under the present rules instead of the old ones for filter weighed by its colour and ambient light in layers.
camera { location <0, 1.5, -6> look_at 0 angle 44 }
light_source { <-4, 6, -6> color red 1 green 1 blue 1 }
background { color red 0.3 green 0.4 blue 0.6 }
sphere { <-1.3, 0, 0>, 0.9 pigment { color rgbf <0.9, 0.3, 0.2, 0.6> } finish { ambient 0.3 phong 0.7 } }
sphere { <1.1, 0, 0>, 0.9 texture { pigment { rgb <0.4, 0.6, 0.9> } } texture { pigment { rgbf <0.2, 0.9, 0.3, 0.7> } finish { diffuse 0.8 } } }
plane { y, -0.9 pigment { checker color red 0.8 green 0.8 blue 0.8 color red 0.3 green 0.4 blue 0.4 } }
