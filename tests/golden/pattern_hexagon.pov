// golden: +W96 +H72 -A; psnr >= 45; a pattern edge may fall on the other side of a pixel
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -4> look_at <0, 0, -0.1> angle 50 }
light_source { <-4, 7, -6> rgb 1 }
plane { y, 0 pigment { hexagon rgb <0.9, 0.5, 0.2>, rgb <0.3, 0.5, 0.7>, rgb <0.9, 0.9, 0.7> scale 0.6 rotate 10*y } }
cylinder { 0, 0.5*y, 0.9 translate <1.3, 0, 0.4> pigment { hexagon scale 0.3 } }
