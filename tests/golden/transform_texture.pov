// golden: +W96 +H72 -A; psnr >= 45; a pattern edge may fall on the other side of a pixel
#version 3.7;
global_settings { assumed_gamma 1 }
// Transformations after a texture carry it along, those before do not; inside the pigment they move it alone.
camera { location <0, 2.5, -7> look_at 0 angle 42 }
light_source { <-4, 6, -6> rgb 1 }
#declare Squares = pigment { checker rgb <0.9, 0.3, 0.2>, rgb <0.95, 0.9, 0.7> scale 0.37 }
box { -0.7, 0.7 pigment { Squares } rotate 35*y translate <-2, 0.05, 0> }
box { -0.7, 0.7 rotate 35*y translate <0, 0.05, 0> pigment { Squares } }
box { -0.7, 0.7 rotate 35*y translate <2, 0.05, 0> pigment { Squares rotate <0, 35, 20> scale <1.6, 1, 1> translate 0.11 } }
plane { y, -0.9 pigment { rgb 0.6 } }
