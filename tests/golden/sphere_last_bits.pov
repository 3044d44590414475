// golden: +W96 +H72 -A; psnr >= 50; a pattern's border lies on the surface: the last bits of hits decide
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 1 diffuse 0 } }
camera { location <-2, 3, -3> angle 45 right x*image_width/image_height look_at 0.1*y }
#declare Rind = pigment { onion color_map { [0 rgb <1, 0.5, 0>] [0.5 rgb <0, 0.6, 0>] [0.5 rgb <0.5, 0.4, 0.2>] [1 rgb 1] } }
sphere { 0, 1 pigment { Rind } translate <-1.1, 0, 0.5> }
intersection { sphere { 0, 1 } plane { y, 0.2 } pigment { Rind } translate <1.1, 0, -0.3> }
