// golden: +W96 +H72 -A; psnr >= 50; how pictures lie: projections, interpolation, copies, filter and transmit
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
Tile(texture { pigment { image_map { png "images/colour.png"  } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" once } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" interpolate 2 } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" interpolate 3 } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" interpolate 4 } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" once interpolate 2 } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" map_type 1 } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" map_type 2 } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" map_type 2 once } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" map_type 5 interpolate 2 } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" filter all .6 } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" transmit all .5 } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" filter all .3 transmit all .4 } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" repeat <3, 2> } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" offset <.3, -.2> } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/colour.png" map_type 1 repeat <4, 2> interpolate 2 offset <.5, .1> } translate -.5 scale .7 rotate <20, 30, 10> translate .5 } })
Tile(texture { pigment { image_map { png "images/palette.png" interpolate 2 } } })
Tile(texture { pigment { image_map { png "images/palette.png" filter all .5 } } })
Tile(texture { pigment { image_map { png "images/palette.png" filter 1, .7 transmit 3, .8 } } })
Tile(texture { pigment { image_map { png "images/palette.png" transmit all .3 transmit 2, 1 } } })
Tile(texture { pigment { image_map { png "images/palette.png" use_index } } })
Tile(texture { pigment { image_map { png "images/alpha.png" once interpolate 3 } scale .8 translate .1 } })
Tile(texture { pigment { image_map { png "images/colour.png" } warp { turbulence .1 } scale <.5, .5, 1> } })
Tile(texture { pigment { image_map { function 8, 6 { pigment { bozo color_map { [0 rgbt <1, 0, 0, .5>] [1 rgb z] } scale .2 } } } } })
