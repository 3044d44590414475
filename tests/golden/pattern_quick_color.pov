// golden: +W96 +H72 -A +Q5; psnr >= 50; quick colours at quality 5
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
Tile(texture { pigment { bozo quick_color rgb <1, .5, .2> } })
Tile(texture { pigment { checker rgb 1 rgb 0 scale .2 } })
Tile(texture { pigment { image_map { png "images/colour.png" } quick_color rgb <.2, .5, .9> } })
Tile(texture { gradient x texture_map { [.3 pigment { granite quick_color rgb x }] [.7 pigment { rgb z quick_color rgb y }] } })
