// golden: +W96 +H72 -A; psnr >= 45; a pattern edge may fall on the other side of a pixel
#version 3.7;
global_settings { assumed_gamma 1 }
// The upper layers have holes; each layer has its own finish.
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <-4, 6, -6> rgb 1 }
#declare Base = texture { pigment { rgb <0.8, 0.3, 0.2> } finish { ambient 0.2 phong 0.7 phong_size 20 } }
#declare Bands = texture { pigment { gradient y color_map { [0.5 rgbt 1] [0.5 rgbt <0.9, 0.8, 0.3, 0.2>] } scale 0.4 } }
#declare Tiles = texture { pigment { checker rgbf <0.4, 0.6, 1, 0.8>, rgbt <1, 1, 1, 1> scale 0.33 } finish { diffuse 0.3 } }
sphere { 0, 1 texture { Base } texture { Bands } translate -1.2*x }
box { -0.7, 0.7 texture { Base } texture { Bands } texture { Tiles } rotate 30*y translate 1.2*x }
plane { y, -1 texture { pigment { rgb 0.8 } } texture { pigment { checker rgbt 1, rgbt <0.2, 0.3, 0.5, 0.4> } } }
