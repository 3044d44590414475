// golden: +W96 +H72 -A +Linclude; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// Found in a folder of the library path, read twice.
#include "parts.inc"
#include "parts.inc"
#for (I, -3, 3) object { Peg(1 + Readings*I/7) translate <I, -1, 0> pigment { rgb <0.9, 0.5 + I/7, 0.3> } } #end
