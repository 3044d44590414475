// golden: +W96 +H72 -A; psnr >= 50; a picture in every format, and the curves of each
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <3, 2, -10> direction z right 6*x up 4*y }
background { rgb <.1, .2, .3> }
#declare N = 0;
#default { finish { ambient 1 diffuse 0 } }
#macro Tile(T)
  box {
    <0.02, 0.02, 0>, <0.98, 0.98, 1>
    texture { T }
    translate <mod(N, 6), div(N, 6), 0>
  }
  #declare N = N + 1;
#end
Tile(texture { pigment { image_map { png "images/colour.png" } } })
Tile(texture { pigment { image_map { png "images/alpha.png" } } })
Tile(texture { pigment { image_map { png "images/grey.png" } } })
Tile(texture { pigment { image_map { png "images/grey16.png" } } })
Tile(texture { pigment { image_map { png "images/palette.png" } } })
Tile(texture { pigment { image_map { png "images/palette_alpha.png" } } })
Tile(texture { pigment { image_map { png "images/gamma.png" } } })
Tile(texture { pigment { image_map { png "images/srgb.png" } } })
Tile(texture { pigment { image_map { gif "images/colour.gif" } } })
Tile(texture { pigment { image_map { jpeg "images/colour.jpg" } } })
Tile(texture { pigment { image_map { tga "images/colour.tga" } } })
Tile(texture { pigment { image_map { tga "images/alpha.tga" } } })
Tile(texture { pigment { image_map { bmp "images/colour.bmp" } } })
Tile(texture { pigment { image_map { ppm "images/colour.ppm" } } })
Tile(texture { pigment { image_map { pgm "images/grey.pgm" } } })
Tile(texture { pigment { image_map { tiff "images/alpha.tif" } } })
Tile(texture { pigment { image_map { hdr "images/colour.hdr" } } })
Tile(texture { pigment { image_map { exr "images/alpha.exr" } } })
Tile(texture { pigment { image_map { png "images/colour.png" gamma 1 } } })
Tile(texture { pigment { image_map { png "images/colour.png" gamma 2.2 } } })
Tile(texture { pigment { image_map { ppm "images/colour.ppm" gamma srgb } } })
Tile(texture { pigment { image_map { "images/colour.png" } } })
Tile(texture { pigment { image_map { png "images/alpha.png" premultiplied on } } })
Tile(texture { pigment { image_map { exr "images/alpha.exr" premultiplied off } } })
