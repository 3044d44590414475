// golden: +W96 +H24 -A; psnr >= 50; words that are written in several ways, colours with their curve
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4, 0.5, -10> direction z right 8*x up 2*y }
background { colour rgb <.1, .2, .3> }
#default { finish { ambient 1 diffuse 0 } }
#declare N = 0;
#macro Tile(T)
  box { <0.03, 0, 0>, <0.97, 1, 1> texture { T } translate N*x }
  #declare N = N + 1;
#end
Tile(texture { pigment { gradient y colour_map { [0 colour red 1] [1 colour srgb <.2, .5, 1>] } } })
Tile(texture { pigment { gradient y color_map { [0 srgbt <1, .5, .2, .4>] [1 srgbf <.3, .9, .5, .7>] } } })
Tile(texture { pigment { srgbft <.9, .6, .4, .3, .2> } })
Tile(texture { pigment { checker colour srgb <.8, .4, .1> color srgb .5 scale .25 } })
Tile(texture { pigment { srgb <.5, .5, .9> quick_colour rgb x } })
Tile(texture { material_map { png "images/palette.png" texture { pigment { rgb x } } texture { pigment { rgb y } } texture { pigment { rgb z } } texture { pigment { rgb 1 } } } })
Tile(texture { pigment { image_map { png "images/colour.png" interpolate 2 } } normal { bump_map { png "images/palette.png" use_colour bump_size 2 } } })
Tile(texture { pigment { image_map { png "images/colour.png" } } normal { bump_map { png "images/palette.png" use_color bump_size 2 } } finish { ambient .4 diffuse .6 } })
light_source { <4, 9, -20> colour rgb 1 }
