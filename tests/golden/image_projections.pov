// golden: +W96 +H72 -A; psnr >= 50; pictures around balls, tubes and rings: once, interpolated, repeated, moved
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4, 3, -10> direction z right 8*x up 6*y }
background { rgb <.1, .2, .3> }
#default { finish { ambient 1 diffuse 0 } }
#declare N = 0;
#macro Next()
  translate <mod(N, 8) + .5, div(N, 8) + .5, 0>
  #declare N = N + 1;
#end
#declare Kinds = array[4] { 0, 1, 2, 5 };
#macro Turn() rotate <25, 40, 10> scale .35 #end
#for (K, 0, 3)
  #local M = Kinds[K];
  sphere { 0, .47 pigment { image_map { png "images/colour.png" map_type M } Turn() } Next() }
  sphere { 0, .47 pigment { image_map { png "images/colour.png" map_type M once } Turn() } Next() }
  sphere { 0, .47 pigment { image_map { png "images/colour.png" map_type M once interpolate 3 } Turn() } Next() }
  sphere { 0, .47 pigment { image_map { png "images/palette.png" map_type M interpolate 4 repeat <2, 3> } Turn() } Next() }
  sphere { 0, .47 pigment { image_map { png "images/alpha.png" map_type M once offset <.3, -.2> repeat <1.5, .7> } Turn() } Next() }
  sphere { 0, .47 pigment { image_map { gif "images/colour.gif" map_type M offset <-1.3, .6> interpolate 2 } Turn() } Next() }
  sphere { 0, .47 pigment { image_pattern { png "images/grey16.png" map_type M once interpolate 2 } color_map { [0 rgb 0] [.5 rgb x] [1 rgb 1] } Turn() } Next() }
  sphere { 0, .47 pigment { image_pattern { exr "images/alpha.exr" map_type M use_alpha repeat <3, 3> } Turn() } Next() }
#end
#macro Lit() finish { ambient .2 diffuse .8 } #end
light_source { <-20, 30, -50> 1 }
#for (K, 0, 3)
  #local M = Kinds[K];
  sphere { 0, .47 pigment { rgb .8 } normal { bump_map { jpeg "images/colour.jpg" map_type M once interpolate 2 bump_size 3 } Turn() } Lit() Next() }
  sphere { 0, .47 pigment { rgb .8 } normal { bump_map { png "images/palette.png" map_type M use_index interpolate 3 bump_size .3 repeat <2, 2> offset <.2, .3> } Turn() } Lit() Next() }
  sphere {
    0, .47
    texture {
      material_map {
        png "images/palette.png" map_type M once
        texture { pigment { rgb x } } texture { pigment { checker scale .1 } } texture { pigment { rgb <1, .8, .2> } finish { phong 1 } }
      }
      Turn()
    }
    Next()
  }
  sphere { 0, .47 pigment { image_map { png "images/colour.png" map_type M interpolate 2 } warp { turbulence .1 } Turn() } Lit() Next() }
#end
