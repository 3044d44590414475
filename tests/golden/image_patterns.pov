// golden: +W96 +H72 -A; psnr >= 50; pictures as patterns, inside of other patterns and of functions
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
Tile(texture { pigment { image_pattern { png "images/colour.png" } color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } } })
Tile(texture { pigment { image_pattern { png "images/grey.png" interpolate 2 } color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } } })
Tile(texture { pigment { image_pattern { png "images/grey16.png" interpolate 3 } color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } } })
Tile(texture { pigment { image_pattern { png "images/palette.png" } color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } } })
Tile(texture { pigment { image_pattern { png "images/palette.png" use_index } color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } } })
Tile(texture { pigment { image_pattern { png "images/alpha.png" use_alpha } color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } } })
Tile(texture { pigment { image_pattern { png "images/palette_alpha.png" use_alpha interpolate 2 } color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } } })
Tile(texture { pigment { image_pattern { png "images/grey.png" use_alpha } color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } } })
Tile(texture { pigment { image_pattern { png "images/grey.png" gamma 2.2 } color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } } })
Tile(texture { pigment { image_pattern { png "images/alpha.png" once offset <.3, .2> } color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } } })
Tile(texture { pigment { image_pattern { png "images/colour.png" map_type 1 repeat <3, 2> } color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } } })
Tile(texture { pigment { image_pattern { function 16, 12 { sin(x*9)*sin(y*7) } interpolate 2 } color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] } } })
Tile(texture { pigment { image_pattern { png "images/grey.png" } pigment_map { [.4 checker rgb 1 rgb 0 scale .1] [.6 rgb x] } } })
Tile(texture { pigment { image_pattern { png "images/grey.png" interpolate 2 } frequency 3 sine_wave } })
Tile(texture { pigment { pigment_pattern { image_map { png "images/colour.png" once } scale .7 translate .2 } } })
Tile(texture { pigment { average pigment_map { [1 image_map { png "images/colour.png" once } scale .7] [2 rgb <.2, .5, .9>] } } })
Tile(texture { pigment { checker pigment { image_map { png "images/palette.png" } scale .3 } pigment { rgb .5 } scale .25 } })
#declare F = function { pigment { image_map { png "images/colour.png" interpolate 2 } } }
Tile(texture { pigment { function { F(x, y, z).red * F(y, x, z).blue } } })
