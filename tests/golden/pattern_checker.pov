// golden: +W96 +H72 -A; psnr >= 45; a pattern edge may fall on the other side of a pixel
#version 3.7;
global_settings { assumed_gamma 1 }
// Default colours, given colours, and cells that go on through negative coordinates.
camera { location <0, 3, -6> look_at <0, -0.2, 0> angle 46 }
light_source { <-4, 6, -6> rgb 1 }
sphere { <-1.3, 0, 0>, 0.9 pigment { checker scale 0.41 } }
box { -0.6, 0.6 rotate 25*y translate <1.2, -0.3, 0> pigment { checker rgb <0.9, 0.8, 0.5> rgb <0.6, 0.2, 0.2> scale 0.37 translate 0.05 } }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.6> rotate 20*y scale 0.7 } }
